// The operator of the whole model: symmetry, rigid motions of the wheelset through the tie, weight.
#include "model/StaticOperator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::model {
namespace {

const Model& tiny() {
  static const Model model = buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  return model;
}

double dot(const AlignedVector& a, const AlignedVector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST(StaticOperator, IsSymmetricAndPositive) {
  ThreadTeam team(1);
  StaticOperator op(tiny(), elasticity::kernelsFor(""), team, 0.3, 1e8, true);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> value(-1, 1);
  const std::size_t n = tiny().stateSize;
  AlignedVector a(n, 0.0), b(n, 0.0), ka(n, 0.0), kb(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    if (op.freeUnknowns()[i]) a[i] = value(generator), b[i] = value(generator);
  AlignedVector ua = a, ub = b;  // apply() fills the slaves
  op.apply(ua.data(), ka.data());
  op.apply(ub.data(), kb.data());
  const double size = std::sqrt(dot(a, ka) * dot(b, kb));
  EXPECT_GT(dot(a, ka), 0);
  EXPECT_NEAR(dot(a, kb), dot(b, ka), 1e-12 * size);
}

// What the preconditioner takes for e.K e. Where a unit displacement moves no tied node it is that to rounding.
TEST(StaticOperator, DiagonalIsThatOfTheOperator) {
  ThreadTeam team(1);
  const auto& model = tiny();
  StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 0, true);
  const auto diagonal = op.diagonal();
  for (const auto& [b, node] : {std::pair{model.rail, 3}, std::pair{model.rim, 0}, std::pair{model.firstSleeper, 2}})
    for (int c = 0; c < 3; ++c)
      if (const auto index = model.blocks[b].index(node, c, 5); op.freeUnknowns()[index]) {
        AlignedVector u(model.stateSize, 0.0), f(model.stateSize, 0.0);
        u[index] = 1;
        op.apply(u.data(), f.data());
        EXPECT_NEAR(diagonal[index] / f[index], 1, 1e-12);
      }
}

// A master of the tie also moves nodes of the rim's inner side. The diagonal sees them node by node, without what
// neighbours do to each other: the master's own stiffness and, times the square of its share in each, theirs. Shares
// and stiffnesses are taken from the operator itself, with the tie and without it.
TEST(StaticOperator, DiagonalKnowsWhatTheMastersOfTheTieCarry) {
  ThreadTeam team(1);
  const auto& model = tiny();
  Model untied = model;
  untied.ties.clear();
  for (auto& tied : untied.slave) std::fill(tied.begin(), tied.end(), 0);
  StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 0, true);
  StaticOperator alone(untied, elasticity::kernelsFor(""), team, 0, 0, true);
  const auto diagonal = op.diagonal(), own = alone.diagonal();
  const auto& tie = model.ties.front();
  const auto& body = model.blocks[tie.masterBlock];
  for (const auto& column : tie.columns)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; s < body.intervals; s += 5) {
        const auto index = body.index(column.outer, c, s);
        AlignedVector u(model.stateSize, 0.0), f(model.stateSize, 0.0);
        u[index] = 1;
        op.apply(u.data(), f.data());  // fills the slaves: their shares
        double expected = 0;
        for (std::size_t i = 0; i < u.size(); ++i) expected += u[i] * u[i] * own[i];
        // A share that comes by two ways is squared way by way, which is less than the square of their sum.
        EXPECT_GT(diagonal[index], 0.9 * expected) << column.outer << " " << c << " " << s;
        EXPECT_LT(diagonal[index], (1 + 1e-9) * expected) << column.outer << " " << c << " " << s;
        // The tie matters: what it carries is at least half of what the master has of its own.
        EXPECT_GT(expected, 1.5 * own[index]) << column.outer << " " << c << " " << s;
      }
}

// The wheelset with its springs taken away has the rigid motions that the symmetry plane leaves: along x, along z and
// the turn about its axis. Rim and body are joined by the tie.
TEST(StaticOperator, WheelsetMovesRigidlyThroughTheTie) {
  Model model = tiny();
  for (auto& set : model.forceElements)
    if (set.kind == forces::Kind::primarySuspension) std::fill(set.stiffness.begin(), set.stiffness.end(), 0.0);
  ThreadTeam team(1);
  StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 0, true);
  for (int motion = 0; motion < 4; ++motion) {
    AlignedVector u(model.stateSize, 0.0), f(model.stateSize, 0.0);
    for (const int b : {model.rim, model.body}) {
      const auto& block = model.blocks[b];
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s) {
          const Eigen::Vector3d global(motion == 0, 0, motion == 1);
          Eigen::Vector3d local = elasticity::localBasis(block, block.positions[s]).transpose() * global;
          if (motion == 2) local[0] = block.section.nodes[n][0];  // turn about the axis
          if (motion == 3) local[1] = block.section.nodes[n][0];  // blown up like a balloon: not rigid
          for (int c = 0; c < 3; ++c) u[block.index(n, c, s)] = local[c];
        }
    }
    op.apply(u.data(), f.data());
    double maximum = 0;
    for (const double v : f) maximum = std::max(maximum, std::abs(v));
    // Stiffnesses at single nodes are of the order of E times 0.1 m.
    const double stiff = 210e9 * 0.1;
    if (motion < 3) {
      EXPECT_LT(maximum, 1e-12 * stiff) << "motion " << motion;
    } else {
      EXPECT_GT(maximum, 1e-3 * stiff);
    }
  }
}

// Gravity adds up to the weight: of wheelset (950 kg as the case says) and sprung mass, rail and sleepers.
TEST(StaticOperator, GravityIsTheWeightOfEverything) {
  const auto& model = tiny();
  const auto& d = model.scenario;
  for (const double rotation : {0.0, 0.7}) {
    const AlignedVector load = gravityForces(model, rotation);
    Eigen::Vector3d wheelset = Eigen::Vector3d::Zero(), track = Eigen::Vector3d::Zero();
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const auto& block = model.blocks[b];
      const bool turns = static_cast<int>(b) == model.rim || static_cast<int>(b) == model.body;
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s) {
          const Eigen::Vector3d local(load[block.index(n, 0, s)], load[block.index(n, 1, s)],
                                      load[block.index(n, 2, s)]);
          (turns ? wheelset : track) +=
              elasticity::localBasis(block, block.positions[s] - (turns ? rotation : 0)) * local;
        }
    }
    const double g = d.motion.gravity;
    EXPECT_NEAR(-wheelset[2], g * d.wheelset.totalMass, 1e-9 * g * d.wheelset.totalMass);
    EXPECT_LT(std::hypot(wheelset[0], wheelset[1]), 1e-8 * g * d.wheelset.totalMass);
    // 54.4 kg a metre (7800 kg/m3 times 69.77 cm2), the coarse section within 1 %; half sleepers of the case's block.
    const auto& s = d.sleeper;
    const double sleeper = s.material.density * s.halfLength * s.width * s.height;
    const double expected = g * (7800 * 69.77e-4 * d.track.length + model.sleepers * sleeper);
    EXPECT_NEAR(-track[2], expected, 0.01 * expected);
  }
}

TEST(StaticOperator, TieKeepsTheMass) {
  const auto& model = tiny();
  double solid = 0, all = 0, inertia = 0;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (const double m : elasticity::lumpedMass(block)) solid += m;
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) {
        const double m = model.mass[b][n * block.stride + s];
        EXPECT_GE(m, 0);
        all += m, inertia += m * std::pow(block.section.nodes[n][0], 2);
      }
  }
  EXPECT_NEAR(solid, model.wheelset.solidMass, 1e-9 * solid);
  EXPECT_NEAR(all, model.scenario.wheelset.totalMass, 1e-9 * all);
  EXPECT_NEAR(inertia, model.wheelset.inertia, 1e-9 * inertia);
}

}  // namespace
}  // namespace squat::model
