#include "detection/Severity.h"

#include <array>

#include "core/Errors.h"

namespace squat::detection {
namespace {

constexpr std::array kindNames{"squat", "joint", "weld", "corrugation", "flat", "other"};
constexpr std::array severityNames{"light", "moderate", "severe"};

template <std::size_t n>
std::size_t indexOf(const std::array<const char*, n>& known, const char* what, const std::string& text) {
  for (std::size_t i = 0; i < n; ++i)
    if (text == known[i]) return i;
  std::string names;
  for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
  throw CaseError({{what, text, "one of " + names, ""}});
}

}  // namespace

Severity severityOf(double length, double depth, const SeverityLimits& limits) {
  if (length <= limits.lightLength && depth <= limits.lightDepth) return Severity::light;
  if (length <= limits.moderateLength && depth <= limits.moderateDepth) return Severity::moderate;
  return Severity::severe;
}

std::string toText(Kind kind) { return kindNames[static_cast<std::size_t>(kind)]; }
std::string toText(Severity severity) { return severityNames[static_cast<std::size_t>(severity)]; }

Kind kindFromText(const std::string& text) { return static_cast<Kind>(indexOf(kindNames, "kind", text)); }
Severity severityFromText(const std::string& text) {
  return static_cast<Severity>(indexOf(severityNames, "severity", text));
}

}  // namespace squat::detection
