#include "analysis/OptionText.h"

#include <optional>

#include "core/Errors.h"
#include "readers/ColumnRoles.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::analysis {
namespace {

[[noreturn]] void refuse(const char* key, const std::string& text, const char* allowed) {
  throw CaseError({{key, "'" + text + "'", allowed, "Correct the option"}});
}

}  // namespace

signals::Band bandFromText(const std::string& text) {
  constexpr const char* allowed = "two rising frequencies in Hz, for example 130-320 or name=130-320";
  const std::size_t equals = text.find('=');
  const std::string range = equals == std::string::npos ? text : text.substr(equals + 1);
  const std::size_t dash = range.find_first_of("-:");
  if (dash == std::string::npos) refuse("--band", text, allowed);
  const auto low = text::numberIn(range.substr(0, dash), '.'), high = text::numberIn(range.substr(dash + 1), '.');
  if (!low || !high || !(*low > 0) || !(*high > *low)) refuse("--band", text, allowed);
  signals::Band band{equals == std::string::npos ? range + " Hz" : text.substr(0, equals), *low, *high};
  return band;
}

char delimiterFromText(const std::string& text) {
  if (text.empty() || text == "auto") return 0;
  if (text == "tab" || text == "\\t") return '\t';
  if (text == "space" || text == "blank") return ' ';
  if (text == "comma") return ',';
  if (text == "semicolon") return ';';
  if (text.size() != 1) refuse("--delimiter", text, "one character, or auto, comma, semicolon, tab, space");
  return text[0];
}

double chainageFromText(const std::string& text) {
  constexpr const char* allowed = "a number in m, or with a unit (12.345 km), or kilometres and metres (12+345)";
  if (const auto metres = text::kilometresAndMetresIn(text, '.')) return *metres;
  const std::size_t end = text.find_last_of("0123456789.") + 1;
  const auto value = text::numberIn(text.substr(0, end), '.');
  const std::string unit = text::bareUnit(std::string_view(text).substr(end));
  if (!value || (!unit.empty() && !text::isUnit(unit))) refuse("--chainage", text, allowed);
  if (unit.empty()) return *value;
  const auto scale = readers::scaleOf(unit, "", readers::Role::position);
  if (scale.unit != "m") refuse("--chainage", text, allowed);
  return *value * scale.factor;
}

double speedFromText(const std::string& text) {
  constexpr const char* allowed = "a positive number in m/s, or with a unit, for example 108 km/h";
  const std::size_t end = text.find_last_of("0123456789.") + 1;  // of the number: no unit of speed has a digit
  const auto value = text::numberIn(text.substr(0, end), '.');
  if (!value || !(*value > 0)) refuse("--speed", text, allowed);
  const std::string unit = text::bareUnit(std::string_view(text).substr(end));
  if (unit.empty()) return *value;
  const auto scale = readers::scaleOf(unit, "", readers::Role::speed);
  if (scale.unit != "m/s" || !text::isUnit(unit)) refuse("--speed", text, allowed);
  return *value * scale.factor;
}

std::pair<std::string, std::string> columnUnitFromText(const std::string& text) {
  const std::size_t at = text.rfind('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    refuse("--unit", text, "COLUMN=UNIT, for example aba=g");
  return {text.substr(0, at), text.substr(at + 1)};
}

void setWindow(signals::PowerSpectrumOptions& options, const std::string& text) {
  try {
    options.window = signals::windowFromText(text);
  } catch (const signals::SignalError&) {
    refuse("--window", text, "boxcar, hann, hamming or blackman");
  }
}

void setDetrend(signals::PowerSpectrumOptions& options, const std::string& text) {
  try {
    options.detrend = signals::detrendFromText(text);
  } catch (const signals::SignalError&) {
    refuse("--detrend", text, "none, constant or linear");
  }
}

}  // namespace squat::analysis
