// Whole runs on supports that are not linear: the energy balance closes as on linear ones.
#include <gtest/gtest.h>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "simulation/RunCase.h"

namespace squat {
namespace {

using Overrides = std::vector<std::pair<std::string, std::string>>;

// 0.1 % of the strain energy at the start plus all dissipation.
void expectEnergyBalance(Overrides values) {
  values.insert(values.begin(), {"motion.beyond", "0.05"});
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = false;
  options.snapshots = false;
  Monitor silent;
  const auto result =
      simulation::runCase(cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", values}), options, silent);
  ASSERT_TRUE(result.complete);
  bool found = false;
  for (const auto& item : result.performance)
    if (item.name == "energy_residual") {
      found = true;
      EXPECT_LT(item.value, 1e-3);
    }
  EXPECT_TRUE(found);
}

TEST(SupportRun, EnergyIsAccountedForOnProgressivePads) {
  expectEnergyBalance({{"pad.curve", "[[0, 0], [0.05, 15], [0.15, 115], [0.2, 215]]"}, {"pad.preload", "10"}});
}

// The sleeper under the defect hangs over a void that closes as the wheel comes near.
TEST(SupportRun, EnergyIsAccountedForAboveAVoid) {
  expectEnergyBalance({{"track.seats", "[{ sleeper = 0, gap = 0.5 }]"}});
}

// Operator, start and loop see one and the same sleeper.
TEST(SupportRun, EnergyIsAccountedForOnSleepersWithALowMiddle) {
  expectEnergyBalance({{"sleeper.middle_height", "0.1"}, {"sleeper.middle_half_length", "0.4"}});
}

// The forces of a sleeper's shape are added in one order, whoever adds them.
TEST(SupportRun, SleepersWithALowMiddleGiveTheSameBitsOnTwoThreads) {
  const auto run = [](int threads) {
    simulation::RunOptions options;
    options.threads = threads;
    options.wheelsetModes = false;
    options.snapshots = false;
    Monitor silent;
    return *simulation::runCase(
                cases::loadCase(tests::fixtureCase("light-defect"),
                                {"tiny", {{"motion.beyond", "0.05"}, {"sleeper.middle_height", "0.1"}}}),
                options, silent)
                .signal("aba");
  };
  EXPECT_EQ(run(1), run(2));
}

}  // namespace
}  // namespace squat
