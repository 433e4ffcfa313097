// What a run records, how it starts and how it rolls: one short run with all these keys changed, and a shorter one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "case/ParameterValue.h"
#include "elasticity/SweptSamples.h"
#include "keys/Keys.h"
#include "signals/Butterworth.h"
#include "simulation/RunCase.h"
#include "simulation/Signals.h"

namespace squat {
namespace {

constexpr double angularVelocity = 68, rate = 20e3, cutoff = 1.2e3, sensor = 0.35;

cases::CaseDescription changedCase() {
  return cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny",
                                                             {{"title", "Another name"},
                                                              {"note", "kept with the case"},
                                                              {"motion.run_up", "0.06"},
                                                              {"motion.beyond", "0.06"},
                                                              {"motion.torque", "0"},
                                                              {"contact.friction", "0"},
                                                              {"motion.angular_velocity", "68"},
                                                              {"output.rate", "20"},
                                                              {"output.filter_cutoff", "1.2"},
                                                              {"output.cwt_voices", "9"},
                                                              {"output.rail_accelerometer", "0.35"}}});
}

results::RunResult rolled(const cases::CaseDescription& description) {
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = options.snapshots = false;
  Monitor silent;
  return simulation::runCase(description, options, silent);
}

const results::RunResult& changed() {
  static const results::RunResult result = rolled(changedCase());
  return result;
}

constexpr double speed = 25, timeStep = 0.8e-6;

// With friction, without torque, from free rolling: 60 mm at another speed, in steps shorter than the stable one.
const results::RunResult& rolledFreely() {
  static const results::RunResult result = [] {
    auto description = changedCase();
    for (const auto& [key, text] : tests::Values{{"motion.speed", "25"},
                                                 {"motion.angular_velocity", "0"},
                                                 {"contact.friction", "0.3"},
                                                 {"motion.run_up", "0.04"},
                                                 {"motion.beyond", "0.02"},
                                                 {"output.time_step", "0.8"}})
      cases::setValue(description, key, text);
    return rolled(description);
  }();
  return result;
}

double figureOf(const std::vector<results::Scalar>& list, const std::string& name) {
  for (const auto& figure : list)
    if (figure.name == name) return figure.value;
  ADD_FAILURE() << "no " << name;
  return 0;
}

TEST(RunKeys, TitleAndNoteGoWithTheCaseAndChangeNothing) {
  EXPECT_EQ(changed().title, "Another name");
  EXPECT_THAT(changed().caseToml, testing::HasSubstr("kept with the case"));
  auto renamed = changedCase();
  renamed.title = "x", renamed.note = "y";
  EXPECT_EQ(cases::caseHash(renamed), changed().caseHash);
}

// Without friction and torque nothing turns the wheel faster or slower: the angular velocity that it starts with stays.
// 1e-6: what the patch, which swings along the rail by some micrometres, does to a wheel of 60 kg m2 in 4 ms.
TEST(RunKeys, TheWheelStartsWithItsAngularVelocity) {
  for (const double w : *changed().signal("wheel_speed")) ASSERT_NEAR(w, angularVelocity, 1e-6 * angularVelocity);
}

// What the wheel has gained by the end of the ramp and some time after it, without friction: half of the ramp counts,
// since the torque rises as (1 - cos)/2. With ramps of 1 and 3 ms the gains at 3.5 ms are as 3.0 to 2.0. 1e-3: the
// patch, as above, and the filter of the samples at the kinks of the ramp.
TEST(RunKeys, TheTorqueRisesAlongItsRamp) {
  double gained[2] = {};
  const char* const ramps[] = {"1", "3"};
  for (int i = 0; i < 2; ++i) {
    auto description = changedCase();
    cases::setValue(description, "motion.torque", "12000");
    cases::setValue(description, "motion.torque_ramp", ramps[i]);
    const auto result = rolled(description);
    const auto& turning = *result.signal("wheel_speed");
    gained[i] = turning[static_cast<std::size_t>(std::lround(3.5e-3 * rate))] - turning.front();
  }
  EXPECT_GT(gained[1], 0.1);  // [rad/s]: 12 kN m on some 50 kg m2
  EXPECT_NEAR(gained[0] / gained[1], 3.0 / 2.0, 1e-3 * 1.5);
}

// From 1 ms on: earlier samples see the standstill that their filter, 0.7 ms to each side, assumes before the start.
// 0.1 mm: friction at its limit, F = 26 kN, moves the half wheelset of m = 950 kg by no more than F t^2 / (2 m) = 0.08
// mm in the 2.4 ms of the run.
TEST(RunKeys, TheWheelTravelsAtTheSpeed) {
  const auto &time = rolledFreely().time, &position = rolledFreely().position;
  const auto first = static_cast<std::size_t>(std::lround(1e-3 * rate));
  ASSERT_GT(time.size(), first + 20);
  EXPECT_NEAR(position.back() - position[first], speed * (time.back() - time[first]), 1e-4);
}

// It rolls: angular velocity times radius is the speed. What creepage remains without a torque is what the rail under
// the wheel is longer or shorter than the tread. Pressing strains both alike, bending the rail by less than 1e-3 (200
// MPa); twice that, since elements of 5 mm let the creep force swing as they pass.
TEST(RunKeys, TheWheelRollsAtTheSpeed) {
  const double radius = cases::resolve(changedCase()).wheelset.radius;
  for (const double w : *rolledFreely().signal("wheel_speed")) ASSERT_NEAR(w * radius, speed, 2e-3 * speed);
}

// A sample has the fewest whole steps of at most the size asked for: 50 us take 63 of 0.8 us. The whole run is done in
// steps of that size: what the filter waits for at the end only adds to them.
TEST(RunKeys, StepsAreNoLongerThanAsked) {
  const auto& run = rolledFreely();
  ASSERT_GT(figureOf(run.meshFigures, "stable_step"), 1.1 * timeStep) << "the stable step would do as well";
  EXPECT_NEAR(figureOf(run.meshFigures, "step"), 1 / rate / 63, 1e-15);
  EXPECT_GE(figureOf(run.performance, "steps"), run.time.back() / timeStep);
  for (std::size_t i = 1; i < run.time.size(); ++i) ASSERT_NEAR(run.time[i] - run.time[i - 1], 1 / rate, 1e-12);
}

TEST(RunKeys, SamplesComeAtTheRate) {
  const auto& time = changed().time;
  ASSERT_GT(time.size(), 50u);
  for (std::size_t i = 1; i < time.size(); ++i) ASSERT_NEAR(time[i] - time[i - 1], 1 / rate, 1e-12);
}

// The filtered record is the record through a Butterworth of order 4 forward and back. The run filters what it records
// beyond the end as well, so the last milliseconds differ: compared is the first half, which the end reaches by less
// than a thousandth at this cut-off.
TEST(RunKeys, TheFilteredRecordIsCutAtItsFrequency) {
  const auto &raw = *changed().signal("aba"), &filtered = *changed().signal("aba_filtered");
  const auto expected = signals::lowPass({0, 1 / rate, raw, "", ""}, cutoff).values;
  const auto wrong = signals::lowPass({0, 1 / rate, raw, "", ""}, 2 * cutoff).values;
  double maximum = 0, difference = 0, other = 0;
  for (std::size_t i = 0; i < raw.size() / 2; ++i) {
    maximum = std::max(maximum, std::abs(expected[i]));
    difference = std::max(difference, std::abs(filtered[i] - expected[i]));
    other = std::max(other, std::abs(filtered[i] - wrong[i]));
  }
  EXPECT_LT(difference, 1e-3 * maximum);
  EXPECT_GT(other, 1e-2 * maximum) << "another cut-off would not show";
}

TEST(RunKeys, ScalesOfTheScalogramAreThatMuchApart) {
  const auto& frequency = changed().scalogramFrequency;
  ASSERT_GT(frequency.size(), 9u);
  for (std::size_t i = 1; i < frequency.size(); ++i)
    EXPECT_NEAR(std::abs(std::log2(frequency[i] / frequency[i - 1])), 1.0 / 9, 1e-9);
}

// The track at rest is given velocities a + b x from one moment to the next: what the two accelerometers read, times
// the step, tells where they stand. The sleeper nearest to 0.35 m stands at 0.6 m.
TEST(RunKeys, TheAccelerometersStandAtTheirPlaces) {
  const auto model = model::buildModel(cases::resolve(changedCase()));
  ThreadTeam team(1);
  constexpr double step = 1e-7, a = 0.3, b = 2;
  dynamics::Rolling rolling(model, elasticity::kernelsFor(""), team, step, 0);
  const AlignedVector rest(model.stateSize, 0.0);
  rolling.start(rest, rest, 0);
  const auto signals = simulation::outputSignals(rolling);
  auto state = rolling.state();
  for (std::size_t block = 0; block < model.blocks.size(); ++block)
    elasticity::setField(
        model.blocks[block], [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0, a + b * p[0]); },
        state.velocity);
  rolling.restore(state);
  std::map<std::string, double> locations;
  for (const auto& signal : signals) locations[signal.name] = (signal.probe(rolling) * step - a) / b;
  EXPECT_NEAR(locations.at("rail_acceleration"), sensor, 1e-9);
  EXPECT_NEAR(locations.at("sleeper_acceleration"), 0.6, 1e-9);
}

}  // namespace
}  // namespace squat
