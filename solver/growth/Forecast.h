// solver/growth/Forecast.h - what growths under uncertain inputs say together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "growth/Grow.h"

namespace squat::growth {

// A moment at which growths are compared.
struct ForecastPoint {
  double tonnage = 0;       // [kg]
  bool toBeGround = false;  // just before the rail is ground
};
// None, twenty equal steps up to the end, and the moments before each grinding.
std::vector<ForecastPoint> forecastPoints(const GrowthOptions& options);

// [m] depth of the dip at each, linear between the stages; NaN after the last.
std::vector<double> depthsAt(const Growth& growth, const std::vector<ForecastPoint>& points);

// [kg] at which the dip is first as deep as `limit` [m], linear between the stages; nothing where it never is.
std::optional<double> firstPassage(const Growth& growth, double limit);

struct Forecast {
  std::vector<ForecastPoint> points;
  std::vector<double> lowest, median, highest;  // [m] depth of the dip; NaN where no growth has one
  std::size_t asked = 0, growths = 0;           // wanted, and complete
  std::optional<double> limit;                  // [m] of depth that was asked for
  std::vector<double> passedAt;  // [kg] at which growths pass it, ascending; fewer than growths where not all do
};

// The depths of one growth at the points, and where it passes the limit.
struct ForecastGrowth {
  std::vector<double> depths;
  std::optional<double> passedAt;
};
Forecast forecastFrom(const std::vector<ForecastPoint>& points, const std::vector<ForecastGrowth>& growths,
                      std::optional<double> limit, std::size_t asked);

std::string forecastTable(const Forecast& forecast);  // CSV
std::string forecastText(const Forecast& forecast);   // for people

}  // namespace squat::growth
