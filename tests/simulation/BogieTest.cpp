// The bogie's second wheelset (bogie.wheelbase): what theory says of energy, waves, weight and the body that pitches,
// and that a run is the same with any number of threads and after it was resumed. Waves between both wheelsets against
// a beam: verification/SecondWheelsetTest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "FixtureCase.h"
#include "TemporaryFolder.h"
#include "analysis/FeatureTable.h"
#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "dynamics/SecondRolling.h"
#include "geometry/Stations.h"
#include "model/WheelsetModes.h"
#include "simulation/QuietRuns.h"
#include "simulation/StoppedRuns.h"
#include "simulation/WarmState.h"
#include "statics/SteadyRollingStart.h"
#include "statics/VehicleMotion.h"

namespace squat {
namespace {

using tests::energyResidual;
using tests::largest;
using tests::rolled;
using Settings = std::vector<std::pair<std::string, std::string>>;

// A dip of the light defect's shape, reached after 60 mm and left behind after 60 mm.
cases::CaseDescription bogie(Settings settings = {}, const std::string& wheelbase = "2.5") {
  settings.insert(
      settings.begin(),
      {{"motion.run_up", "0.06"}, {"motion.beyond", "0.06"}, {"track.length", "7.8"}, {"bogie.wheelbase", wheelbase}});
  return cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", settings});
}

const results::RunResult& oneDip() {
  static const auto result = rolled(bogie());
  return result;
}

double loadAtRest(const cases::CaseDescription& d) {
  return d.motion.gravity * (cases::resolve(d).wheelset.totalMass + d.suspension.sprungMass);
}

// On a smooth rail the second wheelset rolls as steadily as it starts: its load is its weight. What shakes it comes
// from the first wheel, whose patch of few points ripples by up to 7 % of its load on this mesh (WholeModelTest): 0.5
// %, and less than 1 m/s2, are small beside that.
TEST(Bogie, TheSecondWheelsetRollsSteadilyOnASmoothRail) {
  const auto d = bogie({{"defect.shape", "none"}});
  const auto result = rolled(d);
  for (const double force : *result.signal("second_contact_force"))
    ASSERT_NEAR(force, loadAtRest(d), 5e-3 * loadAtRest(d));
  EXPECT_LT(largest(*result.signal("second_aba")), 1);
}

// Maxwell and Betti: the second wheel bends the rail below the first one by as much as its load, on the first one,
// bends it where the second stands. What a load does is the difference of two loads, so that the track's own weight
// drops out. Tolerance 2 %: the force of the one enters through a patch, that of the other is spread over 80 mm.
TEST(Bogie, WheelsetsBendEachOthersRail) {
  const auto railBelow = [](const std::string& wheelbase, const std::string& mass, double fromFirst) {
    auto d = bogie({{"defect.shape", "none"}, {"suspension.sprung_mass", mass}});
    cases::setValue(d, "bogie.wheelbase", wheelbase);
    const auto model = model::buildModel(cases::resolve(d));
    ThreadTeam team(2);
    Monitor silent;
    const auto start = statics::prepareSteadyRollingStart(model, elasticity::kernelsFor(""), team, silent);
    const double at = model.startX + fromFirst;
    const auto [station, share] = geometry::intervalOf(model.blocks[model.rail].positions, at);
    const auto& u = start.equilibrium.displacement;
    return (1 - share) * statics::verticalOfRailSection(model, u, station) +
           share * statics::verticalOfRailSection(model, u, station + 1);
  };
  const double part = 2000 / (8000 + cases::resolve(bogie()).wheelset.totalMass);  // of the load
  for (const double base : {0.9, 1.2}) {
    const double bySecond = railBelow(std::to_string(base), "8000", 0) - railBelow("0", "8000", 0);
    const double ofFirst = railBelow("0", "8000", -base) - railBelow("0", "6000", -base);
    EXPECT_NEAR(part * bySecond, ofFirst, 0.02 * std::abs(ofFirst)) << base;
    EXPECT_GT(std::abs(bySecond), 5e-5) << base;
  }
}

// The limit is that of the half model (RunCaseTest): a fifth of the one at which a run is stopped.
TEST(Bogie, EnergyIsBalanced) {
  EXPECT_LT(energyResidual(oneDip()), 1e-3);
  EXPECT_LT(energyResidual(rolled(bogie({{"wheelset.damping_ratio", "0.02"}, {"bogie.pitch_radius", "0.6"}}))), 1e-3);
  EXPECT_LT(energyResidual(rolled(bogie({{"rail.irregularity", "iso-3095"}, {"bogie.second_wheelset", "ahead"}}))),
            1e-3);
  EXPECT_LT(energyResidual(rolled(bogie({{"model.extent", "whole"}, {"right.defect.shape", "none"}}))), 1e-3);
}

// No wave in a bar of steel is faster than sqrt(E / rho): the second wheelset feels nothing of the dip before that has
// come all the way, and more than 100 N, a tenth of a per cent of its load,
// by the time bending waves have, within three times as long.
TEST(Bogie, TheSecondWheelsetFeelsTheDipWhenAWaveHasCome) {
  const auto d = bogie();
  const auto without = rolled(bogie({{"defect.shape", "none"}}));
  const auto departure = [&](const char* signal, double limit) {
    const auto &values = *oneDip().signal(signal), &others = *without.signal(signal);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (std::abs(values[i] - others[i]) > limit) return oneDip().time[i];
    return static_cast<double>(INFINITY);
  };
  const auto& steel = d.rail.material;
  const double coming = d.bogie.wheelbase / std::sqrt(steel.young / steel.density), sample = 1 / d.output.rate;
  const double delay = departure("second_contact_force", 100) - departure("contact_force", 100);
  EXPECT_GT(delay, coming - 2 * sample);
  EXPECT_LT(delay, 3 * coming);
}

// A whole bogie whose sides are alike is the mirror image of half of one, to the bit.
TEST(Bogie, EqualSidesMoveAsTheHalfModelDoes) {
  const auto whole = rolled(bogie({{"model.extent", "whole"}}));
  for (const std::string name : {"aba", "contact_force", "second_aba", "second_contact_force"}) {
    EXPECT_EQ(*whole.signal(name), *oneDip().signal(name)) << name;
    EXPECT_EQ(*whole.signal(name + "_right"), *oneDip().signal(name)) << name;
  }
}

// With a dip on the left alone the right wheel of the second wheelset moves less than the left one.
TEST(Bogie, SidesOfTheSecondWheelsetDiffer) {
  const Settings left{{"model.extent", "whole"}, {"right.defect.shape", "none"}};
  const Settings right{{"model.extent", "whole"}, {"defect.shape", "none"}, {"right.defect.shape", "profile"}};
  const auto one = rolled(bogie(left)), other = rolled(bogie(right));
  EXPECT_EQ(*one.signal("second_aba"), *other.signal("second_aba_right"));
  EXPECT_EQ(*one.signal("second_aba_right"), *other.signal("second_aba"));
  EXPECT_GT(largest(*one.signal("second_aba")), largest(*one.signal("second_aba_right")));
}

// A wheelset whose sides carry unlike loads rests on its levers: moments about the other wheel.
TEST(Bogie, UnlikeLoadsStandOnTheirLevers) {
  const auto d = bogie({{"model.extent", "whole"},
                        {"defect.shape", "none"},
                        {"suspension.sprung_mass", "9000"},
                        {"right.suspension.sprung_mass", "6000"}});
  const auto result = rolled(d);
  const auto& w = d.wheelset;
  const double gauge = 2 * w.trackCentre, arm = w.bearingCentre, own = cases::resolve(d).wheelset.totalMass;
  // Of the left wheel about the right one: gauge from it the wheelset's own halves act on both wheels alike.
  const double left = own + (9000 * (gauge + arm) - 6000 * arm) / gauge;
  const double right = own + (6000 * (gauge + arm) - 9000 * arm) / gauge;
  const auto meanOf = [&](const char* name) {
    double sum = 0;
    for (const double force : *result.signal(name)) sum += force;
    return sum / static_cast<double>(result.signal(name)->size());
  };
  EXPECT_NEAR(meanOf("second_contact_force"), left * d.motion.gravity, 2e-3 * left * d.motion.gravity);
  EXPECT_NEAR(meanOf("second_contact_force_right"), right * d.motion.gravity, 2e-3 * right * d.motion.gravity);
}

// Newton and Euler for a body of twice the sprung mass and its pitch radius, pushed half the wheelbase before and
// behind its middle. What is left of the first force is the mass of one wheelset times the acceleration above it.
TEST(Bogie, TheSprungMassPitches) {
  for (const char* radius : {"1.25", "0.7"}) {
    const auto d = bogie({{"bogie.pitch_radius", radius}});
    const auto model = model::buildModel(cases::resolve(d));
    const model::Model* const sides[] = {&model};
    dynamics::SecondRolling second(sides, 1e-7);
    const AlignedVector rest(model.stateSize, 0.0);
    const double* const at[] = {rest.data()};
    second.start(at, at);
    const double mass = d.suspension.sprungMass, weight = mass * d.motion.gravity, pushed = 5e3;
    double force[] = {pushed};
    second.advance(force);
    const double arm = 0.5 * d.bogie.wheelbase, inertia = 2 * mass * d.bogie.pitchRadius * d.bogie.pitchRadius;
    const double middle = (pushed + weight) / (2 * mass), angular = arm * (pushed - weight) / inertia;
    EXPECT_NEAR(force[0], mass * (middle + arm * angular), 1e-6 * weight) << radius;
  }
}

// Runs of fine stations begin at whole groups of 16, as without the second wheelset: the time step is as long.
TEST(Bogie, TheFineStretchKeepsItsGroups) {
  for (const char* base : {"2.4", "2.5", "2.56", "2.6"}) {
    const auto d = cases::loadCase(tests::fixtureCase("light-defect"), {"draft", {{"bogie.wheelbase", base}}});
    const auto model = model::buildModel(cases::resolve(d));
    int first = 0;
    for (const auto& run : model.blocks[model.rail].stations.runs) {
      if (run.length < 1.01 * d.mesh.contactSize) {
        EXPECT_EQ(first % 16, 0) << base << " at interval " << first;
      }
      first += run.count;
    }
  }
}

// Foucault: a vibration of a body that turns keeps its plane in space where all its mass moves as one; the plane of a
// tilt is carried along. Bryan (1890): that of a thin ring turns with 1 - 2 / (n^2 + 1) of the rotation, seen in space.
TEST(Bogie, ModesStayInSpaceAsFarAsTheyAreTranslations) {
  auto d = bogie();
  // Axle box on a soft spring: nearly all of it is the box, which does not turn.
  cases::setValue(d, "wheelset.bearing_stiffness", "1");
  const auto modes = model::wheelsetModes(cases::resolve(d), 3000, 3);
  const auto box = std::find_if(modes.begin(), modes.end(), [](const auto& mode) { return mode.harmonic == 1; });
  ASSERT_NE(box, modes.end());
  EXPECT_NEAR(box->stays, 1, 0.02) << box->frequency << " Hz";
  for (const auto& mode : modes) EXPECT_LE(std::abs(mode.stays), 1 + 1e-9) << mode.frequency;
  // Vibrations of the web across its plane move little mass around or outwards.
  int across = 0;
  for (const auto& mode : modes) {
    if (mode.harmonic != 2 || std::abs(mode.contactAmplitude) > 0.1 * std::abs(mode.lateralAmplitude)) continue;
    EXPECT_LT(std::abs(mode.stays), 0.1) << mode.frequency << " Hz";
    ++across;
  }
  EXPECT_GT(across, 0);
}

TEST(Bogie, SameBitsForAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    const auto other = rolled(bogie(), threads);
    for (const auto& channel : oneDip().signals)
      EXPECT_EQ(*other.signal(channel.name), channel.values) << channel.name << ", threads: " << threads;
  }
}

TEST(Bogie, AResumedRunGivesTheSameBits) {
  const tests::TemporaryFolder folder;
  auto options = tests::quietly();
  options.checkpointPath = folder / "bogie.checkpoint", options.checkpointSeconds = 1e9;
  tests::CancelAt stopping(0.5);
  ASSERT_FALSE(simulation::runCase(bogie(), options, stopping).complete);
  options.resume = true;
  Monitor silent;
  const auto resumed = simulation::runCase(bogie(), options, silent);
  ASSERT_TRUE(resumed.complete);
  for (const auto& channel : oneDip().signals) EXPECT_EQ(*resumed.signal(channel.name), channel.values) << channel.name;
  EXPECT_EQ(energyResidual(resumed), energyResidual(oneDip()));
}

// A whole bogie of unlike sides as well.
TEST(Bogie, AResumedWholeBogieGivesTheSameBits) {
  const tests::TemporaryFolder folder;
  const auto d = bogie({{"model.extent", "whole"}, {"right.suspension.sprung_mass", "7000"}});
  auto options = tests::quietly();
  Monitor silent;
  const auto whole = simulation::runCase(d, options, silent);
  options.checkpointPath = folder / "bogie.checkpoint", options.checkpointSeconds = 1e9;
  tests::CancelAt stopping(0.5);
  ASSERT_FALSE(simulation::runCase(d, options, stopping).complete);
  options.resume = true;
  const auto resumed = simulation::runCase(d, options, silent);
  ASSERT_TRUE(resumed.complete);
  for (const auto& channel : whole.signals) EXPECT_EQ(*resumed.signal(channel.name), channel.values) << channel.name;
}

TEST(Bogie, StartsFromAWarmState) {
  Settings keys{
      {"motion.run_up", "0.1"}, {"mesh.zone_before", "30"}, {"mesh.zone_behind", "30"}, {"defect.height_scale", "1"}};
  auto options = tests::quietly();
  Monitor silent;
  auto warm = simulation::makeWarmState(bogie(keys), options, silent);
  ASSERT_TRUE(warm);
  options.warm = std::make_shared<const simulation::WarmState>(*std::move(warm));
  keys.back().second = "0.5";
  const auto from = simulation::runCase(bogie(keys), options, silent);
  const auto whole = rolled(bogie(keys));
  for (const auto& channel : whole.signals) EXPECT_EQ(*from.signal(channel.name), channel.values) << channel.name;
  EXPECT_THROW(simulation::runCase(bogie(keys, "2.6"), options, silent), CaseError);
}

// The second wheelset rolls over the same rail, as rough as it is there.
TEST(Bogie, TheSecondWheelsetFeelsTheIrregularityOfItsOwnPlace) {
  const auto rough = rolled(bogie({{"defect.shape", "none"}, {"rail.irregularity", "iso-3095"}}));
  const auto smooth = rolled(bogie({{"defect.shape", "none"}}));
  EXPECT_GT(largest(*rough.signal("second_aba")), 3 * largest(*smooth.signal("second_aba")));
  const auto scenario = cases::resolve(bogie({{"rail.irregularity", "iso-3095"}}));
  // Away from where both start, heights differ by a constant: both are heights above a starting point.
  const auto at = [&](double x) {
    return scenario.irregularity.height(x) - scenario.irregularityUnderSecond.height(x);
  };
  EXPECT_NEAR(at(0.02), at(0.05), 1e-15);
}

TEST(Bogie, FeaturesHoldTheSecondWheelset) {
  const auto row = analysis::featureTable(oneDip());
  const auto found =
      std::find_if(row.begin(), row.end(), [](const auto& one) { return one.first == "second peak [m/s2]"; });
  ASSERT_NE(found, row.end());
  EXPECT_EQ(found->second, largest(*oneDip().signal("second_aba_filtered")));
}

// What is refused is accepted with what the message asks for.
TEST(Bogie, NeedsRoomOnTheRail) {
  const auto problemOf = [](const cases::CaseDescription& d) -> std::optional<CaseProblem> {
    const auto found = cases::validate(d).problems;
    if (found.empty()) return std::nullopt;
    return found.front();
  };
  EXPECT_FALSE(problemOf(bogie()));
  const auto changed = [](const Settings& settings) {
    auto d = bogie();
    for (const auto& [key, value] : settings) cases::setValue(d, key, value);
    return d;
  };
  const auto near = problemOf(changed({{"bogie.wheelbase", "0.5"}}));
  ASSERT_TRUE(near);
  EXPECT_EQ(near->key, "bogie.wheelbase");
  const std::string least = "0 (a single wheelset) or at least ";
  ASSERT_EQ(near->allowed.find(least), 0u) << near->allowed;
  EXPECT_FALSE(
      problemOf(changed({{"bogie.wheelbase", std::to_string(std::stod(near->allowed.substr(least.size())))}})));
  const auto longRun = problemOf(changed({{"track.length", "30"}, {"motion.run_up", "4"}}));
  ASSERT_TRUE(longRun);
  EXPECT_EQ(longRun->key, "motion.run_up");
  const std::string most = "at most ";
  ASSERT_EQ(longRun->allowed.find(most), 0u) << longRun->allowed;
  const std::string runUp = std::to_string(std::stod(longRun->allowed.substr(most.size())));
  EXPECT_FALSE(problemOf(changed({{"track.length", "30"}, {"motion.run_up", runUp}, {"bogie.wheelbase", "4"}})));
  const auto onDefect = problemOf(changed({{"bogie.second_wheelset", "ahead"},
                                           {"bogie.wheelbase", "1.2"},
                                           {"defect.points", "[[-20, 0], [0, -0.1], [1300, 0]]"}}));
  ASSERT_TRUE(onDefect);
  EXPECT_EQ(onDefect->key, "bogie.wheelbase");
  const auto shortRail = problemOf(changed({{"track.length", "6"}}));
  ASSERT_TRUE(shortRail);
  EXPECT_EQ(shortRail->key, "track.length");
  const std::string start = "at least ";
  ASSERT_EQ(shortRail->allowed.find(start), 0u) << shortRail->allowed;
  const std::string length = std::to_string(std::stod(shortRail->allowed.substr(start.size())));
  EXPECT_FALSE(problemOf(changed({{"track.length", length}})));
  EXPECT_TRUE(problemOf(changed({{"track.length", length}, {"motion.run_up", "0.5"}})));
}

}  // namespace
}  // namespace squat
