// solver/case/ForceCurveText.h - force against compression as text, "[[0, 0], [0.2, 40]]" in mm and kN.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// Nothing where the text is anything else than pairs of numbers.
std::optional<std::vector<ForcePoint>> parseForceCurve(std::string_view text);
std::string formatForceCurve(const std::vector<ForcePoint>& curve);

// What is wrong with a curve: a single point, one that does not ascend or rise, absurd values. Empty: nothing. No
// points at all are no mistake here.
std::string forceCurveMistake(const std::vector<ForcePoint>& curve);

}  // namespace squat::cases
