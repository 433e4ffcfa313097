// solver/case/PointsText.h - sampled profiles as text, "[[0, -0.1], [5, 0]]".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

inline constexpr std::size_t maximumPoints = 80000;  // of a profile; a case that holds it stays below 4 MB

// Numbers times 10^powerOfTen; nothing where the text is anything else. Exact as DecimalNumber.h.
std::optional<std::vector<ProfilePoint>> parsePoints(std::string_view text, int powerOfTen);
// The same for pairs whose second number has a unit of its own.
std::optional<std::vector<ProfilePoint>> parsePoints(std::string_view text, int powerOfTen, int secondPowerOfTen);
std::string formatPoints(const std::vector<ProfilePoint>& points, int powerOfTen);

inline constexpr std::size_t maximumLines = 64;  // of profiles side by side

// Several profiles side by side, "[[-10, [[0, -0.1], [5, 0]]], [10, [[0, -0.2], [5, 0]]]]".
std::optional<std::vector<ProfileLine>> parseLines(std::string_view text, int powerOfTen);
std::string formatLines(const std::vector<ProfileLine>& lines, int powerOfTen);
// What is wrong with them: one line alone, lateral positions not ascending or off the crown, a mistake in a profile.
std::string linesMistake(const std::vector<ProfileLine>& lines);

// What is wrong with a profile: a single point, positions not ascending, absurd values. Empty: nothing. No points at
// all are no mistake here.
std::string pointsMistake(const std::vector<ProfilePoint>& points);

}  // namespace squat::cases
