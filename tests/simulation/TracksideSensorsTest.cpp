// Where trackside accelerometers sit, and that they record the motion of their points.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "simulation/TracksideSensors.h"

namespace squat::simulation {
namespace {

model::Model trackOf(const std::string& inclination) {
  return model::buildModel(cases::loadScenario(
      "smooth-rail",
      {"tiny", {{"rail.inclination", inclination}, {"wheelset.cone", inclination}, {"motion.torque", "0"}}}));
}

// Every node moved vertically by a + b x, in the local components of its block.
AlignedVector ramp(const model::Model& model, double a, double b) {
  AlignedVector state(model.stateSize, 0.0);
  for (const auto& block : model.blocks)
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) {
        const double x = elasticity::nodePosition(block, n, s).x();
        const Eigen::Vector3d local =
            elasticity::localBasis(block, block.positions[s]).transpose() * Eigen::Vector3d(0, 0, a + b * x);
        for (int c = 0; c < 3; ++c) state[block.index(n, c, s)] = local[c];
      }
  return state;
}

double motionOf(const VerticalMotion& motion, const AlignedVector& state) {
  double sum = 0;
  for (const auto& [unknown, weight] : motion) sum += weight * state[unknown];
  return sum;
}

// A linear field is interpolated exactly, also on a rail that leans; the sleeper's sensor stands on its centre line.
TEST(TracksideSensors, SeeALinearField) {
  for (const std::string inclination : {"0", "0.025"}) {
    const auto model = trackOf(inclination);
    const auto state = ramp(model, 0.3, 2);
    for (const double x : {-0.5, -0.0137, 0.0, 0.2511})
      EXPECT_NEAR(motionOf(railFootAt(model, x), state), 0.3 + 2 * x, 1e-12) << x;
    const double second = model.sleeperPositions[1], spacing = model.sleeperPositions[1] - model.sleeperPositions[0];
    for (const double x : {second - 0.4 * spacing, second, second + 0.4 * spacing})
      EXPECT_NEAR(motionOf(sleeperTopNear(model, x), state), 0.3 + 2 * second, 1e-12) << x;
  }
}

TEST(TracksideSensors, MustStandOnTheRail) {
  const auto model = trackOf("0");
  try {
    railFootAt(model, 50);
    FAIL() << "a sensor beyond the end of the rail";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("output.rail_accelerometer"), std::string::npos) << error.what();
  }
}

// The accelerometer against the second difference of the displacements of its point over two steps: central difference
// of both, equal but for round-off of u / dt^2 (1e-3 m, 1e-6 s: 1e-7 m/s2 of 1e-16 each, with room).
TEST(TracksideSensors, RecordTheSecondDifferenceOfDisplacement) {
  const auto model = trackOf("0");
  ThreadTeam team(1);
  dynamics::Rolling rolling(model, elasticity::kernelsFor(""), team, 1e-6, 1e-8);
  AlignedVector velocity(model.stateSize, 0.0);  // the track set in motion: anything that accelerates
  for (int s = 0; s < model.blocks[model.rail].stationCount; ++s)
    for (int n = 0; n < model.blocks[model.rail].nodes; ++n)
      velocity[model.blocks[model.rail].index(n, 2, s)] =
          -0.1 * std::exp(-std::pow(model.blocks[model.rail].positions[s] / 0.1, 2));
  rolling.start(AlignedVector(model.stateSize, 0.0), velocity, 65);
  const auto motion = railFootAt(model, 0.02);
  Accelerometer accelerometer(motion, rolling);
  std::vector<double> location, recorded;
  const auto nothing = [](const dynamics::StepView&) {};
  for (int k = 0; k < 40; ++k) {
    location.push_back(motionOf(motion, rolling.displacement()));
    rolling.advance(1, nothing);
    recorded.push_back(accelerometer(rolling));
  }
  double largest = 0;
  for (std::size_t k = 1; k + 1 < location.size(); ++k) {
    const double second = (location[k + 1] - 2 * location[k] + location[k - 1]) / 1e-12;
    EXPECT_NEAR(recorded[k], second, 1e-3) << k;
    largest = std::max(largest, std::abs(second));
  }
  EXPECT_GT(largest, 10) << "nothing moved";
}

}  // namespace
}  // namespace squat::simulation
