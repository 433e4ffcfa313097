// A run from a warm state is the whole run on its mesh, to the bit: result and final state, whatever the profile and
// the number of threads. What tells of the machine and the clock is left out.
#include <gmock/gmock.h>

#include "FixtureCase.h"
#include "case/BeforeDefect.h"
#include "case/CaseFile.h"
#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "simulation/PlasticRun.h"
#include "simulation/SignalRecorder.h"
#include "simulation/StoppedRuns.h"
#include "simulation/WarmStateFile.h"

namespace squat::simulation {
namespace {

using squat::tests::CancelAt;
using squat::tests::comparable;
using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;
using Values = std::vector<std::pair<std::string, std::string>>;

constexpr double never = 2;  // share of the rolling at which a run is cancelled

cases::CaseDescription caseWith(const Values& besides = {}) {
  Values values{{"motion.run_up", "0.06"}, {"motion.beyond", "0.05"}};
  values.insert(values.end(), besides.begin(), besides.end());
  return cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", values});
}

RunOptions threads(int count) {
  RunOptions options;
  options.threads = count;
  return options;
}

std::shared_ptr<const WarmState> made(const cases::CaseDescription& description, const RunOptions& options) {
  Monitor silent;
  auto warm = makeWarmState(description, options, silent);
  return warm ? std::make_shared<const WarmState>(*std::move(warm)) : nullptr;
}

// The mesh of all tests serves defects from -36 to 70 mm.
const std::shared_ptr<const WarmState>& shared() {
  static const auto warm = made(caseWith({{"mesh.zone_before", "36"}, {"mesh.zone_behind", "70"}}), threads(2));
  return warm;
}

std::string refusal(const WarmState& warm, const cases::CaseDescription& description) {
  try {
    requireFit(warm, description);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string kHump =  // 0.06 mm above the surface before and behind the dip
    "[[-34, 0], [-24, 0.06], [-15, 0.01], [0, -0.2], [12, 0.02], [25, 0.06], [40, 0]]";
const std::string kLines = "[[-6, [[-20, 0], [0, -0.08], [20, 0]]], [6, [[-20, 0], [4, -0.15], [30, 0]]]]";

struct Profile {
  const char* name;
  Values values;
};
const std::vector<Profile> profiles{
    {"the measured profile of the case", {}},
    {"a cosine dip",
     {{"defect.shape", "cosine"}, {"defect.length", "40"}, {"defect.depth", "0.3"}, {"defect.lateral", "parabolic"}}},
    {"a cut with steep ramps",
     {{"defect.shape", "cut"}, {"defect.length", "30"}, {"defect.depth", "0.2"}, {"defect.ramp", "2"}}},
    {"a w-shape", {{"defect.shape", "w-shape"}, {"defect.length", "48"}, {"defect.depth", "0.1"}}},
    {"a profile with humps", {{"defect.points", kHump}, {"defect.level", "false"}}},
    {"lines side by side", {{"defect.lines", kLines}}},
    {"smooth rail", {{"defect.shape", "none"}}},
};

// Result and last state of a run that is stopped behind its last step: only then does its checkpoint stay.
struct Ended {
  results::ArrayTree result, state;
};
Ended rolledToTheEnd(const cases::CaseDescription& description, RunOptions options) {
  const TemporaryFolder folder;
  options.checkpointPath = folder / "c";
  CancelAt monitor(1);
  Ended ended;
  ended.result = comparable(runCase(description, options, monitor));
  ended.state = results::readCheckpoint(options.checkpointPath).value();
  return ended;
}

TEST(WarmState, ARunFromItIsTheWholeRunToTheBit) {
  for (const auto& [name, values] : profiles) {
    SCOPED_TRACE(name);
    const auto description = caseWith(values);
    const auto whole = rolledToTheEnd(onMeshOf(*shared(), description), threads(1));
    for (const int count : {1, 2}) {
      auto options = threads(count);
      options.warm = shared();
      const auto warm = rolledToTheEnd(description, options);
      EXPECT_EQ(results::firstDifference(whole.result, warm.result), "") << count << " threads";
      EXPECT_EQ(results::firstDifference(whole.state, warm.state), "") << count << " threads";
    }
  }
}

// The state is not that of the start: without this the test above would show nothing.
TEST(WarmState, IsTakenJustBeforeTheZone) {
  const auto& scalars = results::valuesOf<double>(shared()->state, "/rolling/scalars", "");
  EXPECT_GT(scalars[0], 100) << "steps";
  // 36 mm of zone and half a patch; at 20 mm the tread stands 0.43 mm above the rail, more than any bounce.
  EXPECT_LT(shared()->position, -0.036 - 0.007);
  EXPECT_GT(shared()->position, -0.036 - 0.020);
  const auto& closed = results::valuesOf<std::int64_t>(shared()->state, "/rolling/closed", "");
  EXPECT_FALSE(closed.empty());
}

// What a preview draws before its own run has come farther.
TEST(WarmState, HoldsTheSignalsSoFar) {
  const auto description = caseWith({{"motion.run_up", "0.1"}});
  const auto warm = made(description, threads(2));
  const auto position = recordedIn(warm->state, "position"), aba = recordedIn(warm->state, "aba");
  auto options = threads(2);
  options.warm = warm;
  Monitor silent;
  const auto result = runCase(description, options, silent);
  ASSERT_GT(position.size(), 10U);
  ASSERT_EQ(aba.size(), position.size());
  for (std::size_t i = 0; i < position.size(); ++i) {
    EXPECT_EQ(position[i], result.position[i]);
    EXPECT_EQ(aba[i], (*result.signal("aba"))[i]);
  }
  EXPECT_LT(position.back(), warm->position);
  EXPECT_TRUE(recordedIn(warm->state, "no such signal").empty());
}

struct CancelIn : Monitor {
  explicit CancelIn(std::string name) : phase(std::move(name)) {}
  void report(const Progress& progress) override { seen = seen || progress.phase == phase; }
  bool cancelled() override { return seen; }
  std::string phase;
  bool seen = false;
};

// What comes while the run rolls goes on where the state ends, and is what the result holds, up to the samples whose
// filter is still waiting at the end.
TEST(WarmState, ARunHandsItsSamplesOnAsTheyCome) {
  auto position = recordedIn(shared()->state, "position"), aba = recordedIn(shared()->state, "aba");
  auto options = threads(2);
  options.warm = shared();
  options.sampled = [&](double at, double acceleration) { position.push_back(at), aba.push_back(acceleration); };
  Monitor silent;
  const auto result = runCase(caseWith(), options, silent);
  const std::size_t count = result.time.size();
  ASSERT_GE(position.size(), count);
  position.resize(count), aba.resize(count);
  EXPECT_EQ(position, result.position);
  EXPECT_EQ(aba, *result.signal("aba"));
}

// To where the wheel begins to feel what lies 20 mm ahead of the deepest point: nearer by the rest of the zone's 36 mm.
TEST(WarmState, RolledOnItGivesTheBitsToWhatBeginsThere) {
  const auto cosine = [](const char* length, const char* depth) {
    return caseWith({{"defect.shape", "cosine"}, {"defect.length", length}, {"defect.depth", depth}});
  };
  Monitor silent;
  const auto made = rollOn(shared(), cosine("36", "0.1"), 0.020, threads(2), silent);
  ASSERT_TRUE(made);
  const auto nearer = std::make_shared<const WarmState>(*made);
  EXPECT_NEAR(nearer->position, shared()->position + 0.016, 0.002);
  EXPECT_EQ(nearer->model, shared()->model);
  for (const auto& description : {cosine("40", "0.3"), cosine("20", "0.1")}) {
    const auto whole = rolledToTheEnd(onMeshOf(*shared(), description), threads(1));
    auto options = threads(2);
    options.warm = nearer;
    const auto from = rolledToTheEnd(description, options);
    EXPECT_EQ(results::firstDifference(whole.result, from.result), "");
    EXPECT_EQ(results::firstDifference(whole.state, from.state), "");
  }
  auto options = threads(1);
  options.warm = nearer;
  EXPECT_THROW(runCase(cosine("60", "0.1"), options, silent), CaseError) << "it begins before the wheel";
}

TEST(WarmState, RollingOnCanBeCancelledAndNeedsAFittingCase) {
  CancelIn monitor("rolling");
  EXPECT_FALSE(rollOn(shared(), caseWith({{"defect.shape", "cut"}}), 0.01, threads(1), monitor));
  Monitor silent;
  EXPECT_THROW(rollOn(shared(), caseWith({{"motion.speed", "29"}}), 0.02, threads(1), silent), CaseError);
}

// Without a set zone the mesh is that of the case's own defect, and the case stays as it is.
TEST(WarmState, ServesItsOwnCaseOnItsOwnMesh) {
  const auto description = caseWith({{"defect.shape", "cosine"}, {"defect.length", "50"}});
  auto options = threads(1);
  Monitor silent;
  const auto whole = runCase(description, options, silent);
  options.warm = made(description, threads(1));
  const auto warm = runCase(description, options, silent);
  EXPECT_TRUE(warm.complete);
  EXPECT_EQ(warm.caseHash, cases::caseHash(description));
  EXPECT_EQ(results::firstDifference(comparable(whole), comparable(warm)), "");
}

TEST(WarmState, AStateWithoutModesAndPicturesServesARunWithoutPictures) {
  RunOptions bare = threads(2), full = threads(2);
  bare.snapshots = bare.wheelsetModes = full.snapshots = false;
  const auto description = caseWith({{"defect.height_scale", "0.5"}});
  Monitor silent;
  const auto whole = runCase(description, full, silent);
  full.warm = made(description, bare);
  EXPECT_EQ(results::firstDifference(comparable(whole), comparable(runCase(description, full, silent))), "");
}

// The rail yields under the run-up as under the defect. Where contact is looked for is where it may flow: 0.012 m more
// than the smaller of radius times slope and half the defect's length, at least 0.020 m.
TEST(WarmState, AYieldingRailWorksWhereDefectsAreAlike) {
  const auto cut = [](const char* depth, const char* length) {
    return squat::tests::softRail({{"motion.run_up", "0.07"},
                                   {"defect.shape", "cut"},
                                   {"defect.length", length},
                                   {"defect.ramp", "2"},
                                   {"defect.depth", depth}});
  };
  const auto warm = made(cut("0.15", "40"), threads(2));
  auto options = threads(1);
  Monitor silent;
  const auto whole = runCase(cut("0.25", "40"), options, silent);
  options.warm = warm;
  const auto from = runCase(cut("0.25", "40"), options, silent);
  ASSERT_TRUE(from.complete);
  EXPECT_GT(squat::tests::scalar(from.plasticity, "largest_equivalent_strain"), 0);
  EXPECT_EQ(results::firstDifference(comparable(whole), comparable(from)), "");
  EXPECT_THAT(refusal(*warm, cut("0.15", "20")), HasSubstr("rail.plastic is true, must be false for this defect"));
}

// Each kind of value: what is said is key, value here, value in the state.
TEST(WarmState, SaysWhichKeyDiffers) {
  const struct {
    Values values;
    std::string text;
  } calls[] = {
      {{{"motion.speed", "29"}}, "motion.speed is 29 m/s, must be 30 m/s, as in the warm state"},
      {{{"motion.beyond", "0.06"}}, "motion.beyond is 0.06 m, must be 0.05 m"},
      {{{"track.rail_ends", "clamped"}}, "track.rail_ends is clamped, must be"},
      {{{"track.defect_from_sleeper", "0.1"}}, "track.defect_from_sleeper is 0.1 m, must be 0 m"},
      {{{"mesh.selective_inertia", "false"}}, "mesh.selective_inertia is false, must be true"},
      {{{"mesh.wheel_sectors", "32"}}, "mesh.wheel_sectors is 32, must be 24"},
      {{{"pad.curve", "[[0, 0], [1, 900]]"}}, "pad.curve is [[0, 0], [1, 900]] mm, kN, must be []"},
      {{{"output.rate", "30"}}, "output.rate is 30 kHz, must be 25 kHz"},
      {{{"defect.move_nodes", "true"}}, "defect.move_nodes is true, must be false with a warm state"},
      {{{"defect.shape", "cosine"}, {"defect.length", "80"}},
       "mesh.zone_before is 40 mm, must be at most 36 mm, as in the warm state"},
      {{{"defect.shape", "cosine"}, {"defect.length", "40"}, {"mesh.zone_behind", "30"}},
       "mesh.zone_behind is 30 mm, must be 70 mm"},
  };
  for (const auto& call : calls) EXPECT_THAT(refusal(*shared(), caseWith(call.values)), HasSubstr(call.text));
  EXPECT_THAT(refusal(*shared(), caseWith({{"pad.stiffness", "999"}, {"contact.friction", "0.4"}})),
              AllOf(HasSubstr("pad.stiffness"), HasSubstr("contact.friction")));
  auto draft = caseWith();
  draft.mesh.preset = cases::MeshPreset::draft;
  EXPECT_THAT(refusal(*shared(), draft), HasSubstr("mesh.preset is draft, must be tiny"));
  auto options = threads(1);
  options.warm = shared();
  Monitor silent;
  EXPECT_THROW(runCase(caseWith({{"motion.speed", "29"}}), options, silent), CaseError);
}

// Any key counts unless this list names it: a key that a later version adds is shared by nobody's oversight.
TEST(WarmState, EveryKeyCountsButThoseOfTheDefectAndOfTheFinishedRecord) {
  std::vector<std::string> others;
  for (const auto& parameter : cases::parameterTable())
    if (!cases::countsBeforeDefect(parameter) && parameter.group != "defect" && parameter.group != "growth")
      others.push_back(parameter.key);
  EXPECT_THAT(others, ::testing::UnorderedElementsAre("title", "note", "track.preset", "rail.preset",
                                                      "rail.irregularity_file", "pad.dynamic", "wheelset.preset",
                                                      "wheelset.tread_deviation", "mesh.zone_before",
                                                      "mesh.zone_behind", "output.filter_cutoff", "output.cwt_voices"));
  for (const auto& parameter : cases::parameterTable()) {
    if (parameter.kind != cases::Kind::number) continue;
    if (!cases::countsBeforeDefect(parameter)) continue;
    auto changed = shared()->description;
    const bool isMinimum = cases::numberInUnit(changed, parameter) == parameter.minimum;
    cases::setValue(changed, parameter.key, cases::formatDecimal(isMinimum ? parameter.maximum : parameter.minimum));
    EXPECT_THAT(refusal(*shared(), changed), HasSubstr(parameter.key + " is ")) << parameter.key;
  }
}

// A hump of 1.2 mm meets the tread where it stands 1.2 mm above the rail: 33 mm ahead of the wheel.
TEST(WarmState, AProfileThatTheWheelTouchesEarlierIsRefused) {
  const auto hump =
      caseWith({{"defect.points", "[[-34, 0], [-24, 1.2], [-14, 0], [0, -0.2], [20, 0]]"}, {"defect.level", "false"}});
  auto options = threads(1);
  options.warm = shared();
  Monitor silent;
  try {
    runCase(hump, options, silent);
    FAIL() << "accepted";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.problems().front().key, "--warm");
    EXPECT_THAT(error.what(), HasSubstr("the wheel touches it earlier"));
  }
}

TEST(WarmState, NeedsARunUpAndNodesThatStay) {
  Monitor silent;
  const auto refused = [&](const Values& values) -> std::string {
    try {
      makeWarmState(caseWith(values), threads(1), silent);
    } catch (const CaseError& error) {
      return error.problems().front().key;
    }
    return "accepted";
  };
  EXPECT_EQ(refused({{"defect.move_nodes", "true"}}), "defect.move_nodes");
  EXPECT_EQ(refused({{"mesh.zone_before", "58"}}), "motion.run_up");
}

TEST(WarmState, CanBeCancelledInEveryPhase) {
  for (const char* phase : {"mesh", "stable step", "equilibrium", "initial velocities", "rolling"}) {
    CancelIn monitor(phase);
    EXPECT_FALSE(makeWarmState(caseWith(), threads(1), monitor).has_value()) << phase;
    EXPECT_TRUE(monitor.seen) << phase;
  }
}

}  // namespace
}  // namespace squat::simulation
