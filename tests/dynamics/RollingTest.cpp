// The central difference of the whole model: same bits for any number of threads, steady rolling, restored states.
#include "dynamics/Rolling.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "dynamics/StableStep.h"
#include "elasticity/SelectiveMassScaling.h"
#include "statics/SteadyRollingStart.h"
#include "verification/StepBlocks.h"

namespace squat::dynamics {
namespace {

struct Started {
  model::Model model;
  StableStep stable;
  statics::SteadyRollingStart start;
};

const Started& smooth() {
  static const Started started = [] {
    Started s;
    s.model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
    ThreadTeam team(1);
    Monitor quiet;
    s.stable = stableStep(s.model, elasticity::kernelsFor(""), team, quiet);
    s.start = statics::prepareSteadyRollingStart(s.model, elasticity::kernelsFor(""), team, quiet);
    return s;
  }();
  return started;
}

double weight() {
  const auto& d = smooth().model.scenario;
  return d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
}

double rollingAngularVelocity() {
  const auto& d = smooth().model.scenario;
  return d.motion.speed / d.wheelset.radius;
}

RollingState rolled(int threads, long steps, const std::string& isa = "") {
  ThreadTeam team(threads);
  Rolling rolling(smooth().model, elasticity::kernelsFor(isa), team, smooth().stable.step, smooth().stable.beta);
  rolling.start(smooth().start.equilibrium.displacement, smooth().start.velocity, rollingAngularVelocity());
  rolling.advance(steps, [](const StepView&) {});
  return rolling.state();
}

void expectSame(const RollingState& a, const RollingState& b) {
  EXPECT_EQ(a.displaced, b.displaced);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.friction.traction, b.friction.traction);
  EXPECT_EQ(a.friction.closed, b.friction.closed);
  EXPECT_EQ(a.angularVelocity, b.angularVelocity);
  EXPECT_EQ(a.rotation, b.rotation);
  EXPECT_EQ(a.sums.friction, b.sums.friction);
  EXPECT_EQ(a.sums.damping, b.sums.damping);
  EXPECT_EQ(a.sums.torqueWork, b.sums.torqueWork);
}

TEST(Rolling, SameBitsForAnyNumberOfThreads) {
  // Few steps: threads that meet in every step crawl where other programs hold the cores.
  const RollingState one = rolled(1, 8);
  EXPECT_EQ(one.step, 8);
  for (const int threads : {2, 3}) expectSame(rolled(threads, 8), one);
}

TEST(Rolling, SameBitsFromRunToRun) { expectSame(rolled(1, 25), rolled(1, 25)); }

TEST(Rolling, ResumesFromARestoredStateWithTheSameBits) {
  const RollingState whole = rolled(1, 60);
  ThreadTeam team(1);
  Rolling rolling(smooth().model, elasticity::kernelsFor(""), team, smooth().stable.step, smooth().stable.beta);
  rolling.restore(rolled(1, 35));
  rolling.advance(25, [](const StepView&) {});
  expectSame(rolling.state(), whole);
}

// From the equilibrium with the velocities of rolling, nothing happens at first: the force stays the weight. Over 1 ms
// the torque is still below 7 % of its value. Tolerance 5 % of the weight: elements of 5 mm pass every 0.17 ms, and
// each lets the force swing.
TEST(Rolling, StartsRollingSteadily) {
  ThreadTeam team(1);
  Rolling rolling(smooth().model, elasticity::kernelsFor(""), team, smooth().stable.step, smooth().stable.beta);
  rolling.start(smooth().start.equilibrium.displacement, smooth().start.velocity, rollingAngularVelocity());
  double first = 0, sum = 0;
  long count = 0, lost = 0;
  rolling.advance(static_cast<long>(1e-3 / smooth().stable.step), [&](const StepView& view) {
    if (count == 0) first = view.patch.vertical;
    sum += view.patch.vertical, ++count;
    lost += view.patch.points == 0;
  });
  EXPECT_EQ(lost, 0);
  EXPECT_NEAR(first, weight(), 1e-3 * weight());
  EXPECT_NEAR(sum / static_cast<double>(count), weight(), 0.05 * weight());
  // What closed contact adds to the nodes' masses is felt by nothing: accelerations change by its share in the
  // wheelset, a fiftieth of the half percent that the axle box acceleration may.
  EXPECT_GT(rolling.contactInertia(), 0);
  EXPECT_LT(rolling.contactInertia(), 1e-4 * smooth().model.scenario.wheelset.totalMass);
  // It has gone on: speed times time, but for the give of the guidance.
  EXPECT_NEAR(rolling.view().position - smooth().model.startX, 30 * rolling.state().time, 1e-4);
  EXPECT_NEAR(rolling.state().angularVelocity, rollingAngularVelocity(), 1e-3 * rollingAngularVelocity());
}

// The stable step against the highest frequency of the bare rail by power steps, all waves with their own inertia:
// contact and pads only add to it, and both come from below; 0.1 % for what the Lanczos steps leave.
TEST(StableStep, CoversTheBareRail) {
  const auto model = model::buildModel(
      cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"mesh.selective_inertia", "false"}}}));
  ThreadTeam team(1);
  Monitor quiet;
  const auto stable = stableStep(model, elasticity::kernelsFor(""), team, quiet);
  auto rail = model.blocks[model.rail];
  elasticity::FreeBlocks bare({rail});
  EXPECT_GT(stable.highestFrequency, std::sqrt(bare.highestEigenvalue(300)) * (1 - 1e-3));
  const double z = stable.beta * stable.highestFrequency / 2;
  EXPECT_NEAR(z, model.scenario.damping.fraction, 1e-12);
  EXPECT_NEAR(stable.step, 0.95 * 2 / stable.highestFrequency * (std::sqrt(1 + z * z) - z), 1e-12 * stable.step);
  EXPECT_FALSE(stable.location.empty());
  // Slower short waves change nothing else: the damping is that of the mesh as it is, within what the Lanczos steps
  // leave of the frequency.
  EXPECT_NEAR(smooth().stable.beta, stable.beta, 2e-4 * stable.beta);
  // Slower short waves make it longer by half and more.
  EXPECT_GT(smooth().stable.step, 1.5 * stable.step);
}

// A progressive pad may come to stand on any slope of its curve: the steepest bounds the step, as if the pad were
// linear with it. No pad of a case is stiff enough to bind; these are, a thousand times over. 0.1 % for what the
// Lanczos steps leave.
TEST(StableStep, FollowsTheStiffestTangent) {
  const auto stepOf = [](const char* key, const char* value) {
    auto model = model::buildModel(cases::loadScenario("smooth-rail", {"tiny", {{key, value}}}));
    for (auto& set : model.forceElements) {
      if (set.kind != forces::Kind::railPad) continue;
      const bool isAlongCurve = set.law.has_value(), isWhole = !isAlongCurve && key == std::string("pad.stiffness");
      for (std::size_t i = 0; i < set.size(); ++i)
        if (isAlongCurve || (isWhole && i % 3 == 2)) set.stiffness[i] *= 1000;  // the vertical ones
    }
    ThreadTeam team(1);
    Monitor quiet;
    return stableStep(model, elasticity::kernelsFor(""), team, quiet).step;
  };
  const double linear = stepOf("pad.stiffness", "20000");
  EXPECT_LT(linear, 0.95 * smooth().stable.step);
  EXPECT_NEAR(stepOf("pad.curve", "[[0, 0], [0.1, 10], [0.2, 2010]]"), linear, 1e-3 * linear);
}

// M_e^-1 w of a spring's weights w, M_e with the inertia of short waves.
AlignedVector accelerationBy(const model::Model& model, const forces::ForceElements& springs, std::size_t spring) {
  AlignedVector a(model.stateSize, 0.0);
  for (std::size_t t = springs.start[spring]; t < springs.start[spring + 1]; ++t)
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const auto& block = model.blocks[b];
      const std::size_t i = springs.unknown[t];
      if (i < block.offset || i >= block.offset + block.size()) continue;
      const auto at = block.unknownAt(i);
      a[i] +=
          springs.weight[t] *
          model.inverseMass[b][static_cast<std::size_t>(at.node) * block.stride + static_cast<std::size_t>(at.station)];
    }
  for (const auto& block : model.blocks) elasticity::slowShortWaves(block, a.data() + block.offset);
  return a;
}

// Highest eigenvalue [1/s] of M_e^-1 C, C all dashpots between rail, sleepers and ground: it is that of the small
// matrix sqrt(c_i c_j) w_i . M_e^-1 w_j.
double fastestDashpots(const model::Model& model) {
  std::vector<std::pair<const forces::ForceElements*, std::size_t>> dashpots;
  for (const auto& set : model.forceElements)
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set.damping[i] > 0 && set.kind != forces::Kind::primarySuspension) dashpots.emplace_back(&set, i);
  const auto n = static_cast<Eigen::Index>(dashpots.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto& [set, spring] = dashpots[static_cast<std::size_t>(j)];
    const auto a = accelerationBy(model, *set, spring);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [other, at] = dashpots[static_cast<std::size_t>(i)];
      matrix(i, j) = std::sqrt(other->damping[at] * set->damping[spring]) * other->elongation(at, a.data());
    }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().maxCoeff();
}

// Dashpots are driven by the velocity of the half step before: 4 M - (dt^2 + 2 beta dt) K - 2 dt C must be positive
// definite. With w^2 the highest eigenvalue of M^-1 K and g that of M^-1 C the step's bound lies therefore below 2 / g
// and not below the dt of (dt^2 + 2 beta dt) w^2 + 2 dt g = 4, where both highest modes were one. With the strongest
// pads of the case's range dashpots bind. At the step found the rail moves as it should; at that of the solids it flies
// apart.
TEST(StableStep, FollowsStrongDashpots) {
  const auto model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"pad.damping", "2000"}}}));
  const auto kernels = elasticity::kernelsFor("");
  ThreadTeam team(1);
  Monitor quiet;
  const auto stable = stableStep(model, kernels, team, quiet);
  const double g = fastestDashpots(model), w2 = stable.highestFrequency * stable.highestFrequency;
  EXPECT_LT(0.95 * 2 / g, 0.9 * smooth().stable.step) << "the dashpots do not bind";
  const double b = stable.beta + g / w2;
  const double lower = std::sqrt(b * b + 4 / w2) - b;
  std::printf("stable step %.4g us, between %.4g and %.4g us\n", 1e6 * stable.step, 0.95e6 * lower, 0.95 * 2e6 / g);
  // 0.1 % for where the search for the bound stops, and for what the Lanczos steps leave.
  EXPECT_LT(stable.step, 0.95 * 2 / g * (1 + 2e-3));
  EXPECT_GT(stable.step, 0.95 * lower * (1 - 2e-3));
  EXPECT_NE(stable.location.find("dampers"), std::string::npos) << stable.location;
  EXPECT_EQ(smooth().stable.location.find("dampers"), std::string::npos) << smooth().stable.location;

  const auto fastest = [&](double step, long steps) {
    Rolling rolling(model, kernels, team, step, stable.beta);
    rolling.start(smooth().start.equilibrium.displacement, smooth().start.velocity, rollingAngularVelocity());
    rolling.advance(steps, [](const StepView&) {});
    const auto& rail = model.blocks[model.rail];
    double maximum = 0;
    for (std::size_t i = 0; i < rail.size(); ++i)
      maximum = std::max(maximum, std::abs(rolling.state().velocity[rail.offset + i]));
    return maximum;
  };
  // The rail under a wheel at 30 m/s moves by less than half a metre a second.
  EXPECT_LT(fastest(stable.step, 400), 0.5);
  EXPECT_GT(fastest(smooth().stable.step, 60), 100);
}

}  // namespace
}  // namespace squat::dynamics
