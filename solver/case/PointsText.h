// solver/case/PointsText.h - sampled profiles as text, "[[0, -0.1], [5, 0]]".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

inline constexpr std::size_t mostPoints = 100000;  // of a profile

// Numbers times 10^powerOfTen; nothing where the text is anything else. Exact as DecimalNumber.h.
std::optional<std::vector<ProfilePoint>> parsePoints(std::string_view text, int powerOfTen);
std::string formatPoints(const std::vector<ProfilePoint>& points, int powerOfTen);

// What is wrong with a profile: a single point, positions not ascending, absurd values. Empty: nothing. No points at
// all are no mistake here.
std::string pointsMistake(const std::vector<ProfilePoint>& points);

}  // namespace squat::cases
