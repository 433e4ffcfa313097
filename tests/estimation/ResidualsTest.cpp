// A measured passage beside a computed one: alignment, residuals and their derivative by the shift.
#include "estimation/Residuals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::estimation {
namespace {

constexpr double kSpeed = 30, kCutoff = 2000;
constexpr SearchWindow kWindow{-0.05, 0.06, 0.13};

double pulse(double x) { return 80 * std::exp(-std::pow(x / 0.02, 2)) * std::cos(x / 0.01); }

// The record has the same pulse at 12.345 m.
MeasuredPassage recordOfPulse() {
  MeasuredPassage measured;
  measured.noise = 2, measured.impact = 12.345, measured.peak = 80, measured.speed = kSpeed;
  auto& series = measured.passage.series;
  series.step = 1 / 25000.0;
  for (int i = 0; i < 1000; ++i) {
    const double x = 12 + kSpeed * series.step * i;
    measured.passage.position.push_back(x);
    series.values.push_back(pulse(x - 12.345));
  }
  return measured;
}

PositionSeries computedPulse() {
  const double step = positionStep(kSpeed, kCutoff);
  PositionSeries computed{-0.1, step, {}, "aba", "m/s2"};
  while (computed.timeAt(computed.values.size()) < 0.15)
    computed.values.push_back(pulse(computed.timeAt(computed.values.size())));
  return computed;
}

TEST(Residuals, TheSamePulseLeavesNothing) {
  const auto compared = comparedPassage(recordOfPulse(), 0, kSpeed, kCutoff, kWindow);
  const auto computed = computedPulse();
  const double shift = shiftOf(compared, computed);
  EXPECT_NEAR(shift, 12.345, 2e-4);  // a parabola through three values a tenth of a period apart
  const auto residuals = residualsOf(compared, computed, 12.345);
  // Two a period of 2 kHz at 30 m/s: 7.5 mm apart over 180 mm.
  EXPECT_EQ(residuals.size(), 25);
  // 80 m/s2 over a noise of 2 and the interpolation's 1e-4, twice.
  EXPECT_LT(residuals.cwiseAbs().maxCoeff(), 0.01);
}

TEST(Residuals, KnowTheirDerivativeByTheShift) {
  const auto compared = comparedPassage(recordOfPulse(), 0, kSpeed, kCutoff, kWindow);
  const auto computed = computedPulse();
  const auto slope = slopeOfShift(compared, 12.345);
  constexpr double step = 1e-4;
  const Eigen::VectorXd differences =
      (residualsOf(compared, computed, 12.345 + step) - residualsOf(compared, computed, 12.345 - step)) / (2 * step);
  EXPECT_LT((slope - differences).norm(), 0.02 * slope.norm());  // second order of both steps
}

}  // namespace
}  // namespace squat::estimation
