// solver/detection/Severity.h - how severe a squat is, by its length and depth: a convention of this program, in one
// place. The classes A, B and C of the paper are pictures.
#pragma once

#include <string>

namespace squat::detection {

enum class Kind { squat, joint, weld, corrugation, flat, other };
enum class Severity { light, moderate, severe };

// Largest length and depth [m] of a light and of a moderate squat; beyond, it is severe.
struct SeverityLimits {
  double lightLength = 0.035, lightDepth = 0.10e-3;
  double moderateLength = 0.060, moderateDepth = 0.25e-3;
};

// "LENGTHxDEPTH" of each in mm, as in 35x0.10; empty: by convention. Throws CaseError.
SeverityLimits severityLimitsFromText(const std::string& light, const std::string& moderate);

Severity severityOf(double length, double depth, const SeverityLimits& limits = {});

std::string toText(Kind kind);
std::string toText(Severity severity);
// Throw CaseError with the known names.
Kind kindFromText(const std::string& text);
Severity severityFromText(const std::string& text);

}  // namespace squat::detection
