#include "growth/Forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double megatonnes(double kilograms) { return kilograms / kilogramsInMegatonne; }

// Of ascending values.
double medianOf(const std::vector<double>& sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

std::optional<double> firstPassage(const std::vector<double>& tonnage, const std::vector<double>& depth, double limit) {
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!(depth[i] >= limit)) continue;
    if (i == 0 || !(depth[i - 1] < limit)) return tonnage[i];
    return tonnage[i - 1] + (tonnage[i] - tonnage[i - 1]) * (limit - depth[i - 1]) / (depth[i] - depth[i - 1]);
  }
  return {};
}

std::string passagesText(const Forecast& f) {
  const auto mt = [](double kilograms) { return text::fixedText(megatonnes(kilograms), 2) + " Mt"; };
  const std::string limit = text::fixedText(1e3 * *f.limit, 2) + " mm";
  const auto passed = f.passedAt.size();
  if (passed == 0) return "None of the growths passes " + limit + ".\n";
  const std::string first = limit + ", the first after " + mt(f.passedAt.front());
  if (passed == f.growths)
    return "All growths pass " + first + ", half of them by " + mt(medianOf(f.passedAt)) + ", the last after " +
           mt(f.passedAt.back()) + ".\n";
  return std::to_string(passed) + " of the growths " + (passed == 1 ? "passes " : "pass ") + first + ".\n";
}

}  // namespace

std::vector<double> forecastTonnages(double tonnage) {
  constexpr int steps = 20;
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(tonnage * i / steps);
  return all;
}

std::vector<double> depthsAt(const Growth& growth, const std::vector<double>& tonnages) {
  constexpr double rounding = 1e-9;
  const auto& stages = growth.stages;
  std::vector<double> depths;
  for (const double tonnage : tonnages) {
    const auto next = std::upper_bound(stages.begin(), stages.end(), tonnage,
                                       [](double at, const Stage& stage) { return at < stage.tonnage; });
    if (next == stages.begin() || (next == stages.end() && tonnage > stages.back().tonnage * (1 + rounding))) {
      depths.push_back(none);
      continue;
    }
    const auto& before = *std::prev(next);
    const double t = next == stages.end() ? 0 : (tonnage - before.tonnage) / (next->tonnage - before.tonnage);
    depths.push_back(t == 0 ? before.depth : (1 - t) * before.depth + t * next->depth);
  }
  return depths;
}

Forecast forecastFrom(const std::vector<double>& tonnage, const std::vector<std::vector<double>>& depths,
                      std::optional<double> limit) {
  Forecast forecast;
  forecast.tonnage = tonnage, forecast.growths = depths.size(), forecast.limit = limit;
  for (std::size_t i = 0; i < tonnage.size(); ++i) {
    std::vector<double> known;
    for (const auto& growth : depths)
      if (!std::isnan(growth[i])) known.push_back(growth[i]);
    std::sort(known.begin(), known.end());
    forecast.lowest.push_back(known.empty() ? none : known.front());
    forecast.median.push_back(known.empty() ? none : medianOf(known));
    forecast.highest.push_back(known.empty() ? none : known.back());
  }
  if (!limit) return forecast;
  for (const auto& growth : depths)
    if (const auto at = firstPassage(tonnage, growth, *limit)) forecast.passedAt.push_back(*at);
  std::sort(forecast.passedAt.begin(), forecast.passedAt.end());
  return forecast;
}

std::string forecastTable(const Forecast& f) {
  std::vector<std::vector<double>> columns;
  const auto add = [&](const std::vector<double>& values, double scale) {
    auto& own = columns.emplace_back(values);
    for (double& value : own) value *= scale;
  };
  add(f.tonnage, 1 / kilogramsInMegatonne);
  for (const auto* depth : {&f.lowest, &f.median, &f.highest}) add(*depth, 1e3);
  return text::csvColumns({"tonnage [Mt]", "lowest depth [mm]", "median depth [mm]", "highest depth [mm]"},
                          {&columns[0], &columns[1], &columns[2], &columns[3]});
}

// The next of N + 1 values that are alike is as likely in one place of their order as in another, so it is between the
// lowest and the highest of the others with (N - 1) / (N + 1).
std::string forecastText(const Forecast& f) {
  if (f.growths == 0) return {};
  const auto mm = [](double metres) { return text::fixedText(1e3 * metres, 3); };
  const double inside = (static_cast<double>(f.growths) - 1) / (static_cast<double>(f.growths) + 1);
  std::string all = "Forecast from " + std::to_string(f.growths) + " growths with other inputs: after " +
                    text::fixedText(megatonnes(f.tonnage.back()), 2) + " Mt the dip is " + mm(f.lowest.back()) +
                    " to " + mm(f.highest.back()) + " mm deep, in the median " + mm(f.median.back()) +
                    " mm.\nOne more growth would be between these limits with a probability of " +
                    text::fixedText(100 * inside, 0) + " %.\n";
  if (f.limit) all += passagesText(f);
  return all;
}

}  // namespace squat::growth
