// Both rails and the whole wheelset (model.extent = whole): what theory says of mirror images and of energy, and that a
// run is the same with any number of threads and after it was resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "FixtureCase.h"
#include "TemporaryFolder.h"
#include "case/CaseFile.h"
#include "case/RightSide.h"
#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
#include "simulation/RunCase.h"
#include "simulation/StoppedRuns.h"

namespace squat {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

// A dip of the light defect's shape, reached after 60 mm and left behind after 60 mm.
cases::CaseDescription dip(Settings settings) {
  settings.insert(settings.begin(), {{"motion.run_up", "0.06"}, {"motion.beyond", "0.06"}});
  return cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", settings});
}

results::RunResult rolled(const cases::CaseDescription& description, int threads = 2) {
  simulation::RunOptions options;
  options.threads = threads;
  options.wheelsetModes = options.snapshots = false;
  Monitor silent;
  return simulation::runCase(description, options, silent);
}

const results::RunResult& oneSided() {
  static const auto result = rolled(dip({{"model.extent", "whole"}, {"right.defect.depth", "0.01"}}));
  return result;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// Mirror images need no mirror: the half model is exact for equal sides. Every operation on both sides is one of the
// half model, so that nothing is lost to rounding either.
TEST(WholeModel, EqualSidesMoveAsTheHalfModelDoes) {
  const auto half = rolled(dip({})), whole = rolled(dip({{"model.extent", "whole"}}));
  for (const char* name : {signals::names::axleBox, signals::names::contactForce, signals::names::wheelSpeed}) {
    EXPECT_EQ(*whole.signal(name), *half.signal(name)) << name;
    EXPECT_EQ(*whole.signal(std::string(name) + "_right"), *half.signal(name)) << name;
  }
}

// Left and right are names: exchanged sides give exchanged signals.
TEST(WholeModel, ExchangedSidesGiveExchangedSignals) {
  const auto other = rolled(dip({{"model.extent", "whole"}, {"defect.depth", "0.01"}, {"right.defect.depth", "0.15"}}));
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

// As of the half model (RunCaseTest): 0.5 %, the limit at which a run is stopped, is far away.
TEST(WholeModel, EnergyOfBothSidesIsBalanced) {
  const auto& figures = oneSided().performance;
  const auto found =
      std::find_if(figures.begin(), figures.end(), [](const auto& one) { return one.name == "energy_residual"; });
  ASSERT_NE(found, figures.end());
  EXPECT_LT(found->value, 2e-4);
}

TEST(WholeModel, AnyNumberOfThreadsGivesTheSameBits) {
  const auto alone = rolled(dip({{"model.extent", "whole"}, {"right.defect.depth", "0.01"}}), 1);
  for (const auto& channel : oneSided().signals) EXPECT_EQ(*alone.signal(channel.name), channel.values) << channel.name;
}

TEST(WholeModel, AResumedRunGivesTheSameBits) {
  const tests::TemporaryFolder folder;
  const auto description = dip({{"model.extent", "whole"}, {"right.defect.depth", "0.01"}});
  simulation::RunOptions options;
  options.threads = 2, options.wheelsetModes = options.snapshots = false;
  options.checkpointPath = folder / "whole.checkpoint", options.checkpointSeconds = 1e9;
  tests::CancelAt stopping(0.5);
  const auto stopped = simulation::runCase(description, options, stopping);
  ASSERT_FALSE(stopped.complete);
  options.resume = true;
  Monitor silent;
  const auto resumed = simulation::runCase(description, options, silent);
  ASSERT_TRUE(resumed.complete);
  for (const auto& channel : oneSided().signals)
    EXPECT_EQ(*resumed.signal(channel.name), channel.values) << channel.name;
}

// What a case says of the right side is kept when it is written, and counts in its hash only where there is one.
TEST(WholeModel, KeysOfTheRightSideAreReadAndWritten) {
  const auto description = cases::parseCase("[model]\nextent = \"whole\"\n[right.defect]\ndepth = 0.02\n", "a case");
  const auto text = cases::writeCase(description);
  EXPECT_EQ(cases::writeCase(cases::parseCase(text, "the same")), text);
  EXPECT_NE(text.find("[right.defect]"), std::string::npos);
  const auto right = cases::rightOf(description);
  EXPECT_DOUBLE_EQ(right.defect.depth, 0.02e-3);
  EXPECT_DOUBLE_EQ(right.defect.length, description.defect.length);
  const auto half = cases::parseCase("[right.defect]\ndepth = 0.02\n", "half"), plain = cases::parseCase("", "plain");
  EXPECT_EQ(cases::caseHash(half), cases::caseHash(plain));
  const auto alike = cases::parseCase("[model]\nextent = \"whole\"\n", "alike");
  EXPECT_NE(cases::caseHash(description), cases::caseHash(alike));
  EXPECT_NE(cases::caseHash(alike), cases::caseHash(plain));
}

TEST(WholeModel, WhatBothSidesShareIsRefusedOnTheRight) {
  const auto messageOf = [](const std::string& text) -> std::string {
    try {
      cases::parseCase(text, "a case");
    } catch (const CaseError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(messageOf("[right.motion]\nspeed = 20\n").find("right.motion.speed"), std::string::npos);
  EXPECT_NE(messageOf("[right.defect]\ndept = 0.1\n").find("Did you mean right.defect.depth?"), std::string::npos);
  EXPECT_NE(messageOf("[right.defect]\ndepth = 900\n").find("right.defect.depth"), std::string::npos);
}

}  // namespace
}  // namespace squat
