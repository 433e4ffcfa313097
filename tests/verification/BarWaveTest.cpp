// Longitudinal pulse on a thin bar, explicit steps.
// Theory: d'Alembert, u = g(x - c t), c = sqrt(E / rho); dispersion by lateral inertia (Rayleigh, Love) slows a wave of
// number k by nu^2 k^2 J / 2 A, here 3e-5. Tolerance 1 % as asked for; what is left is the mesh (20 elements a pulse
// width) and the step.
#include <gtest/gtest.h>

#include <cmath>

#include "verification/Seen.h"
#include "verification/StepBlocks.h"

namespace squat::elasticity {
namespace {

SweptBlock thinBar() {
  SweptBlock bar;
  bar.name = "bar", bar.material = steel;
  bar.section = gridSection(evenly(-0.004, 0.004, 1), evenly(-0.004, 0.004, 1));
  bar.stations = {0, false, {{320, 0.01}}};
  return bar;
}

constexpr double width = 0.10, start = 0.6, amplitude = 1e-5;
double pulse(double x) { return amplitude * std::exp(-0.5 * std::pow((x - start) / width, 2)); }

// Sets the bar to a pulse that runs to the right: displacement at time 0, velocity half a step before.
void startPulse(FreeBlocks& bar, double speed, double step) {
  const double nu = steel.poisson, h = 1e-4;
  const auto gradient = [&](double x) { return (pulse(x + h) - pulse(x - h)) / (2 * h); };
  const auto curvature = [&](double x) { return (pulse(x + h) - 2 * pulse(x) + pulse(x - h)) / (h * h); };
  setField(
      bar.blocks()[0],
      [&](const Eigen::Vector3d& p) {
        return Eigen::Vector3d(pulse(p[0]), -nu * p[1] * gradient(p[0]), -nu * p[2] * gradient(p[0]));
      },
      bar.displacement());
  setField(
      bar.blocks()[0],
      [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        const double x = p[0] + speed * step / 2;  // the pulse half a step earlier
        return speed * Eigen::Vector3d(-gradient(x), nu * p[1] * curvature(x), nu * p[2] * curvature(x));
      },
      bar.velocity());
}

// First moment of the displacement along the bar: where the pulse is.
double centroid(const FreeBlocks& bar, const AlignedVector& u) {
  const auto& block = bar.blocks()[0];
  double sum = 0, moment = 0;
  for (int s = 0; s < block.stationCount; ++s) {
    const double mean = u[block.index(0, 0, s)];
    sum += mean, moment += mean * block.positions[s];
  }
  return moment / sum;
}

TEST(BarWave, RunsAtTheSpeedOfABar) {
  const double speed = std::sqrt(steel.young / steel.density);
  FreeBlocks bar({thinBar()});
  const double step = 0.9 * 2 / std::sqrt(bar.highestEigenvalue(200));
  startPulse(bar, speed, step);
  EXPECT_NEAR(centroid(bar, bar.displacement()), start, 1e-9);
  const int steps = static_cast<int>(1.8 / speed / step);
  bar.advance(step, steps);
  const double measured = (centroid(bar, bar.displacement()) - start) / (steps * step);
  EXPECT_NEAR(measured, speed, 0.01 * speed);
  verification::seenDeviation("speed", measured, speed);
  // It has kept its height, so it has kept its shape: 1 % for what runs the other way and disperses.
  double height = 0;
  for (int s = 0; s < bar.blocks()[0].stationCount; ++s)
    height = std::max(height, bar.displacement()[bar.blocks()[0].index(0, 0, s)]);
  EXPECT_NEAR(height, amplitude, 0.01 * amplitude);
}

TEST(BarWave, SameBitsForAnyPartition) {
  AlignedVector first;
  for (const int parts : {1, 2, 3}) {
    FreeBlocks bar({thinBar()}, 1e-8);
    startPulse(bar, 5000, 1e-7);
    bar.advance(1e-7, 50, parts);
    if (parts == 1) {
      first = bar.displacement();
    } else {
      EXPECT_EQ(bar.displacement(), first) << parts;
    }
  }
}

// Just above the stable step the highest mode grows without bound, just below it stays: the step's formula
// 2 / w (sqrt(1 + z^2) - z), z = beta w / 2 (T. Belytschko, W. K. Liu, B. Moran, Nonlinear Finite Elements, 6.2).
TEST(BarWave, StepLimitIsThatOfTheHighestMode) {
  const auto growth = [](double factor, double beta) {
    SweptBlock cube = thinBar();
    cube.stations = {0, false, {{8, 0.008}}};
    FreeBlocks bar({cube}, beta);
    const double highest = std::sqrt(bar.highestEigenvalue(20000)), z = beta * highest / 2;
    for (const std::size_t i : unknownsOf(bar.blocks()[0]))
      bar.displacement()[i] = std::sin(7.3 * static_cast<double>(i));
    bar.advance(factor * 2 / highest * (std::sqrt(1 + z * z) - z), 300);
    return largest(bar.displacement());
  };
  for (const double beta : {0.0, 2e-7}) {
    EXPECT_LT(growth(0.99, beta), 100) << "beta " << beta;
    EXPECT_GT(growth(1.01, beta), 1e6) << "beta " << beta;
  }
}

}  // namespace
}  // namespace squat::elasticity
