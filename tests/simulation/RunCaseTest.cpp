// The whole way through on the tiny mesh: what a run promises, seen from outside.
#include "case/CaseDescription.h"
#include "simulation/RunCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "simulation/StoppedRuns.h"
#include "statements/RunChecks.h"
#include "verification/Seen.h"

namespace squat {
namespace {

using tests::CancelAt;

using Overrides = std::vector<std::pair<std::string, std::string>>;

cases::CaseDescription tinyCase(const std::string& name, Overrides values = {}) {
  values.insert(values.begin(), {"motion.beyond", "0.05"});
  return cases::loadCase(tests::fixtureCase(name), {"tiny", values});
}

simulation::RunOptions plain(int threads = 1) {
  simulation::RunOptions options;
  options.threads = threads;
  options.wheelsetModes = false;
  options.snapshots = false;
  return options;
}

results::RunResult run(const cases::CaseDescription& description, const simulation::RunOptions& options = plain()) {
  Monitor silent;
  return simulation::runCase(description, options, silent);
}

double scalar(const std::vector<results::Scalar>& list, const std::string& name) {
  for (const auto& item : list)
    if (item.name == name) return item.value;
  ADD_FAILURE() << name << " is missing";
  return 0;
}

double largest(const std::vector<double>& values) {
  double maximum = 0;
  for (const double v : values) maximum = std::max(maximum, std::abs(v));
  return maximum;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double maximum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) maximum = std::max(maximum, std::abs(a[i] - b[i]));
  return maximum;
}

const results::RunResult& lightDefect() {
  static const results::RunResult result = run(tinyCase("light-defect"));
  return result;
}

TEST(RunCase, ContactCarriesTheWeight) {
  const auto& r = lightDefect();
  ASSERT_TRUE(r.complete);
  // Statics: what the wheelset and the sprung mass weigh, 9.81 m/s2 times 8950 kg; the issue of tolerance is the
  // solver's residual, 1e-6 of the load.
  const double weight = 9.81 * (8000 + 950);
  EXPECT_NEAR(scalar(r.equilibrium, "contact_force") / weight, 1, 1e-6);
  // The solver stops anywhere below its tolerance: stated is the tolerance.
  verification::seen("force", 100 * std::max(1e-6, std::abs(scalar(r.equilibrium, "contact_force") / weight - 1)), "%");
}

TEST(RunCase, EnergyIsAccountedFor) {
  // 0.1 % of the strain energy at the start plus all dissipation.
  const double residual = scalar(lightDefect().performance, "energy_residual");
  EXPECT_LT(residual, 1e-3);
  verification::seen("energy balance", 100 * residual, "%");
}

// A run is judged by its residual vibration, 5 m/s2 at most. Nearer to the sleeper at 0 the wheel passes over its
// stiffness: v2 d2z/dx2 of the deflected rail is -9 m/s2 there, which no start takes away.
TEST(RunCase, SmoothRailHasLittleResidualVibration) {
  const auto r = run(tinyCase("smooth-rail", {{"motion.beyond", "0.05"}}));
  const auto vibration = statements::residualVibration(r);
  ASSERT_TRUE(vibration);
  EXPECT_GT(vibration->length, 0.05);
  EXPECT_LT(vibration->largest, 5.0);
}

// Every solid is one: a stiffer solid must be felt at the axle box. A spring or a rigid body in its place would not
// change.
class EverySolidIsOne : public ::testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(EverySolidIsOne, FourTimesTheModulusChangesTheAxleBoxAcceleration) {
  const auto& [key, value] = GetParam();
  const auto stiff = run(tinyCase("light-defect", {{key, value}}));
  const auto &before = *lightDefect().signal("aba_filtered"), &after = *stiff.signal("aba_filtered");
  // Four times as stiff, the modes of a solid are up to twice as high: within a period of the slower ones both signals
  // stand against each other, so that they differ by as much as the solid takes part in them. Seen: rail 0.6 of the
  // peak (its pads stay as soft as they are), sleepers 0.9, wheelset 3.3; asked for is half of the least. Another time
  // step changes 0.004 at most (mesh.selective_inertia).
  const double change = largestDifference(before, after) / largest(before);
  EXPECT_GT(change, 0.3) << key;
  verification::seen(key.substr(0, key.find('.')), 100 * change, "% of the peak", verification::Worse::smaller);
}

INSTANTIATE_TEST_SUITE_P(Solids, EverySolidIsOne,
                         ::testing::Values(std::pair<std::string, std::string>{"rail.young_modulus", "840"},
                                           std::pair<std::string, std::string>{"wheelset.young_modulus", "840"},
                                           std::pair<std::string, std::string>{"sleeper.young_modulus", "153.6"}),
                         [](const auto& solid) { return solid.param.first.substr(0, solid.param.first.find('.')); });

double lastOf(const results::RunResult& result, const std::string& name) {
  for (const auto& channel : result.energy)
    if (channel.name == name) return channel.values.back();
  ADD_FAILURE() << name << " is missing";
  return 0;
}

// Solids and springs are all that is strained: together they hold what the energy balance counts at the end. Each solid
// holds what it holds under a wheel that stands there (energies of solids at rest:
// Equilibrium.EverySolidStoresWhatItsModulus Says), but for the wheel's vibration.
TEST(RunCase, StrainEnergiesOfTheSolidsAreInTheEnergyBalance) {
  const auto& r = lightDefect();
  double sum = 0;
  for (const char* name :
       {"strain_energy_rail", "strain_energy_wheelset", "strain_energy_sleepers", "strain_energy_springs"}) {
    sum += scalar(r.equilibrium, name);
  }
  EXPECT_NEAR(sum, lastOf(r, "strain"), 1e-9 * sum);
}

TEST(RunCase, SameBitsForAnyNumberOfThreads) {
  const Overrides brief{{"motion.run_up", "0.08"}, {"motion.beyond", "0.05"}};
  const auto one = run(tinyCase("light-defect", brief));
  for (const int threads : {2, 3}) {
    const auto other = run(tinyCase("light-defect", brief), plain(threads));
    ASSERT_EQ(one.signals.size(), other.signals.size());
    for (std::size_t c = 0; c < one.signals.size(); ++c)
      EXPECT_EQ(one.signals[c].values, other.signals[c].values) << one.signals[c].name << ", " << threads << " threads";
    EXPECT_EQ(one.energy.back().values, other.energy.back().values);
  }
}

TEST(RunCase, CancelKeepsWhatThereIs) {
  Monitor silent;
  CancelAt half(0.5);
  const auto r = simulation::runCase(tinyCase("light-defect"), plain(), half);
  EXPECT_FALSE(r.complete);
  EXPECT_EQ(r.stopReason, "cancelled");
  EXPECT_GT(r.time.size(), 50u);
  EXPECT_LT(r.time.size(), lightDefect().time.size());
}

// The live acceleration lags by its filter: it is told with the place that it belongs to, as it will be stored.
TEST(RunCase, LiveAccelerationStandsAtItsPlace) {
  struct Last : CancelAt {
    using CancelAt::CancelAt;
    void report(const Progress& progress) override {
      CancelAt::report(progress);
      if (progress.phase == "rolling") last = progress;
    }
    Progress last;
  } monitor(0.5);
  const auto r = simulation::runCase(tinyCase("light-defect"), plain(), monitor);
  const auto& aba = *r.signal("aba");
  const auto at =
      std::find(r.position.begin(), r.position.end(), monitor.last.accelerationPosition) - r.position.begin();
  ASSERT_LT(at, static_cast<std::ptrdiff_t>(aba.size()));
  EXPECT_EQ(aba[static_cast<std::size_t>(at)], monitor.last.axleBoxAcceleration);
  EXPECT_LT(monitor.last.accelerationPosition, monitor.last.position);
}

TEST(RunCase, ResumedRunHasTheSameBits) {
  const auto folder = std::filesystem::temp_directory_path() / ("squat-resume-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  auto options = plain();
  options.checkpointPath = folder / "run.checkpoint";
  options.snapshots = true;
  CancelAt half(0.5);
  const auto first = simulation::runCase(tinyCase("light-defect"), options, half);
  EXPECT_FALSE(first.complete);
  options.resume = true;
  options.threads = 2;
  const auto resumed = run(tinyCase("light-defect"), options);
  EXPECT_TRUE(resumed.complete);
  auto whole = plain();
  whole.snapshots = true;
  const auto expected = run(tinyCase("light-defect"), whole);
  ASSERT_EQ(expected.signals.size(), resumed.signals.size());
  for (std::size_t c = 0; c < expected.signals.size(); ++c)
    EXPECT_EQ(expected.signals[c].values, resumed.signals[c].values) << expected.signals[c].name;
  for (std::size_t c = 0; c < expected.energy.size(); ++c)
    EXPECT_EQ(expected.energy[c].values, resumed.energy[c].values) << expected.energy[c].name;
  ASSERT_EQ(expected.snapshots.size(), resumed.snapshots.size());
  for (std::size_t s = 0; s < expected.snapshots.size(); ++s) {
    EXPECT_EQ(expected.snapshots[s].name, resumed.snapshots[s].name);
    EXPECT_EQ(expected.snapshots[s].displacement, resumed.snapshots[s].displacement);
    EXPECT_EQ(expected.snapshots[s].vonMises, resumed.snapshots[s].vonMises);
  }
  std::filesystem::remove_all(folder);
}

TEST(RunCase, CheckpointOfAnotherCaseIsRefused) {
  const auto folder = std::filesystem::temp_directory_path() / ("squat-other-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  auto options = plain();
  options.checkpointPath = folder / "run.checkpoint";
  CancelAt soon(0.05);
  simulation::runCase(tinyCase("light-defect"), options, soon);
  options.resume = true;
  EXPECT_THROW(run(tinyCase("smooth-rail"), options), CaseError);
  std::filesystem::remove_all(folder);
}

TEST(RunCase, StepAboveTheStableOneIsRefused) {
  try {
    run(tinyCase("light-defect", {{"output.time_step", "2"}}));
    FAIL() << "a step of 2 us was taken";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.problems().at(0).key, "output.time_step");
  }
}

TEST(RunCase, MovedNodesChangeLittle) {
  // The defect as a term of the gap alone against surface nodes moved as in the paper: 0.15 mm over an element layer of
  // 20 mm changes its stiffness by 0.75 % at the deepest point, and this layer has less than a tenth of the flexibility
  // below the wheel: 0.075 % of the peak; asked for is 0.1 %.
  const auto moved = run(tinyCase("light-defect", {{"defect.move_nodes", "true"}}));
  const auto &gap = *lightDefect().signal("aba_filtered"), &nodes = *moved.signal("aba_filtered");
  const double difference = largestDifference(gap, nodes);
  EXPECT_GT(difference, 1e-4 * largest(gap)) << "the nodes have not moved";
  EXPECT_LT(difference, 0.001 * largest(gap));
  verification::seen("difference", 100 * difference / largest(gap), "%");
}

// A rail gives way to a sudden motion with (E I)^(1/4) (rho A)^(3/4): 60E1 resists (3038.3 / 2337.9)^(1/4) (76.70 /
// 69.77)^(3/4) = 1.146 times as much as 54E1. The wheel has to take more of the defect's path, though not 15 % more: it
// is not rigid, and the contact gives way as before. Statics and energy balance as ever.
TEST(RunCase, AHeavierRailGivesWayLess) {
  const auto heavy = run(tinyCase("light-defect", {{"rail.section", "60E1"}}));
  ASSERT_TRUE(heavy.complete);
  EXPECT_NEAR(scalar(heavy.equilibrium, "contact_force") / (9.81 * (8000 + 950)), 1, 1e-6);
  EXPECT_LT(scalar(heavy.performance, "energy_residual"), 1e-3);
  const double ratio = largest(*heavy.signal("aba_filtered")) / largest(*lightDefect().signal("aba_filtered"));
  RecordProperty("ratio", std::to_string(ratio));
  EXPECT_GT(ratio, 1);
  EXPECT_LT(ratio, 1.146);
}

// A torque far beyond friction spins the wheel: the run goes on to its end, says so and marks it in the result.
TEST(RunCase, AWheelThatSpinsIsSaidAndMarked) {
  const auto result = run(tinyCase("smooth-rail", {{"contact.friction", "0.05"},
                                                   {"motion.traction_coefficient", "1"},
                                                   {"motion.torque_ramp", "1"},
                                                   {"motion.run_up", "0.06"}}));
  EXPECT_TRUE(result.complete);
  const auto says = [&](const char* words) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("motion.traction_coefficient"));  // before the run
  EXPECT_TRUE(says("the wheel slips"));              // after it
  EXPECT_GT(scalar(result.equilibrium, "largest_creepage"), 0.01);
  EXPECT_LT(scalar(lightDefect().equilibrium, "largest_creepage"), 0.01);
}

// 3 m of track for 10 m are what the mesh is for: said, and no warning.
TEST(RunCase, WhatAMeshShortensIsANote) {
  class Messages : public Monitor {
   public:
    void message(const std::string& text) override { all.push_back(text); }
    bool cancelled() override { return true; }
    std::vector<std::string> all;
  } monitor;
  const auto result = simulation::runCase(tinyCase("smooth-rail"), plain(), monitor);
  const auto shortens = [](const std::string& text) { return text.find("mesh preset tiny shortens") != text.npos; };
  const auto note = std::find_if(monitor.all.begin(), monitor.all.end(), shortens);
  ASSERT_NE(note, monitor.all.end());
  EXPECT_EQ(note->rfind("note: ", 0), 0u) << *note;
  EXPECT_TRUE(std::none_of(result.warnings.begin(), result.warnings.end(), shortens));
}

// Pauses once, as soon as the wheel rolls.
class PauseOnce : public Monitor {
 public:
  static constexpr double length = 0.5;  // [s]
  void report(const Progress& progress) override {
    if (progress.simulatedTime > 0 && !until_) until_ = Clock::now() + std::chrono::milliseconds(500);
  }
  bool paused() override { return until_ && Clock::now() < *until_; }
  bool wasPaused() const { return until_.has_value(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> until_;
};

// The wall time of the whole run holds the pause, that of the rolling, by which rate and time left are told, does not.
TEST(RunCase, APauseIsNoPartOfTheRolling) {
  PauseOnce monitor;
  const auto result = simulation::runCase(tinyCase("light-defect"), plain(), monitor);
  ASSERT_TRUE(monitor.wasPaused());
  EXPECT_LT(scalar(result.performance, "rolling_seconds"),
            scalar(result.performance, "seconds") - 0.99 * PauseOnce::length);
}

}  // namespace
}  // namespace squat
