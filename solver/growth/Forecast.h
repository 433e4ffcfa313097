// solver/growth/Forecast.h - what growths under uncertain inputs say together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "growth/Grow.h"

namespace squat::growth {

// [kg] at which growths are compared: none, and twenty equal steps up to `tonnage`.
std::vector<double> forecastTonnages(double tonnage);

// [m] depth of the dip at each, linear between the stages; NaN behind the last. Where the rail was ground, that after
// it.
std::vector<double> depthsAt(const Growth& growth, const std::vector<double>& tonnages);

struct Forecast {
  std::vector<double> tonnage;                  // [kg]
  std::vector<double> lowest, median, highest;  // [m] depth of the dip; NaN where no growth has one
  std::size_t growths = 0;
  std::optional<double> limit;   // [m] of depth that was asked for
  std::vector<double> passedAt;  // [kg] at which growths pass it, ascending; fewer than growths where not all do
};

// `depths` of each growth at `tonnage`.
Forecast forecastFrom(const std::vector<double>& tonnage, const std::vector<std::vector<double>>& depths,
                      std::optional<double> limit);

std::string forecastTable(const Forecast& forecast);  // CSV
std::string forecastText(const Forecast& forecast);   // for people

}  // namespace squat::growth
