#include "estimation/Residuals.h"

#include <algorithm>
#include <cmath>

#include "signals/Resample.h"

namespace squat::estimation {

ComparedPassage comparedPassage(const MeasuredPassage& measured, std::size_t model, double modelSpeed, double cutoff,
                                const SearchWindow& window) {
  // Enough for every alignment of the window with the impact.
  const double before = window.end - window.first, after = 2 * (window.end - window.first);
  ComparedPassage compared;
  compared.model = model, compared.noise = measured.noise;
  auto& series = compared.measured;
  series.step = positionStep(modelSpeed, cutoff);
  series.name = measured.name, series.unit = "m/s2";
  const auto& x = measured.passage.position;
  const double first = std::max(x.front(), measured.impact - before);
  const double last = std::min(x.back(), measured.impact + after);
  series.start = first;
  const signals::Interpolator at(measured.passage.series);
  for (double location = first; location <= last; location = series.timeAt(series.values.size()))
    series.values.push_back(at(signals::timeAtPosition(measured.passage, location)));
  const double step = modelSpeed / (2 * cutoff);
  const auto count = static_cast<long>(std::floor((window.end - window.first) / step + 1e-9));
  for (long i = 0; i <= count; ++i) compared.locations.push_back(window.first + static_cast<double>(i) * step);
  return compared;
}

double shiftOf(const ComparedPassage& passage, const PositionSeries& computed) {
  PositionSeries piece = computed;  // what is compared, and nothing of the run-up
  const auto skipped =
      static_cast<std::size_t>(std::max(0.0, std::ceil((passage.locations.front() - computed.start) / computed.step)));
  const auto kept =
      static_cast<std::size_t>(std::max(0.0, std::floor((passage.locations.back() - computed.start) / computed.step)));
  const auto end = std::min(piece.values.size(), kept + 1);
  if (skipped + 3 > end) return 0;
  piece.values.assign(computed.values.begin() + static_cast<std::ptrdiff_t>(skipped),
                      computed.values.begin() + static_cast<std::ptrdiff_t>(end));
  piece.start = computed.timeAt(skipped);
  return signals::shiftBetween(piece, passage.measured, 0);
}

std::vector<double> valuesAt(const PositionSeries& series, const std::vector<double>& locations, double shift) {
  const signals::Interpolator at(series);
  std::vector<double> values;
  for (const double location : locations) values.push_back(at(location + shift));
  return values;
}

namespace {

// Beyond its ends a record says nothing.
bool holds(const ComparedPassage& passage, double position) {
  const auto& series = passage.measured;
  return position >= series.start && position <= series.timeAt(series.values.size() - 1);
}

}  // namespace

Eigen::VectorXd residualsOf(const ComparedPassage& passage, const PositionSeries& computed, double shift) {
  const auto ours = valuesAt(computed, passage.locations, 0);
  const auto theirs = valuesAt(passage.measured, passage.locations, shift);
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(ours.size()));
  for (std::size_t i = 0; i < ours.size(); ++i)
    residuals[static_cast<Eigen::Index>(i)] =
        holds(passage, passage.locations[i] + shift) ? (ours[i] - theirs[i]) / passage.noise : 0;
  return residuals;
}

Eigen::VectorXd slopeOfShift(const ComparedPassage& passage, double shift) {
  const double half = 0.25 * passage.measured.step;
  const auto ahead = valuesAt(passage.measured, passage.locations, shift + half);
  const auto behind = valuesAt(passage.measured, passage.locations, shift - half);
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(ahead.size()));
  for (std::size_t i = 0; i < ahead.size(); ++i)
    if (holds(passage, passage.locations[i] + shift))
      slope[static_cast<Eigen::Index>(i)] = -(ahead[i] - behind[i]) / (2 * half) / passage.noise;
  return slope;
}

}  // namespace squat::estimation
