// Penalty pressure and Coulomb friction between the wheel's tread and the rail's head, on undeformed bodies: geometry
// of the gap, action and reaction, stick, slip, and the history that the rail's points carry.
#include "contact/RollingContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "model/Model.h"

namespace squat::contact {
namespace {

const model::Model& tiny() {
  static const model::Model model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  return model;
}

constexpr ContactLaw law{1e14, 0.7e14, 0.3};
constexpr double approach = 8e-5, step = 2e-7;

class RollingContactTest : public testing::Test {
 protected:
  RollingContactTest() {
    const auto& model = tiny();
    displaced_.assign(model.stateSize, 0.0), velocity_.assign(model.stateSize, 0.0);
    history_.traction.assign(2 * model.surfaces.points(), 0.0);
    wheel_.placement = {model.startX, model.wheelset.centreHeight, 0, 0, 0};
    wheel_.speed = model.scenario.motion.speed;
    wheel_.angularVelocity = wheel_.speed / model.surfaces.radius;
    lines(model.surfaces.railLine, model.rail, railLines_, railBuffer_);
    lines(model.surfaces.treadLine, model.rim, rimLines_, rimBuffer_);
    lower(approach);
  }

  static void lines(const std::vector<int>& nodes, int block, std::vector<int>& lineOfNode,
                    std::vector<double>& buffer) {
    lineOfNode.assign(tiny().blocks[block].nodes, -1);
    int next = 0;
    for (const int node : nodes) lineOfNode[node] = next++;
    buffer.assign(static_cast<std::size_t>(next) * 3 * tiny().blocks[block].stride, 0.0);
  }

  // The whole rim as a rigid body, `depth` downwards and `along` forwards.
  void lower(double depth, double along = 0) {
    const auto& rim = tiny().blocks[tiny().rim];
    for (int n = 0; n < rim.nodes; ++n)
      for (int s = 0; s < rim.stationCount; ++s) {
        const Eigen::Vector3d local =
            elasticity::localBasis(rim, rim.positions[s] - wheel_.placement.rotation).transpose() *
            Eigen::Vector3d(along, 0, -depth);
        for (int c = 0; c < 3; ++c) displaced_[rim.index(n, c, s)] = local[c];
      }
    wheel_.placement.hubX = along, wheel_.placement.hubZ = -depth;
  }

  // Turns the rim's displacements, without moving the wheel's centre.
  void rotate(double angle) {
    const auto& rim = tiny().blocks[tiny().rim];
    for (int n = 0; n < rim.nodes; ++n)
      for (int s = 0; s < rim.stationCount; ++s) displaced_[rim.index(n, 0, s)] += angle * rim.section.nodes[n][0];
  }

  PatchState roll(const ContactLaw& with = law, const std::vector<RailPoint>* among = nullptr) {
    std::fill(railBuffer_.begin(), railBuffer_.end(), 0.0);
    std::fill(rimBuffer_.begin(), rimBuffer_.end(), 0.0);
    points_.clear();
    return rollContact({tiny().surfaces, tiny().blocks[tiny().rail], tiny().blocks[tiny().rim], with},
                       {wheel_, displaced_.data(), velocity_.data(), step}, history_,
                       {{railBuffer_.data(), railLines_.data()}, {rimBuffer_.data(), rimLines_.data()}},
                       {among, &points_, nullptr});
  }

  Eigen::Vector3d resultant(int block, const std::vector<int>& lineOfNode, const std::vector<double>& buffer) const {
    const auto& b = tiny().blocks[block];
    const double rotation = block == tiny().rim ? wheel_.placement.rotation : 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int n = 0; n < b.nodes; ++n) {
      if (lineOfNode[n] < 0) continue;
      for (int s = 0; s <= b.intervals; ++s) {
        Eigen::Vector3d local;
        for (int c = 0; c < 3; ++c) local[c] = buffer[(static_cast<std::size_t>(lineOfNode[n]) * 3 + c) * b.stride + s];
        sum += elasticity::localBasis(b, b.positions[s] - rotation) * local;
      }
    }
    return sum;
  }
  Eigen::Vector3d onRail() const { return resultant(tiny().rail, railLines_, railBuffer_); }
  Eigen::Vector3d onWheel() const { return resultant(tiny().rim, rimLines_, rimBuffer_); }

  // Sliding by which the tread's material leads the rail's: the wheel spins on the spot, so that it is the same at all
  // points (rolling adds the speed times 1 - cos(angle), 4 mm/s at the patch's ends of undeformed bodies).
  void slide(double speed) { wheel_.speed = 0, wheel_.angularVelocity = -speed / tiny().surfaces.radius; }

  AlignedVector displaced_, velocity_;
  FrictionHistory history_;
  WheelRolling wheel_;
  std::vector<int> railLines_, rimLines_;
  std::vector<double> railBuffer_, rimBuffer_;
  std::vector<PatchPoint> points_;
};

// Gap of a cylinder R over a crown r, lowered by d: penetration d - x^2 / 2R - y^2 / 2r, to terms of fourth order, over
// an ellipse with half axes sqrt(2 R d), sqrt(2 r d); volume pi a b d / 2. Force = penalty times volume. Tolerance 10
// %: a dozen Gauss points for a paraboloid that is cut at its rim.
TEST_F(RollingContactTest, PenetrationIsTheGapOfTheSurfaces) {
  const auto patch = roll({law.normalPenalty, law.tangentialPenalty, 0});
  ASSERT_GT(points_.size(), 8u);
  const double radius = tiny().surfaces.radius, crown = 0.3;
  for (const auto& p : points_) {
    ASSERT_LT(std::abs(p.y), 0.010);  // within R300
    const double expected = approach - p.x * p.x / (2 * radius) - p.y * p.y / (2 * crown);
    EXPECT_NEAR(p.pressure / law.normalPenalty, expected, 1e-3 * approach);
  }
  const double a = std::sqrt(2 * radius * approach), b = std::sqrt(2 * crown * approach), pi = std::acos(-1.0);
  const double volume = pi * a * b * approach / 2;
  EXPECT_NEAR(patch.vertical, law.normalPenalty * volume, 0.1 * law.normalPenalty * volume);
  EXPECT_LE(patch.deepest, approach * (1 + 1e-9));
  EXPECT_EQ(patch.points, static_cast<int>(points_.size()));
}

// Points within 0.05 mm hold all that touch while the wheel sinks and rolls by less than that; the gap grows with
// x^2 / 2R + y^2 / 2r, so that they fill an ellipse as much larger than the patch as (depth + margin) / depth.
TEST_F(RollingContactTest, PointsWithinAMarginAreEnoughUntilTheGapHasClosedByIt) {
  constexpr double margin = 5e-5;
  const auto near = pointsWithin(margin, {tiny().surfaces, tiny().blocks[tiny().rail], tiny().blocks[tiny().rim], law},
                                 wheel_.placement, displaced_.data());
  const int before = roll().points;
  EXPECT_NEAR(static_cast<double>(near.size()), before * (1 + margin / approach), 0.35 * before);
  lower(approach + 0.9 * margin, 2e-5);
  const FrictionHistory untouched{std::vector<double>(history_.traction.size(), 0.0), {}};
  history_ = untouched;
  const auto all = roll();
  const double vertical = onRail()[2];
  history_ = untouched;
  const auto among = roll(law, &near);
  EXPECT_GT(all.points, before);
  EXPECT_EQ(among.points, all.points);
  EXPECT_EQ(among.vertical, all.vertical);
  EXPECT_EQ(onRail()[2], vertical);
}

TEST_F(RollingContactTest, ForcesAreEqualAndOpposite) {
  slide(0.3);
  for (const double turn : {0.0, 0.01}) {
    wheel_.placement.rotation = turn;
    lower(approach, 2e-4);
    for (int k = 0; k < 3; ++k) {
      const auto patch = roll();
      EXPECT_GT(patch.vertical, 1e4);
      EXPECT_LT((onRail() + onWheel()).norm(), 1e-9 * patch.vertical);
      EXPECT_NEAR(-onRail()[2], patch.vertical, 1e-9 * patch.vertical);
      EXPECT_NEAR(onRail()[0], patch.longitudinal, 1e-9 * patch.vertical);
      EXPECT_NEAR(onRail()[1], patch.lateral, 1e-9 * patch.vertical);
    }
  }
}

// Without friction every force points at the wheel's axis: the moment about it vanishes, and so do tractions.
TEST_F(RollingContactTest, FrictionlessForcesPointAtTheAxis) {
  slide(0.3);
  for (int k = 0; k < 3; ++k) {
    const auto patch = roll({law.normalPenalty, law.tangentialPenalty, 0});
    for (const auto& p : points_) EXPECT_EQ(std::hypot(p.tractionX, p.tractionY), 0);
    EXPECT_EQ(patch.frictionPower, 0);
    EXPECT_NEAR(patch.rotationMoment, 0, 1e-15 * patch.vertical);  // the arm: rounding of 0.08 mm
    // Symmetric about the wheel's centre but for where the Gauss points lie.
    double moment = 0;
    for (const auto& p : points_) moment += p.pressure * p.area * p.x;
    EXPECT_NEAR(patch.longitudinal, moment / tiny().surfaces.radius, 1e-3 * std::abs(moment) + 1e-6 * patch.vertical);
    EXPECT_NEAR(patch.lateral, 0, 1e-9 * patch.vertical);
  }
}

// A rigid translation of the reference or of the displacement is the same; a turn of an even tread is nothing.
TEST_F(RollingContactTest, OnlyTheWheelsPlaceCounts) {
  const double force = roll().vertical;
  lower(0);
  wheel_.placement.centreZ -= approach;
  EXPECT_NEAR(roll().vertical, force, 1e-6 * force);
  wheel_.placement.centreZ += approach;
  lower(approach);
  // Displacements along the tread lie beside its circle: 1e-5^2 R / 2 of 8e-5 m, twice that of the force, 6e-7.
  rotate(1e-5);
  EXPECT_NEAR(roll().vertical, force, 1e-6 * force);
}

// A bump of the tread presses where its material has moved, whether the reference turns it there or the displacements.
// 2 % of the bump: its own direction turns, and material between stations lies on their chord.
TEST_F(RollingContactTest, MeetsTheMaterialThatHasMovedThere) {
  constexpr double bump = 2e-5;
  const auto& rim = tiny().blocks[tiny().rim];
  const auto below = std::upper_bound(rim.positions.begin(), rim.positions.end(), 0.0);
  const double turn = 0.4 * (below[1] - below[0]);
  const auto raise = [&] {
    for (const int n : tiny().surfaces.treadLine) displaced_[rim.index(n, 1, below - rim.positions.begin())] += bump;
  };
  const ContactLaw smooth{law.normalPenalty, law.tangentialPenalty, 0};
  raise();
  roll(smooth);
  const auto unturned = points_;
  wheel_.placement.rotation = turn;
  lower(approach), raise();
  roll(smooth);
  const auto turned = points_;
  wheel_.placement.rotation = 0;
  lower(approach), raise();
  for (int n = 0; n < rim.nodes; ++n)
    for (int s = 0; s < rim.stationCount; ++s) {
      displaced_[rim.index(n, 0, s)] -= std::sin(turn) * rim.section.nodes[n][0];
      displaced_[rim.index(n, 1, s)] -= (1 - std::cos(turn)) * rim.section.nodes[n][0];
    }
  const auto expectTurned = [&] {
    roll(smooth);
    ASSERT_EQ(points_.size(), turned.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      EXPECT_NEAR(points_[i].pressure, turned[i].pressure, 0.02 * law.normalPenalty * bump) << points_[i].x;
  };
  expectTurned();
  // Or the reference turns it there until the instant of the displacements.
  lower(approach), raise();
  wheel_.placement.turnAhead = turn;
  expectTurned();
  double moved = 0;
  for (std::size_t i = 0; i < std::min(turned.size(), unturned.size()); ++i)
    moved = std::max(moved, std::abs(unturned[i].pressure - turned[i].pressure));
  EXPECT_GT(moved, 0.2 * law.normalPenalty * bump);
}

// The moment about the axis is that of the rim's forces with the arms of its reference, also where the tread has moved
// along: then the normal force has an arm of just that (1e-3: tread is coned, forces stand off the vertical by 1e-2 at
// the patch's ends). 1e-5: tread between stations lies on their chord.
TEST_F(RollingContactTest, TheRotationFeelsTheForcesOnTheRim) {
  const auto& rim = tiny().blocks[tiny().rim];
  const auto moment = [&] {
    double sum = 0;
    for (int n = 0; n < rim.nodes; ++n)
      for (int s = 0; rimLines_[n] >= 0 && s < rim.stationCount; ++s)
        sum -= rim.section.nodes[n][0] * rimBuffer_[static_cast<std::size_t>(rimLines_[n]) * 3 * rim.stride + s];
    return sum;
  };
  constexpr double turn = 2e-4;
  const double radius = tiny().surfaces.radius;
  rotate(turn);
  auto patch = roll({law.normalPenalty, law.tangentialPenalty, 0});
  EXPECT_NEAR(patch.rotationMoment, patch.vertical * radius * turn, 1e-3 * patch.vertical * radius * turn);
  EXPECT_NEAR(patch.rotationMoment, moment(), 1e-5 * patch.vertical * radius * turn);
  slide(0.3);
  for (int k = 0; k < 5; ++k) patch = roll();
  EXPECT_NEAR(patch.rotationMoment, moment(), 1e-5 * std::abs(patch.rotationMoment));
}

TEST_F(RollingContactTest, SticksWithTheTangentialPenaltyBelowTheCone) {
  const double speed = 1e-3;
  slide(speed);
  PatchState patch;
  for (int k = 1; k <= 4; ++k) {
    patch = roll();
    for (const auto& p : points_) {
      const double expected = law.tangentialPenalty * speed * step * k;
      if (expected > 0.9 * law.friction * p.pressure) continue;
      EXPECT_FALSE(p.slips);
      EXPECT_NEAR(p.tractionX, expected, 1e-9 * expected);
      EXPECT_NEAR(p.tractionY, 0, 1e-12 * p.pressure);
    }
  }
  EXPECT_GT(patch.points, patch.slipping);
}

TEST_F(RollingContactTest, ReturnsToTheFrictionCone) {
  for (const double speed : {0.5, -0.5}) {
    slide(speed);
    PatchState patch;
    for (int k = 0; k < 1500; ++k) patch = roll();
    EXPECT_EQ(patch.slipping, patch.points);
    double normal = 0;
    for (const auto& p : points_) {
      EXPECT_NEAR(std::hypot(p.tractionX, p.tractionY), law.friction * p.pressure, 1e-9 * p.pressure);
      EXPECT_EQ(p.tractionX > 0, speed > 0);  // the tread drags the rail along
      normal += p.pressure * p.area;
    }
    EXPECT_NEAR(std::abs(patch.longitudinal), law.friction * normal, 1e-3 * law.friction * normal);
    // All of the sliding is dissipated: mu N times the sliding speed.
    EXPECT_NEAR(patch.frictionPower, law.friction * normal * std::abs(speed), 2e-3 * law.friction * normal * 0.5);
    EXPECT_NEAR(patch.rotationMoment, tiny().surfaces.radius * patch.longitudinal,
                1e-3 * std::abs(patch.rotationMoment));
  }
}

// Sliding across the track turns the traction: the cone is round.
TEST_F(RollingContactTest, TheConeIsRound) {
  slide(0.3);
  const auto& rim = tiny().blocks[tiny().rim];
  for (int n = 0; n < rim.nodes; ++n)
    for (int s = 0; s < rim.stationCount; ++s) velocity_[rim.index(n, 2, s)] = 0.4;
  PatchState patch;
  for (int k = 0; k < 1000; ++k) patch = roll();
  for (const auto& p : points_) {
    EXPECT_NEAR(p.tractionX, 0.6 * law.friction * p.pressure, 2e-3 * law.friction * p.pressure);
    EXPECT_NEAR(p.tractionY, 0.8 * law.friction * p.pressure, 2e-3 * law.friction * p.pressure);
  }
  EXPECT_GT(patch.lateral, 0);
}

// Per step, the work of the sliding on the patch becomes stored or dissipated energy, nothing else (pressure constant).
TEST_F(RollingContactTest, SlidingWorkIsStoredOrDissipated) {
  const double speed = 2;
  slide(speed);
  double before = roll().storedEnergy, maximum = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<double> old;
    for (const auto& p : points_) old.push_back(p.tractionX);
    const auto patch = roll();
    // Trapezoid between the tractions before and after, times the sliding distance.
    double work = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      work += 0.5 * (old[i] + points_[i].tractionX) * points_[i].area * speed * step;
    const double gone = patch.frictionPower * step, stored = patch.storedEnergy - before;
    // Trapezoid and return err by the square of one step's stick, times area over penalty.
    EXPECT_NEAR(stored + gone, work, 0.02 * std::abs(work)) << k;
    before = patch.storedEnergy, maximum = std::max(maximum, gone);
  }
  EXPECT_GT(maximum, 0);
}

TEST_F(RollingContactTest, OpenedPointsForget) {
  slide(0.3);
  for (int k = 0; k < 20; ++k) roll();
  ASSERT_FALSE(history_.closed.empty());
  lower(-1e-4);
  const auto patch = roll();
  EXPECT_EQ(patch.points, 0);
  EXPECT_EQ(patch.vertical, 0);
  EXPECT_TRUE(history_.closed.empty());
  for (const double traction : history_.traction) ASSERT_EQ(traction, 0);
  // Closed again they start from nothing.
  lower(approach);
  slide(0);
  roll();
  for (const auto& p : points_) EXPECT_LT(std::hypot(p.tractionX, p.tractionY), 1e-3 * law.friction * p.pressure);
}

// The tractions stay with the rail's points while the wheel rolls on: those that are left behind are forgotten, those
// in the patch keep what they had, new ones come in free.
TEST_F(RollingContactTest, TractionStaysWithTheMaterial) {
  slide(2e-3);
  for (int k = 0; k < 5; ++k) roll();
  const FrictionHistory before = history_;
  slide(0);
  const double distance = 0.004;
  wheel_.placement.centreX += distance;
  wheel_.placement.rotation += distance / tiny().surfaces.radius;
  lower(approach);
  roll();
  int kept = 0, fresh = 0;
  for (const std::size_t point : history_.closed) {
    const double then = before.traction[2 * point], now = history_.traction[2 * point];
    if (then == 0) {
      EXPECT_EQ(now, 0);  // no sliding any more
      ++fresh;
    } else {
      // Kept, or cut down to the cone of a pressure that has fallen.
      EXPECT_LE(now, then * (1 + 1e-2));
      kept += std::abs(now - then) < 1e-2 * then;
    }
  }
  EXPECT_GT(kept, 2);
  EXPECT_GT(fresh, 0);
  for (const std::size_t point : before.closed) {
    const bool still = std::find(history_.closed.begin(), history_.closed.end(), point) != history_.closed.end();
    if (!still) {
      EXPECT_EQ(history_.traction[2 * point], 0);
    }
  }
}

// Half axes by moments: for a paraboloid of pressure (Winkler), <x^2> = a^2 / 6, so length = 2 sqrt(5/6) a.
TEST_F(RollingContactTest, PatchSizeComesFromThePressuresMoments) {
  const auto patch = roll();
  const double a = std::sqrt(2 * tiny().surfaces.radius * approach), b = std::sqrt(2 * 0.3 * approach);
  // Elements of 5 mm in a patch of 17 x 14 mm.
  EXPECT_NEAR(patch.length, 2 * std::sqrt(5.0 / 6) * a, 0.1 * 2 * a);
  EXPECT_NEAR(patch.width, 2 * std::sqrt(5.0 / 6) * b, 0.1 * 2 * b);
}

}  // namespace
}  // namespace squat::contact
