#include "growth/Forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 2 * tonnageRounding;

std::string megatonnes(double kilograms) { return text::fixedText(kilograms / kilogramsInMegatonne, 2) + " Mt"; }

// Of ascending values.
double medianOf(const std::vector<double>& sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

// Behind `before`, which is not the last stage.
double depthBetween(const Stage& before, const Stage& next, double tonnage) {
  const double t = (tonnage - before.tonnage) / (next.tonnage - before.tonnage);
  return (1 - t) * before.depth + t * next.depth;
}

// A grinding has a stage of the same tonnage before it; `ground`: the point is the moment after one, which stands a few
// wheelsets later where the last block ended there.
double depthAt(const std::vector<Stage>& stages, const ForecastPoint& point, bool ground) {
  const double share = point.tonnage * rounding;
  if (ground) {
    const auto after = std::find_if(stages.begin(), stages.end(), [&](const Stage& stage) {
      return stage.ground && stage.tonnage >= point.tonnage - share;
    });
    return after == stages.end() ? unknown : after->depth;
  }
  const auto later = std::find_if(stages.begin(), stages.end(), [&](const Stage& stage) {
    return point.toBeGround ? stage.tonnage >= point.tonnage - share : stage.tonnage > point.tonnage + share;
  });
  if (point.toBeGround) return later == stages.end() ? unknown : later->depth;
  if (later == stages.begin()) return unknown;
  const auto& before = *std::prev(later);
  if (before.tonnage >= point.tonnage - share) return before.depth;
  return later == stages.end() ? unknown : depthBetween(before, *later, point.tonnage);
}

std::string passagesText(const Forecast& f) {
  const std::string limit = text::numberText(1e3 * *f.limit) + " mm";
  const auto passed = f.passedAt.size();
  if (passed == 0) return "None of the growths reaches " + limit + ".\n";
  const std::string first = limit + ", the first after " + megatonnes(f.passedAt.front());
  if (passed == f.growths)
    return "All growths reach " + first + ", half of them by " + megatonnes(medianOf(f.passedAt)) +
           ", the last after " + megatonnes(f.passedAt.back()) + ".\n";
  return std::to_string(passed) + " of the growths " + (passed == 1 ? "reaches " : "reach ") + first + ".\n";
}

}  // namespace

std::vector<ForecastPoint> forecastPoints(const GrowthOptions& options) {
  constexpr int steps = 20;
  std::vector<ForecastPoint> points;
  for (int i = 0; i <= steps; ++i) points.push_back({options.tonnage * i / steps, false});
  for (const auto& grinding : options.grindings) points.push_back({grinding.tonnage, true});
  std::stable_sort(points.begin(), points.end(), [](const ForecastPoint& a, const ForecastPoint& b) {
    return a.tonnage < b.tonnage || (a.tonnage == b.tonnage && a.toBeGround && !b.toBeGround);
  });
  return points;
}

std::vector<double> depthsAt(const Growth& growth, const std::vector<ForecastPoint>& points) {
  std::vector<double> depths;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool ground = i > 0 && points[i - 1].toBeGround && points[i].tonnage == points[i - 1].tonnage;
    depths.push_back(depthAt(growth.stages, points[i], ground));
  }
  return depths;
}

std::optional<double> firstPassage(const Growth& growth, double limit) {
  const auto& stages = growth.stages;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!(stages[i].depth >= limit)) continue;
    if (i == 0 || stages[i].ground) return stages[i].tonnage;
    const auto& before = stages[i - 1];
    const double t = (limit - before.depth) / (stages[i].depth - before.depth);
    return before.tonnage + t * (stages[i].tonnage - before.tonnage);
  }
  return {};
}

Forecast forecastFrom(const std::vector<ForecastPoint>& points, const std::vector<ForecastGrowth>& growths,
                      std::optional<double> limit, std::size_t asked) {
  Forecast forecast;
  forecast.points = points, forecast.growths = growths.size(), forecast.limit = limit, forecast.asked = asked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> known;
    for (const auto& growth : growths)
      if (!std::isnan(growth.depths[i])) known.push_back(growth.depths[i]);
    std::sort(known.begin(), known.end());
    forecast.lowest.push_back(known.empty() ? unknown : known.front());
    forecast.median.push_back(known.empty() ? unknown : medianOf(known));
    forecast.highest.push_back(known.empty() ? unknown : known.back());
  }
  for (const auto& growth : growths)
    if (limit && growth.passedAt) forecast.passedAt.push_back(*growth.passedAt);
  std::sort(forecast.passedAt.begin(), forecast.passedAt.end());
  return forecast;
}

std::string forecastTable(const Forecast& f) {
  std::vector<std::vector<double>> columns(2);
  for (const auto& point : f.points) {
    columns[0].push_back(point.tonnage / kilogramsInMegatonne);
    columns[1].push_back(point.toBeGround ? 1 : 0);
  }
  for (const auto* depth : {&f.lowest, &f.median, &f.highest}) {
    auto& own = columns.emplace_back(*depth);
    for (double& value : own) value *= 1e3;
  }
  return text::csvColumns(
      {"tonnage [Mt]", "to be ground", "lowest depth [mm]", "median depth [mm]", "highest depth [mm]"},
      {&columns[0], &columns[1], &columns[2], &columns[3], &columns[4]});
}

std::string forecastText(const Forecast& f) {
  const auto count = std::to_string(f.growths);
  if (f.growths == 0) return "Forecast: none of " + std::to_string(f.asked) + " growths was completed.\n";
  const auto mm = [](double metres) { return text::fixedText(1e3 * metres, 3); };
  std::string all = "Forecast from " + count + (f.growths < f.asked ? " of " + std::to_string(f.asked) : "") +
                    " growths with other inputs: after " + megatonnes(f.points.back().tonnage) + " the dip is " +
                    mm(f.lowest.back()) + " to " + mm(f.highest.back()) + " mm deep, in the median " +
                    mm(f.median.back()) + " mm.\n";
  if (f.limit) all += passagesText(f);
  return all;
}

}  // namespace squat::growth
