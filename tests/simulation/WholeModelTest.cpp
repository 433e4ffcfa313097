// Both rails and the whole wheelset (model.extent = whole): what theory says of mirror images and of energy, and that a
// run is the same with any number of threads and after it was resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
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
#include "case/RightSide.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
#include "simulation/QuietRuns.h"
#include "simulation/StoppedRuns.h"
#include "simulation/WarmState.h"

namespace squat {
namespace {

using tests::energyResidual;
using tests::largest;
using tests::rolled;
using Settings = std::vector<std::pair<std::string, std::string>>;

// A dip of the light defect's shape, reached after 60 mm and left behind after 60 mm.
cases::CaseDescription dip(Settings settings) {
  settings.insert(settings.begin(), {{"motion.run_up", "0.06"}, {"motion.beyond", "0.06"}});
  return cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", settings});
}

const results::RunResult& oneSided() {
  static const auto result = rolled(dip({{"model.extent", "whole"}, {"right.defect.shape", "none"}}));
  return result;
}

// Mirror images need no mirror: the half model is exact for equal sides. Every operation on both sides is one of the
// half model, so that nothing is lost to rounding either; modal damping too, whose antisymmetric part has nothing to
// damp.
TEST(WholeModel, EqualSidesMoveAsTheHalfModelDoes) {
  for (const char* damping : {"0", "0.02"}) {
    const auto half = rolled(dip({{"wheelset.damping_ratio", damping}}));
    const auto whole = rolled(dip({{"wheelset.damping_ratio", damping}, {"model.extent", "whole"}}));
    for (const char* name : {signals::names::axleBox, signals::names::contactForce, signals::names::wheelSpeed}) {
      EXPECT_EQ(*whole.signal(name), *half.signal(name)) << name;
      EXPECT_EQ(*whole.signal(std::string(name) + "_right"), *half.signal(name)) << name;
    }
    for (std::size_t i = 0; i < 2; ++i)  // elements and nodes: the mesh has both sides
      EXPECT_EQ(whole.meshFigures[i].value, 2 * half.meshFigures[i].value) << whole.meshFigures[i].name;
  }
}

// The surface of the right side is the left one's mirror image at the track centre, y = -trackCentre, where both sides
// are equal, and so are its displacements; stresses are the same. The half model, which knows nothing of the other
// side, says what they are. The inner faces on the plane of the rail's axis are not repeated.
TEST(WholeModel, PicturesShowTheRightSideAsTheMirrorImageOfTheLeft) {
  auto options = tests::quietly();
  options.snapshots = true;
  Monitor silent;
  const auto half = simulation::runCase(dip({}), options, silent);
  const auto whole = simulation::runCase(dip({{"model.extent", "whole"}}), options, silent);
  const auto count = half.surface.points.size() / 3;
  ASSERT_EQ(whole.surface.points.size(), 6 * count);
  const float centre = static_cast<float>(-2 * whole.resolvedCase->scenario.wheelset.trackCentre);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(whole.surface.points[3 * (count + i)], half.surface.points[3 * i]);
    ASSERT_EQ(whole.surface.points[3 * (count + i) + 1], centre - half.surface.points[3 * i + 1]);
  }
  std::vector<std::size_t> outer;
  for (std::size_t quad = 0; quad < half.surface.part.size(); ++quad)
    if (!half.surface.partNames[half.surface.part[quad]].ends_with(" cut")) outer.push_back(quad);
  ASSERT_EQ(whole.surface.part.size(), half.surface.part.size() + outer.size());
  EXPECT_EQ(whole.surface.springs.size(), 2 * half.surface.springs.size());
  // Corners run the other way round in a mirror image, so that both normals point outwards.
  for (std::size_t i = 0; i < outer.size(); ++i)
    for (std::size_t corner = 0; corner < 4; ++corner)
      ASSERT_EQ(whole.surface.quads[half.surface.quads.size() + 4 * i + corner],
                static_cast<int>(count) + half.surface.quads[4 * outer[i] + 3 - corner]);
  ASSERT_EQ(whole.snapshots.size(), half.snapshots.size());
  for (std::size_t s = 0; s < half.snapshots.size(); ++s) {
    const auto &both = whole.snapshots[s].displacement, &one = half.snapshots[s].displacement;
    ASSERT_EQ(both.size(), 2 * one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(both[i], one[i]);
      ASSERT_EQ(both[one.size() + i], i % 3 == 1 ? -one[i] : one[i]);
    }
    auto stress = half.snapshots[s].vonMises;
    stress.insert(stress.end(), stress.begin(), stress.begin() + static_cast<std::ptrdiff_t>(count));
    ASSERT_EQ(whole.snapshots[s].vonMises, stress);
  }
  // Each contact counts from its own rail outwards: both are that of the half model.
  ASSERT_EQ(whole.patches.size(), half.patches.size());
  for (std::size_t p = 0; p < half.patches.size(); ++p) {
    ASSERT_FALSE(half.patches[p].right);
    ASSERT_TRUE(whole.patches[p].right);
    for (const auto* side : {&whole.patches[p], whole.patches[p].right.get()}) {
      EXPECT_EQ(side->time, half.patches[p].time);
      EXPECT_EQ(side->y, half.patches[p].y);
      EXPECT_EQ(side->pressure, half.patches[p].pressure);
      EXPECT_EQ(side->tractionY, half.patches[p].tractionY);
      EXPECT_EQ(side->slipping, half.patches[p].slipping);
    }
  }
}

// Left and right are names: exchanged sides give exchanged signals.
TEST(WholeModel, ExchangedSidesGiveExchangedSignals) {
  const auto other =
      rolled(dip({{"model.extent", "whole"}, {"defect.shape", "none"}, {"right.defect.shape", "profile"}}));
  EXPECT_EQ(*other.signal("aba_right"), *oneSided().signal("aba"));
  EXPECT_EQ(*other.signal("aba"), *oneSided().signal("aba_right"));
}

// Where a signal first differs from another by more than `limit` [s].
double departure(const results::RunResult& result, const std::string& signal, const results::RunResult& from,
                 double limit) {
  const auto &values = *result.signal(signal), &others = *from.signal(signal);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - others[i]) > limit) return result.time[i];
  return INFINITY;
}

// The fastest wave in steel bars, sqrt(E / rho), takes 0.29 ms across the axle; bending, which carries most of it, some
// three times as long at 1 kHz. Until then the right side rolls as if neither side had a dip.
TEST(WholeModel, ADipOnTheLeftIsFeltOnTheRightWhenAWaveHasCrossed) {
  const auto description = dip({{"model.extent", "whole"}, {"right.defect.shape", "none"}});
  const auto one = rolled(description), none = rolled(dip({{"model.extent", "whole"}, {"defect.shape", "none"}}));
  const auto& steel = description.wheelset.material;
  const double crossing = 2 * description.wheelset.trackCentre / std::sqrt(steel.young / steel.density);
  const double limit = 0.01 * largest(*one.signal("aba")), sample = 1 / description.output.rate;
  const double delay = departure(one, "aba_right", none, limit) - departure(one, "aba", none, limit);
  EXPECT_GT(delay, crossing - 2 * sample);
  EXPECT_LT(delay, 5 * crossing);
}

// What modal damping takes of both kinds of modes is known exactly, so that the balance closes with it as without. The
// limit is that of the half model (RunCaseTest): a fifth of the one at which a run is stopped.
TEST(WholeModel, EnergyOfBothSidesIsBalanced) {
  const auto damped =
      rolled(dip({{"model.extent", "whole"}, {"right.defect.shape", "none"}, {"wheelset.damping_ratio", "0.02"}}));
  EXPECT_LT(energyResidual(oneSided()), 1e-3);
  EXPECT_LT(energyResidual(damped), 1e-3);
  EXPECT_LT(largest(*damped.signal("aba_right")), largest(*oneSided().signal("aba_right")));
}

TEST(WholeModel, FeaturesTellTheSidesApart) {
  const auto row = analysis::featureTable(oneSided());
  const auto valueOf = [&](const std::string& name) {
    for (const auto& [column, value] : row)
      if (column == name) return value;
    return std::nan("");
  };
  EXPECT_EQ(valueOf("right peak [m/s2]"), largest(*oneSided().signal("aba_right_filtered")));
  EXPECT_EQ(valueOf("right largest contact force [N]"), largest(*oneSided().signal("contact_force_right")));
  EXPECT_NE(valueOf("peak [m/s2]"), valueOf("right peak [m/s2]"));
}

// With three threads the wheelset is shared among them, with one or two it is not.
TEST(WholeModel, SameBitsForAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    const auto other = rolled(dip({{"model.extent", "whole"}, {"right.defect.shape", "none"}}), threads);
    for (const auto& channel : oneSided().signals)
      EXPECT_EQ(*other.signal(channel.name), channel.values) << channel.name << ", threads: " << threads;
  }
}

TEST(WholeModel, AResumedRunGivesTheSameBits) {
  const tests::TemporaryFolder folder;
  const auto description = dip({{"model.extent", "whole"}, {"right.defect.shape", "none"}});
  simulation::RunOptions options;
  options.threads = 2, options.wheelsetModes = false, options.snapshots = true;
  Monitor silent;
  const auto whole = simulation::runCase(description, options, silent);
  options.checkpointPath = folder / "whole.checkpoint", options.checkpointSeconds = 1e9;
  tests::CancelAt stopping(0.5);
  const auto stopped = simulation::runCase(description, options, stopping);
  ASSERT_FALSE(stopped.complete);
  options.resume = true;
  const auto resumed = simulation::runCase(description, options, silent);
  ASSERT_TRUE(resumed.complete);
  for (const auto& channel : oneSided().signals)
    EXPECT_EQ(*resumed.signal(channel.name), channel.values) << channel.name;
  const auto patchesOf = [](const results::RunResult& result) {
    results::RunResult alone;
    alone.patches = result.patches;
    return results::toTree(alone);
  };
  EXPECT_EQ(results::firstDifference(patchesOf(resumed), patchesOf(whole)), "");
  const auto impact = std::find_if(resumed.patches.begin(), resumed.patches.end(),
                                   [](const auto& patch) { return patch.name == "impact"; });
  ASSERT_NE(impact, resumed.patches.end());
  ASSERT_TRUE(impact->right);
  EXPECT_NE(impact->right->pressure, impact->pressure);  // the left rail alone has the dip
}

// Sides that are not alike start from an equilibrium of their own: on a smooth rail each wheel carries what it carries
// at rest, on the mean, and energy is balanced. A patch of few points ripples: the half model's force leaves that at
// rest by up to 7 % on this mesh.
TEST(WholeModel, UnlikeSidesStartAtRest) {
  const auto result = rolled(dip({{"model.extent", "whole"},
                                  {"defect.shape", "none"},
                                  {"suspension.sprung_mass", "9000"},
                                  {"right.suspension.sprung_mass", "6000"},
                                  {"right.pad.stiffness", "300"},
                                  {"right.contact.friction", "0.2"}}));
  EXPECT_LT(energyResidual(result), 1e-3);
  const auto atRest = [&](const std::string& name) {
    for (const auto& figure : result.equilibrium)
      if (figure.name == name) return figure.value;
    return std::nan("");
  };
  EXPECT_GT(atRest("contact_force"), 1.2 * atRest("contact_force_right"));
  for (const std::string name : {"contact_force", "contact_force_right"}) {
    const auto& forces = *result.signal(name);
    double mean = 0;
    for (const double force : forces) mean += force / static_cast<double>(forces.size());
    EXPECT_NEAR(mean, atRest(name), 0.01 * atRest(name)) << name;
    for (const double force : forces) ASSERT_NEAR(force, atRest(name), 0.1 * atRest(name)) << name;
  }
}

// Left and right are names for unlike sides too, with wheels of unlike rolling radii. The equilibrium is found to 1e-7
// of the load in another order of sums; what that leaves is far below 1e-4 of the signals' largest values.
TEST(WholeModel, ExchangedUnlikeSidesGiveExchangedSignals) {
  const Settings common{{"model.extent", "whole"}, {"rail.inclination", "0.025"}, {"wheelset.cone", "0.03"}};
  Settings one = common, other = common;
  for (const auto& [key, heavy, light] :
       {std::array{"suspension.sprung_mass", "9000", "7000"}, std::array{"pad.stiffness", "1300", "400"},
        std::array{"motion.lateral_offset", "1", "-1"}}) {
    one.push_back({key, heavy}), one.push_back({std::string("right.") + key, light});
    other.push_back({key, light}), other.push_back({std::string("right.") + key, heavy});
  }
  const auto first = rolled(dip(one), 2), second = rolled(dip(other), 3);
  for (const std::string name : {"aba", "aba_lateral", "contact_force"})
    for (const auto& [mine, its] : {std::pair{name, name + "_right"}, std::pair{name + "_right", name}}) {
      const auto &a = *first.signal(mine), &b = *second.signal(its);
      ASSERT_EQ(a.size(), b.size());
      double difference = 0;
      for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
      EXPECT_LT(difference, 1e-4 * largest(a)) << mine;
    }
}

// What a number leaves out or takes for granted is a warning.
TEST(WholeModel, LateralLimitsAreWarnings) {
  const auto warns = [](const std::vector<std::string>& warnings, const std::string& words) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const auto& text) { return text.find(words) != std::string::npos; });
  };
  const auto onSpring = dip({{"model.extent", "whole"}, {"wheelset.bearing_stiffness", "500"}});
  std::vector<std::string> advice;
  for (const auto& warning : cases::validate(onSpring).warnings) advice.push_back(warning.advice);
  EXPECT_TRUE(warns(advice, "no mass along the axle"));
  // Contacts 3 mm beside the middle of a crown of 300 mm lean by 1 %: some 1.8 kN push against 2 x 1 MN/m.
  const auto shifted = rolled(dip({{"model.extent", "whole"},
                                   {"motion.lateral_offset", "3"},
                                   {"right.motion.lateral_offset", "-3"},
                                   {"suspension.lateral_stiffness", "1"}}));
  EXPECT_TRUE(warns(shifted.warnings, "mm to the"));
  EXPECT_FALSE(warns(oneSided().warnings, "mm to the"));
}

// A wheel that levers lift off its rail is refused with the load that keeps it there, which is accepted.
TEST(WholeModel, AWheelThatLiftsIsRefused) {
  const auto problemOf = [](const std::string& mass) -> std::optional<CaseProblem> {
    const auto found = cases::validate(
        cases::parseUnfinishedCase("[model]\nextent = \"whole\"\n[right.suspension]\nsprung_mass = " + mass, "a case"));
    if (found.problems.empty()) return std::nullopt;
    return found.problems.front();
  };
  const auto problem = problemOf("1");
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->key, "right.suspension.sprung_mass");
  EXPECT_NE(problem->advice.find("The right wheel lifts"), std::string::npos);
  const std::string start = "at least ";
  ASSERT_EQ(problem->allowed.find(start), 0u) << problem->allowed;
  EXPECT_FALSE(problemOf(std::to_string(std::stod(problem->allowed.substr(start.size())))));
  EXPECT_FALSE(problemOf("7000"));
}

// Rails of a random irregularity have one of their own each; the same one on both is said.
TEST(WholeModel, RailsMayBeRoughInDifferentWays) {
  const Settings rough{{"model.extent", "whole"}, {"defect.shape", "none"}, {"rail.irregularity", "iso-3095"}};
  Settings unlike = rough;
  unlike.push_back({"right.rail.irregularity_seed", "7"});
  const auto same = dip(rough), own = dip(unlike);
  const auto isSaid = [](const cases::CaseDescription& description) {
    const auto warnings = cases::validate(description).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [](const auto& warning) { return warning.advice.find("mirror images") != std::string::npos; });
  };
  EXPECT_TRUE(isSaid(same));
  EXPECT_FALSE(isSaid(own));
  const auto result = rolled(own);
  EXPECT_LT(energyResidual(result), 1e-3);
  EXPECT_NE(*result.signal("irregularity"), *result.signal("irregularity_right"));
  EXPECT_GT(largest(*result.signal("aba_lateral")), 0);
}

// A profile that the right side names is read beside the case, and the case keeps its points.
TEST(WholeModel, TheRightSideMayHaveAProfileOfItsOwn) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "left.csv") << ("position [mm],height [mm]\n-20,0\n0,-0.1\n20,0\n");
  std::ofstream(folder / "right.csv") << ("position [mm],height [mm]\n-30,0\n0,-0.2\n30,0\n");
  std::ofstream(folder / "both.toml")
      << ("[model]\nextent = \"whole\"\n[defect]\nshape = \"profile\"\nfile = \"left.csv\"\n"
          "[right.defect]\nfile = \"right.csv\"\n");
  const auto description = cases::readCase(folder / "both.toml");
  const auto right = cases::rightOf(description);
  ASSERT_EQ(right.defect.points.size(), 3u);
  EXPECT_DOUBLE_EQ(right.defect.points[0].position, -0.03);
  EXPECT_DOUBLE_EQ(right.defect.points[1].height, -0.2e-3);
  EXPECT_DOUBLE_EQ(description.defect.points[1].height, -0.1e-3);
  const auto again = cases::parseCase(cases::writeCase(description), "elsewhere, without the files");
  EXPECT_EQ(cases::rightOf(again).defect.points.size(), 3u);
  EXPECT_EQ(cases::caseHash(again), cases::caseHash(description));
  // Points that are set count more than the file; another shape keeps the file's name.
  const std::string points = "[[-10, 0], [0, -0.3], [10, 0]]";
  const auto set = cases::readCase(folder / "both.toml", {"", {{"right.defect.points", points}}});
  EXPECT_DOUBLE_EQ(cases::rightOf(set).defect.points[1].height, -0.3e-3);
  const auto smooth = cases::readCase(folder / "both.toml", {"", {{"right.defect.shape", "none"}}});
  EXPECT_EQ(cases::rightOf(smooth).defect.shape, cases::DefectShape::none);
  auto cosine = description;
  cases::setValue(cosine, "defect.shape", "cosine");
  EXPECT_NO_THROW(cases::parseCase(cases::writeCase(cosine), "saved with another shape"));
}

// No output may overwrite what the right side names.
TEST(WholeModel, FilesOfTheRightSideBelongToTheCase) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "right.csv") << "position [mm],height [mm]\n-30,0\n0,-0.2\n30,0\n";
  std::ofstream(folder / "case.toml") << "[model]\nextent = \"whole\"\n[right.defect]\nshape = \"profile\"\n"
                                         "file = \"right.csv\"\n";
  const auto files = cases::filesOfCase(folder / "case.toml", cases::readCase(folder / "case.toml"));
  EXPECT_NE(std::find(files.begin(), files.end(), folder / "right.csv"), files.end());
}

// Up to the defects a whole model moves as it does without them: a state from there serves other defects on either side
// with the bits of the whole run, and is refused where a side differs in anything else.
TEST(WholeModel, StartsFromAWarmState) {
  Settings keys{{"model.extent", "whole"},     {"motion.run_up", "0.1"},   {"motion.beyond", "0.06"},
                {"mesh.zone_before", "30"},    {"mesh.zone_behind", "30"}, {"right.suspension.sprung_mass", "7000"},
                {"right.defect.shape", "none"}};
  const auto made = dip(keys);
  simulation::RunOptions options;
  options.threads = 2, options.wheelsetModes = options.snapshots = false;
  Monitor silent;
  auto warm = simulation::makeWarmState(made, options, silent);
  ASSERT_TRUE(warm);
  options.warm = std::make_shared<const simulation::WarmState>(*std::move(warm));
  keys.back() = {"right.defect.height_scale", "0.5"};
  const auto other = dip(keys);
  const auto from = simulation::runCase(other, options, silent);
  const auto whole = rolled(other);
  ASSERT_EQ(from.signals.size(), whole.signals.size());
  for (const auto& channel : whole.signals) EXPECT_EQ(*from.signal(channel.name), channel.values) << channel.name;
  keys.push_back({"right.pad.stiffness", "500"});
  try {
    simulation::runCase(dip(keys), options, silent);
    ADD_FAILURE() << "a state of other pads was taken";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("right.pad.stiffness"), std::string::npos) << error.what();
  }
}

// What a case says of the right side is kept when it is written, in whatever order it was stated, and counts in its
// hash only where there is a right side.
TEST(WholeModel, KeysOfTheRightSideAreReadAndWritten) {
  const std::string whole = "[model]\nextent = \"whole\"\n";
  const auto description = cases::parseCase(whole + "[right.defect]\nlength = 30\ndepth = 0.02\n", "a case");
  const auto text = cases::writeCase(description);
  const auto again = cases::parseCase(text, "the same");
  EXPECT_EQ(cases::writeCase(again), text);
  EXPECT_EQ(cases::caseHash(again), cases::caseHash(description));
  EXPECT_NE(text.find("[right.defect]"), std::string::npos);
  const auto right = cases::rightOf(description);
  EXPECT_DOUBLE_EQ(right.defect.depth, 0.02e-3);
  EXPECT_DOUBLE_EQ(right.defect.length, 30e-3);
  const auto half = cases::parseCase("[right.defect]\ndepth = 0.02\n", "half"), plain = cases::parseCase("", "plain");
  EXPECT_EQ(cases::caseHash(half), cases::caseHash(plain));
  const auto alike = cases::parseCase(whole, "alike");
  EXPECT_NE(cases::caseHash(description), cases::caseHash(alike));
  EXPECT_NE(cases::caseHash(alike), cases::caseHash(plain));
}

std::string messageOf(const std::string& text) {
  try {
    cases::parseCase(text, "a case");
  } catch (const CaseError& error) {
    return error.what();
  }
  return {};
}

TEST(WholeModel, WhatBothSidesShareIsRefusedOnTheRight) {
  EXPECT_NE(messageOf("[right.motion]\nspeed = 20\n").find("right.motion.speed"), std::string::npos);
  EXPECT_NE(messageOf("[right.defect]\ndept = 0.1\n").find("Did you mean right.defect.depth?"), std::string::npos);
  EXPECT_NE(messageOf("[right.defect]\ndepth = 900\n").find("right.defect.depth"), std::string::npos);
  EXPECT_NE(messageOf("[right.defect]\nfile = \"dip.csv\"\n").find("profile if right.defect.file"), std::string::npos);
  EXPECT_NE(messageOf("[right.pad]\nlength = 0.24\n").find("right.pad.length"), std::string::npos);
  EXPECT_NE(messageOf("[right.pad]\ncurve = [[0, 0], [1, 50]]\n").find("right.pad.curve"), std::string::npos);
  EXPECT_NE(messageOf("[right]\n").find("right"), std::string::npos);
  EXPECT_NE(messageOf("[model]\nextent = \"whole\"\n[rail]\nplastic = true\n").find("rail.plastic"), std::string::npos);
}

// A key without effect is said: on a half model, and where another key of the right side leaves it none.
TEST(WholeModel, KeysOfTheRightSideWithoutEffectAreSaid) {
  const auto warningOf = [](const std::string& text) {
    for (const auto& warning : cases::validate(cases::parseCase(text, "a case")).warnings)
      if (warning.key == "right.defect.depth") return warning.advice;
    return std::string();
  };
  const std::string whole = "[model]\nextent = \"whole\"\n", depth = "depth = 0.02\n";
  EXPECT_NE(warningOf("[right.defect]\n" + depth).find("model.extent is half"), std::string::npos);
  EXPECT_NE(warningOf(whole + "[right.defect]\nshape = \"none\"\n" + depth).find("defect.shape is none"),
            std::string::npos);
  EXPECT_EQ(warningOf(whole + "[right.defect]\n" + depth), "");
}

}  // namespace
}  // namespace squat
