// Runs that diverge, provoked by checkpoints that were tampered with: each is stopped within a few steps, says where,
// keeps the signals so far and the last good checkpoint. And checkpoints that do not fit: refused by the array's name.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "model/Model.h"
#include "results/Checkpoint.h"
#include "results/SampleResult.h"
#include "results/TreeStream.h"
#include "simulation/RunCase.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using results::ArrayTree;
using results::RunResult;
using ::testing::HasSubstr;
using tests::TemporaryFolder;

cases::CaseDescription shortCase() {
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  overrides.values = tests::shortSets();
  return cases::loadCase(tests::fixtureCase("light-defect"), overrides);
}

// The second wheelset rolls 2.5 m behind the first one.
cases::CaseDescription shortBogie() {
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  overrides.values = tests::shortSets();
  overrides.values.insert(overrides.values.end(), {{"bogie.wheelbase", "2.5"}, {"track.length", "7.8"}});
  return cases::loadCase(tests::fixtureCase("light-defect"), overrides);
}

class StopInTheMiddle : public Monitor {
 public:
  void report(const Progress& progress) override { stop_ = progress.phase == "rolling" && progress.fraction > 0.4; }
  bool cancelled() override { return stop_; }

 private:
  bool stop_ = false;
};

// A good checkpoint from the middle of a run.
ArrayTree stateInTheMiddle(const cases::CaseDescription& description) {
  const TemporaryFolder folder;
  simulation::RunOptions options;
  options.threads = 1;
  options.checkpointPath = folder / "run.checkpoint";
  StopInTheMiddle monitor;
  simulation::runCase(description, options, monitor);
  return results::readCheckpoint(options.checkpointPath).value();
}

// That of the short case, made once.
const ArrayTree& goodState() {
  static const ArrayTree state = stateInTheMiddle(shortCase());
  return state;
}

std::vector<double>& numbers(ArrayTree& tree, const std::string& path) {
  return std::get<std::vector<double>>(tree.find(path)->values);
}

struct Outcome {
  std::string error = "none", location;
  long begun = 0, step = 0;
  RunResult partial;
};

// Resumes from a checkpoint that `change` has spoilt.
Outcome resume(const TemporaryFolder& folder, const cases::CaseDescription& description, ArrayTree state,
               const std::function<void(ArrayTree&)>& change) {
  Outcome outcome;
  outcome.begun = static_cast<long>(numbers(state, "/rolling/scalars")[0]);
  change(state);
  simulation::RunOptions options;
  options.threads = 1;
  options.resume = true;
  options.checkpointPath = folder / "run.checkpoint";
  options.checkpointSeconds = 0;  // after every step that is asked
  results::writeCheckpoint(options.checkpointPath, state);
  Monitor monitor;
  try {
    simulation::runCase(description, options, monitor, &outcome.partial);
  } catch (const RunError& error) {
    outcome.error = error.what();
    outcome.location = error.location();
    outcome.step = error.step();
  } catch (const FileError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

Outcome resume(const TemporaryFolder& folder, const std::function<void(ArrayTree&)>& change) {
  return resume(folder, shortCase(), goodState(), change);
}

void expectStoppedSoon(const TemporaryFolder& folder, const std::string& what, const Outcome& outcome) {
  EXPECT_THAT(outcome.error, HasSubstr(what));
  EXPECT_THAT(outcome.error, HasSubstr("step"));
  EXPECT_LE(outcome.step - outcome.begun, 500)
      << "the energy balance is looked at every five output samples of about 80 steps";
  EXPECT_FALSE(outcome.partial.complete);
  EXPECT_THAT(outcome.partial.stopReason, HasSubstr("failed"));
  EXPECT_GT(outcome.partial.time.size(), 10U) << "the signals so far are kept";
  const auto kept = results::readCheckpoint(folder / "run.checkpoint");
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(results::firstNotFinite(*kept), "");
}

TEST(Divergence, AVelocityBeyondEverythingIsCaught) {
  const TemporaryFolder folder;
  expectStoppedSoon(folder, "diverges", resume(folder, [](ArrayTree& state) {
                      auto& velocity = numbers(state, "/rolling/velocity");
                      for (double& value : velocity) value *= 1e200;
                    }));
}

// The wheelset dropped by 3 mm as a whole: no element is strained, so it is the contact that must notice.
TEST(Divergence, RunawayPenetrationIsCaught) {
  constexpr double drop = 3e-3;
  const auto model = model::buildModel(cases::resolve(shortCase()));
  const TemporaryFolder folder;
  expectStoppedSoon(folder, "runaway penetration", resume(folder, [&](ArrayTree& state) {
                      const double rotation = numbers(state, "/rolling/scalars")[2];
                      auto& displaced = numbers(state, "/rolling/displaced");
                      for (const int b : {model.rim, model.body}) {
                        const auto& block = model.blocks[b];
                        for (int n = 0; n < block.nodes; ++n)
                          for (int s = 0; s <= block.intervals; ++s) {
                            const double angle = block.positions[s] - rotation;
                            displaced[block.index(n, 0, s)] -= drop * std::sin(angle);
                            displaced[block.index(n, 1, s)] += drop * std::cos(angle);
                          }
                      }
                    }));
}

// Of a bogie, the place is that of the second wheelset where its values are the largest ones: the wheels rolled from
// -2.54 to -2.48 m, and were on their way. Its state begins with two sums, rigid displacement and velocity.
TEST(Divergence, TheSecondWheelsetIsNamed) {
  const auto bogie = shortBogie();
  const auto good = stateInTheMiddle(bogie);
  const auto spoil = [&](const TemporaryFolder& folder, std::size_t which, double by) {
    return resume(folder, bogie, good,
                  [&](ArrayTree& state) { numbers(state, "/rolling/second_wheelset")[which] += by; });
  };
  const auto placeIn = [](const std::string& location) {
    const std::string before = "of the second wheelset at x ";
    const auto at = location.find(before);
    return at == std::string::npos ? 0.0 : std::stod(location.substr(at + before.size()));
  };
  const auto isUnderWay = ::testing::AllOf(::testing::Gt(-2.54), ::testing::Lt(-2.48));
  {
    const TemporaryFolder folder;
    const auto outcome = spoil(folder, 3, 1e6);
    expectStoppedSoon(folder, "diverges", outcome);
    EXPECT_THAT(outcome.location, ::testing::AnyOf(::testing::StartsWith("wheel"), ::testing::StartsWith("axle box")));
    EXPECT_THAT(placeIn(outcome.location), isUnderWay) << outcome.error;
  }
  {  // a drop by 3 mm, as of the first wheelset below
    const TemporaryFolder folder;
    const auto outcome = spoil(folder, 2, -3e-3);
    expectStoppedSoon(folder, "runaway penetration of 3.", outcome);
    EXPECT_THAT(outcome.location, ::testing::StartsWith("contact"));
    EXPECT_THAT(placeIn(outcome.location), isUnderWay) << outcome.error;
  }
  // Values of the first wheelset lie elsewhere.
  const TemporaryFolder folder;
  const auto outcome = resume(folder, bogie, good, [](ArrayTree& state) {
    for (double& value : numbers(state, "/rolling/velocity")) value *= 1e200;
  });
  expectStoppedSoon(folder, "diverges", outcome);
  EXPECT_THAT(outcome.location, ::testing::Not(HasSubstr("second wheelset")));
}

// One node drawn through its neighbour, three intervals along the rail. The state is judged before its first step: the
// elastic forces would spread such a kink within a few steps.
TEST(Divergence, AnElementTurnedInsideOutIsCaught) {
  const auto model = model::buildModel(cases::resolve(shortCase()));
  const auto& rail = model.blocks[model.rail];
  const int node = rail.section.quads[rail.section.quads.size() / 2][0], station = rail.intervals / 2;
  const double interval = rail.positions[station + 1] - rail.positions[station];
  const TemporaryFolder folder;
  const auto outcome = resume(folder, [&](ArrayTree& state) {
    numbers(state, "/rolling/displaced")[rail.index(node, 0, station)] += 3 * interval;
  });
  expectStoppedSoon(folder, "turned inside out", outcome);
  EXPECT_THAT(outcome.error, HasSubstr("rail"));
}

TEST(Divergence, ACheckpointWithANotANumberIsRefused) {
  const TemporaryFolder folder;
  auto state = goodState();
  numbers(state, "/rolling/velocity")[1000] = std::nan("");
  EXPECT_THROW(results::writeCheckpoint(folder / "run.checkpoint", state), FileError);
  writeDurably(folder / "run.checkpoint", results::encodeTree(state));
  simulation::RunOptions options;
  options.threads = 1;
  options.resume = true;
  options.checkpointPath = folder / "run.checkpoint";
  Monitor monitor;
  try {
    simulation::runCase(shortCase(), options, monitor);
    FAIL() << "went on";
  } catch (const FileError& error) {
    EXPECT_EQ(error.location(), "/rolling/velocity");
  }
}

// Near equilibrium the energy is stationary: stretching all displacements by 20 % adds 4 % of the strain energy.
TEST(Divergence, EnergyFromNowhereIsCaught) {
  const TemporaryFolder folder;
  expectStoppedSoon(folder, "energy balance", resume(folder, [](ArrayTree& state) {
                      for (double& value : numbers(state, "/rolling/displaced")) value *= 1.2;
                    }));
}

TEST(HostileCheckpoint, WhatDoesNotFitIsRefusedByName) {
  const auto refusal = [](const std::function<void(ArrayTree&)>& change) {
    const TemporaryFolder folder;
    return resume(folder, change).error;
  };
  EXPECT_THAT(refusal([](ArrayTree& s) {
                numbers(s, "/rolling/velocity").resize(10);
                s.find("/rolling/velocity")->shape = {10};
              }),
              HasSubstr("/rolling/velocity"));
  EXPECT_THAT(refusal([](ArrayTree& s) {
                s.find("/rolling/closed")->values = std::vector<std::int64_t>{1LL << 40};
                s.find("/rolling/closed")->shape = {1};
              }),
              HasSubstr("/rolling/closed"));
  EXPECT_THAT(refusal([](ArrayTree& s) { numbers(s, "/rolling/scalars")[0] = -5; }), HasSubstr("/rolling/scalars"));
  // Time, rotation and angular velocity: a search around the wheel would take its turns one by one.
  for (const std::size_t which : {1u, 2u, 3u})
    for (const double value : {1e300, -1e9})
      EXPECT_THAT(refusal([&](ArrayTree& s) { numbers(s, "/rolling/scalars")[which] = value; }),
                  HasSubstr("/rolling/scalars"))
          << which << ", " << value;
  // Moments that would turn the wheel as fast in one step.
  for (const std::size_t which : {7u, 8u})
    EXPECT_THAT(refusal([&](ArrayTree& s) { numbers(s, "/rolling/scalars")[which] = -1e300; }),
                HasSubstr("/rolling/scalars"))
        << which;
  // As many steps a sample as no filter's memory holds.
  EXPECT_THAT(refusal([](ArrayTree& s) {
                auto& steps = numbers(s, "/steps");
                steps[1] *= steps[0] / 1e8, steps[0] = 1e8;
              }),
              HasSubstr("/steps"));
  EXPECT_THAT(refusal([](ArrayTree& s) { numbers(s, "/recorder/pushed")[0] += 1000; }), HasSubstr("/recorder"));
  EXPECT_THAT(refusal([](ArrayTree& s) {
                numbers(s, "/energy_balance").resize(5);
                s.find("/energy_balance")->shape = {5};
              }),
              HasSubstr("/energy_balance"));
  EXPECT_THAT(refusal([](ArrayTree& s) { numbers(s, "/steps")[0] += 1; }), HasSubstr("/steps"));
  EXPECT_THAT(refusal([](ArrayTree& s) {
                s.find("/rolling/displaced")->values = std::vector<float>{};
                s.find("/rolling/displaced")->shape = {0};
              }),
              HasSubstr("/rolling/displaced"));
}

}  // namespace
}  // namespace squat
