#include "detection/Severity.h"

#include <array>
#include <optional>

#include "core/Errors.h"
#include "text/Numbers.h"

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

void takeLimit(const char* what, const std::string& text, double& length, double& depth) {
  if (text.empty()) return;
  const auto cross = text.find('x');
  const auto first = text::numberIn(text.substr(0, cross), '.');
  const auto second = cross == std::string::npos ? std::nullopt : text::numberIn(text.substr(cross + 1), '.');
  if (!first || !second || !(*first > 0) || !(*second > 0))
    throw CaseError({{what, text, "LENGTHxDEPTH in mm, both above 0, as in 35x0.10", ""}});
  length = 1e-3 * *first, depth = 1e-3 * *second;
}

}  // namespace

SeverityLimits severityLimitsFromText(const std::string& light, const std::string& moderate) {
  SeverityLimits limits;
  takeLimit("--light", light, limits.lightLength, limits.lightDepth);
  takeLimit("--moderate", moderate, limits.moderateLength, limits.moderateDepth);
  if (limits.moderateLength < limits.lightLength || limits.moderateDepth < limits.lightDepth)
    throw CaseError(
        {{"--moderate", moderate.empty() ? "60x0.25" : moderate, "at least as long and as deep as --light", ""}});
  return limits;
}

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
