#include "commands/NumberRange.h"

#include <sstream>

namespace squat::commands {

namespace {

template <typename Number>
std::string rangeText(Number low, Number high) {
  std::ostringstream text;
  text << low << " to " << high;
  return text.str();
}

}  // namespace

CLI::Validator between(double low, double high) {
  const auto range = rangeText(low, high);
  return {[=](std::string& input) {
            double value = 0;
            const bool within = CLI::detail::lexical_cast(input, value) && value >= low && value <= high;
            return within ? std::string() : "'" + input + "' is not a number from " + range;
          },
          range};
}

CLI::Validator zeroOrBetween(long low, long high) {
  const auto range = rangeText(low, high);
  return {[=](std::string& input) {
            long value = 0;
            const bool within =
                CLI::detail::lexical_cast(input, value) && (value == 0 || (value >= low && value <= high));
            return within ? std::string() : "'" + input + "' is neither 0 nor a whole number from " + range;
          },
          range};
}

}  // namespace squat::commands
