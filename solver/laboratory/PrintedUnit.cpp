#include "laboratory/PrintedUnit.h"

#include <cctype>

namespace squat::laboratory {

std::string printedUnit(const std::string& unit) {
  if (unit == "us") return "µs";
  if (unit == "um") return "µm";
  std::string printed;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool power =
        unit[i] == '2' && i > 0 && (unit[i - 1] == ')' || std::isalpha(static_cast<unsigned char>(unit[i - 1])));
    printed += power ? std::string("²") : std::string(1, unit[i]);
  }
  return printed;
}

std::string withPrintedUnit(const std::string& nameWithUnit) {
  const std::size_t open = nameWithUnit.rfind('['), close = nameWithUnit.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return nameWithUnit;
  return nameWithUnit.substr(0, open + 1) + printedUnit(nameWithUnit.substr(open + 1, close - open - 1)) +
         nameWithUnit.substr(close);
}

}  // namespace squat::laboratory
