// Elastic laws of force elements against closed forms.
#include "forces/ElasticLaw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "forces/ForceShares.h"

namespace squat {
namespace {

using forces::ElasticLaw;

// Two slopes, 1 kN/mm up to 10 kN, then 4 kN/mm; points at both ends are far from what is asked.
const std::vector<std::array<double, 2>> twoSlopes{{0, 0}, {0.010, 10e3}, {0.020, 50e3}};

TEST(ElasticLaw, TwoSlopesBySection) {
  const auto law = ElasticLaw::fromCompression(twoSlopes, 0);
  // Compressed by 4 mm: 4 kN, 8 J. By 12 mm: 10 + 8 kN, 50 + 28 J. Pulled by 2 mm: the first slope goes on.
  EXPECT_NEAR(law.force(-0.004), -4e3, 1e-9);
  EXPECT_NEAR(law.storedEnergy(-0.004), 8, 1e-12);
  EXPECT_NEAR(law.force(-0.012), -18e3, 1e-9);
  EXPECT_NEAR(law.storedEnergy(-0.012), 78, 1e-12);
  EXPECT_NEAR(law.force(0.002), 2e3, 1e-9);
  EXPECT_NEAR(law.storedEnergy(0.002), 2, 1e-12);
  EXPECT_NEAR(law.force(-0.03), -90e3, 1e-9);  // and the last one
  EXPECT_NEAR(law.tangent(-0.004), 1e6, 1e-6);
  EXPECT_NEAR(law.tangent(-0.012), 4e6, 1e-6);
  EXPECT_NEAR(law.stiffestTangent(), 4e6, 1e-6);
  EXPECT_TRUE(law.transmits(0.5));
}

// Clamped with 30 kN, at 15 mm: there force and energy are zero, the tangent is that of the second slope; 5 mm apart
// the pad stands at the kink, 20 kN less and 30 kN x 5 mm - 100 J = 50 J of it.
TEST(ElasticLaw, StandsAtItsPreload) {
  const auto law = ElasticLaw::fromCompression(twoSlopes, 30e3);
  EXPECT_NEAR(law.force(0), 0, 1e-9);
  EXPECT_NEAR(law.storedEnergy(0), 0, 1e-12);
  EXPECT_NEAR(law.tangent(0), 4e6, 1e-6);
  EXPECT_NEAR(law.force(0.005), 20e3, 1e-9);
  EXPECT_NEAR(law.storedEnergy(0.005), 50, 1e-12);
  EXPECT_NEAR(law.force(0.009), 24e3, 1e-9);
}

TEST(ElasticLaw, GapTransmitsNothingUntilItCloses) {
  const auto law = ElasticLaw::closingGap(0.002);
  for (const double q : {0.01, 0.0, -0.0019}) {
    EXPECT_EQ(law.force(q), 0) << q;
    EXPECT_EQ(law.tangent(q), 0) << q;
    EXPECT_EQ(law.storedEnergy(q), 0) << q;
    EXPECT_FALSE(law.transmits(q)) << q;
  }
  EXPECT_TRUE(law.transmits(-0.0021));
  EXPECT_NEAR(law.force(-0.005), -0.003, 1e-15);
  EXPECT_NEAR(law.storedEnergy(-0.005), 0.5 * 0.003 * 0.003, 1e-15);
  EXPECT_EQ(law.tangent(-0.005), 1);
  // Without a gap the element carries at once, and does not pull.
  EXPECT_EQ(ElasticLaw::closingGap(0).tangent(0), 1);
  EXPECT_EQ(ElasticLaw::closingGap(0).force(0.001), 0);
}

// One mass on one element, released at rest, by the central difference of the time loop: the time of one period.
struct Swing {
  double period = 0, largestEnergyError = 0;  // [s], share of the energy at the start
};
Swing swing(const ElasticLaw& law, double mass, double from, double step) {
  forces::ForceElements set;
  set.add({{0, 1.0}}, 1, 0);
  set.forceSlot = {0};
  set.law = law;
  const auto shared = forces::shareForces({set}, 1, [](std::size_t) { return 0; });
  double u = from, v = 0, force = 0, dissipation = 0;
  const double start = set.storedEnergy(0, u);
  Swing result;
  int turns = 0;
  for (long k = 0; turns < 2; ++k) {
    force = 0;
    addForces(shared.shares.front(), &u, &v, &force, &dissipation);
    const double before = v;
    v += (k == 0 ? 0.5 : 1.0) * step * force / mass;
    if (k > 0) {
      // Kinetic energy at the instant of u, as the mean of both half steps.
      const double energy = set.storedEnergy(0, u) + 0.25 * mass * (v * v + before * before);
      result.largestEnergyError = std::max(result.largestEnergyError, std::abs(energy / start - 1));
      // The velocity passes zero between half steps at (k - 1/2) and (k + 1/2).
      if (before * v < 0 && ++turns == 2) result.period = (static_cast<double>(k) - 0.5 + before / (before - v)) * step;
    }
    u += step * v;
  }
  return result;
}

// Half a period on each slope: pi sqrt(m / k1) + pi sqrt(m / k2).
TEST(ElasticLaw, MassOnTwoSlopesSwingsHalfAndHalf) {
  const auto law = ElasticLaw::fromCompression({{-1, -1e6}, {0, 0}, {1, 4e6}}, 0);
  const double mass = 100, expected = std::numbers::pi * (std::sqrt(mass / 1e6) + std::sqrt(mass / 4e6));
  const auto found = swing(law, mass, 0.01, 1e-5);
  // The central difference errs by (w dt)^2 / 24 = 2e-6 of the period; half a step at the kinks.
  EXPECT_NEAR(found.period, expected, 1e-4 * expected);
  // (w dt)^2 / 4 = 1e-6, and the kinks.
  EXPECT_LT(found.largestEnergyError, 1e-4);
}

// F = a c^3 in a hundred points, m c'' = -a c^3: T = 4 sqrt(2 m / a) / A times the integral of ds / sqrt(1 - s^4) from
// 0 to 1 = 7.41630 sqrt(m / a) / A. Chords of length h lie above the cubic by a c h^2 / 2 on average: 0.02 % of a A^3.
TEST(ElasticLaw, MassOnACubicSwingsByTheEllipticIntegral) {
  const double a = 1e12, mass = 50, largest = 0.01;
  std::vector<std::array<double, 2>> points;
  for (int i = -50; i <= 49; ++i) {
    const double c = 1.05 * largest * (i + 0.5) / 49.5;
    points.push_back({c, a * c * c * c});
  }
  const auto found = swing(ElasticLaw::fromCompression(points, 0), mass, largest, 1e-5);
  const double expected = 7.4162987 * std::sqrt(mass / a) / largest;
  EXPECT_NEAR(found.period, expected, 1e-3 * expected);
  EXPECT_LT(found.largestEnergyError, 1e-3);
}

// A dashpot beside a gap: it works only while the gap is closed.
TEST(ElasticLaw, OpenGapDoesNotDamp) {
  forces::ForceElements set;
  set.add({{0, 1.0}}, 1e6, 1e3);
  set.forceSlot = {0};
  set.law = ElasticLaw::closingGap(0.001);
  const auto shared = forces::shareForces({set}, 1, [](std::size_t) { return 0; });
  const double v = -0.5;
  for (const double u : {-0.0005, -0.003}) {
    double force = 0, dissipation = 0;
    addForces(shared.shares.front(), &u, &v, &force, &dissipation);
    const bool isClosed = u < -0.001;
    EXPECT_NEAR(force, isClosed ? 1e6 * 0.002 + 1e3 * 0.5 : 0.0, 1e-9);
    EXPECT_NEAR(dissipation, isClosed ? 1e3 * 0.25 : 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace squat
