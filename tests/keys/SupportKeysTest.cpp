// Springs and dashpots of the track and the vehicle: what they answer to rigid motions of what they hold.
//
// A motion of one metre (one radian) stretches every element by q; the sum of k q^2 is the stiffness, that of c q^2 the
// damping, that the motion meets. Tolerances: round-off of a sum over some hundred elements.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/Rolling.h"
#include "elasticity/SweptSamples.h"
#include "keys/Keys.h"
#include "model/StaticOperator.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::Values;

enum class Met { stiffness, damping };

double met(const model::Model& model, const AlignedVector& motion, forces::Kind kind, Met what) {
  double sum = 0;
  for (const auto& set : model.forceElements)
    for (std::size_t i = 0; set.kind == kind && i < set.size(); ++i) {
      const double q = set.elongation(i, motion.data());
      sum += (what == Met::stiffness ? set.stiffness[i] : set.damping[i]) * q * q;
    }
  return sum;
}

AlignedVector railMoved(const model::Model& model, const elasticity::Field& field) {
  AlignedVector motion(model.stateSize, 0.0);
  elasticity::setField(model.blocks[model.rail], field, motion);
  return motion;
}

AlignedVector sleepersMoved(const model::Model& model, const Eigen::Vector3d& by) {
  AlignedVector motion(model.stateSize, 0.0);
  for (int i = 0; i < model.sleepers; ++i)
    elasticity::setField(
        model.blocks[model.firstSleeper + i], [&](const Eigen::Vector3d&) { return by; }, motion);
  return motion;
}

struct Row {
  const char *key, *text;
  double value;  // SI
  Met met;
  Eigen::Vector3d direction;
};

const Eigen::Vector3d along(1, 0, 0), across(0, 1, 0), up(0, 0, 1);

// Per rail seat: all pads together resist the rail.
TEST(PadKeys, SupportTheRail) {
  const Row rows[] = {{"pad.stiffness", "650", 650e6, Met::stiffness, up},
                      {"pad.damping", "30", 30e3, Met::damping, up},
                      {"pad.longitudinal_stiffness", "70", 70e6, Met::stiffness, along},
                      {"pad.longitudinal_damping", "7", 7e3, Met::damping, along},
                      {"pad.lateral_stiffness", "90", 90e6, Met::stiffness, across},
                      {"pad.lateral_damping", "9", 9e3, Met::damping, across}};
  for (const auto& row : rows) {
    const auto model = modelWith({{row.key, row.text}});
    const auto motion = railMoved(model, [&](const Eigen::Vector3d&) { return row.direction; });
    EXPECT_NEAR(met(model, motion, forces::Kind::railPad, row.met) / model.sleepers, row.value, 1e-9 * row.value)
        << row.key;
  }
}

// Per half sleeper.
TEST(BallastKeys, SupportTheSleeper) {
  const Row rows[] = {{"ballast.stiffness", "60", 60e6, Met::stiffness, up},
                      {"ballast.damping", "50", 50e3, Met::damping, up},
                      {"ballast.longitudinal_stiffness", "30", 30e6, Met::stiffness, along},
                      {"ballast.longitudinal_damping", "8", 8e3, Met::damping, along},
                      {"ballast.lateral_stiffness", "25", 25e6, Met::stiffness, across},
                      {"ballast.lateral_damping", "11", 11e3, Met::damping, across}};
  for (const auto& row : rows) {
    const auto model = modelWith({{row.key, row.text}});
    const auto motion = sleepersMoved(model, row.direction);
    EXPECT_NEAR(met(model, motion, forces::Kind::ballast, row.met) / model.sleepers, row.value, 1e-9 * row.value)
        << row.key;
  }
}

// A pad of n springs along its width w resists the rail's turn about its own middle by K w^2 / 12 (1 - 1/n^2): four
// across, six along.
TEST(PadKeys, WidthResistsTheRailsTilt) {
  const auto model = modelWith({{"pad.width", "0.1"}});
  double base = 0;
  for (const auto& p : model.blocks[model.rail].section.nodes) base = std::min(base, p[1]);
  // About the rail's base, so that no spring across is stretched.
  const auto turned = railMoved(model, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, base - p[2], p[1]); });
  const double expected = model.scenario.pad.stiffness * 0.1 * 0.1 / 12 * (1 - 1.0 / 16);
  EXPECT_NEAR(met(model, turned, forces::Kind::railPad, Met::stiffness) / model.sleepers, expected, 1e-9 * expected);
}

TEST(PadKeys, LengthResistsTheRailsPitch) {
  const auto model = modelWith({{"pad.length", "0.2"}});
  double expected = 0;
  for (const double x : model.sleeperPositions) expected += x * x + 0.2 * 0.2 / 12 * (1 - 1.0 / 36);
  expected *= model.scenario.pad.stiffness;
  const auto turned = railMoved(model, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0, p[0]); });
  EXPECT_NEAR(met(model, turned, forces::Kind::railPad, Met::stiffness), expected, 1e-9 * expected);
}

TEST(SuspensionKeys, SupportTheSprungMass) {
  struct {
    const char *key, *text;
    double value;
    Met met;
    bool isVertical;
  } const rows[] = {{"suspension.stiffness", "2", 2e6, Met::stiffness, true},
                    {"suspension.damping", "40", 40e3, Met::damping, true},
                    {"suspension.longitudinal_stiffness", "7", 7e6, Met::stiffness, false},
                    {"suspension.longitudinal_damping", "5", 5e3, Met::damping, false}};
  for (const auto& row : rows) {
    const auto model = modelWith({{row.key, row.text}});
    AlignedVector motion(model.stateSize, 0.0);
    motion[row.isVertical ? model.sprungZ : model.sprungX] = 1;
    EXPECT_NEAR(met(model, motion, forces::Kind::primarySuspension, row.met), row.value, 1e-9 * row.value) << row.key;
  }
}

// A wheelset that has moved sideways as one body, and goes on doing so, for one step: both boxes' springs and dashpots
// take 2 (k y + c v) dt of its momentum, and the dashpots 2 c v^2 dt of its energy. Of the momentum of both halves,
// 2 m v of some 250 N s, that is 0.007 N s: round-off of the sums stays below 1e-4 of it.
TEST(SuspensionKeys, HoldTheWholeWheelsetLaterally) {
  const auto left = modelWith(
      {{"model.extent", "whole"}, {"suspension.lateral_stiffness", "30"}, {"suspension.lateral_damping", "50"}});
  const auto right = left;
  ThreadTeam team(1);
  const double step = 1e-7, shift = 1e-3, speed = 0.1;
  dynamics::Rolling rolling(left, elasticity::kernelsFor(""), team, step, 0);
  dynamics::Rolling other(right, elasticity::kernelsFor(""), team, step, 0);
  rolling.take(other);
  const auto sideways = [&](double by) {
    AlignedVector state(left.stateSize, 0.0);
    for (const int b : {left.rim, left.body}) {
      const auto& block = left.blocks[b];
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s) state[block.index(n, 2, s)] = by;
    }
    return state;
  };
  rolling.start(sideways(shift), sideways(speed), 0);
  other.start(sideways(-shift), sideways(-speed), 0);
  const auto momentum = [&](const dynamics::Rolling& half) {
    double sum = 0;
    for (const int b : {left.rim, left.body}) {
      const auto& block = left.blocks[b];
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s)
          if (!left.slave[b][n])
            sum += left.mass[b][n * block.stride + s] * half.state().velocity[block.index(n, 2, s)];
    }
    return sum;
  };
  const double before = momentum(rolling) - momentum(other);
  rolling.advance(1, [](const dynamics::StepView&) {});
  const double taken = before - (momentum(rolling) - momentum(other));
  const double expected = 2 * (30e6 * shift + 50e3 * speed) * step;
  EXPECT_NEAR(taken, expected, 1e-4 * expected);
  const double damped = 2 * 50e3 * speed * speed * step;
  EXPECT_NEAR(rolling.state().sums.damping + other.state().sums.damping, damped, 1e-9 * damped);
}

TEST(SuspensionKeys, SprungMassAndGravityWeighOnTheSpring) {
  const auto model = modelWith({{"suspension.sprung_mass", "5000"}, {"motion.gravity", "3.7"}});
  EXPECT_NEAR(model::gravityForces(model, 0)[model.sprungZ], -3.7 * 5000, 1e-9);
}

}  // namespace
}  // namespace squat
