// Keys of the steel that ratchets, of wear and of the traffic.
#include <gtest/gtest.h>

#include <cmath>

#include "case/CaseFile.h"
#include "contact/WearLaw.h"
#include "growth/Grow.h"
#include "growth/Traffic.h"
#include "keys/Keys.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::scenarioWith;

// GPa become Pa; rates and the exponent have no unit.
TEST(SteelKeys, MakeTheLawOfTheLayer) {
  const auto law = modelWith({{"rail.plastic", "true"},
                              {"rail.hardening", "chaboche"},
                              {"rail.yield_stress", "0.41"},
                              {"rail.backstress_modulus_1", "120"},
                              {"rail.backstress_recovery_1", "900"},
                              {"rail.backstress_modulus_2", "11"},
                              {"rail.backstress_recovery_2", "80"},
                              {"rail.backstress_modulus_3", "7"},
                              {"rail.backstress_recovery_3", "6"},
                              {"rail.recovery_exponent", "4"},
                              {"rail.isotropic_saturation", "-0.05"},
                              {"rail.isotropic_rate", "30"}})
                       .layer.law;
  EXPECT_TRUE(law.recovers);
  EXPECT_NEAR(law.yieldStress, 0.41e9, 1);
  const double modulus[3] = {120e9, 11e9, 7e9}, recovery[3] = {900, 80, 6};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(law.backstresses[i].modulus, modulus[i], 1);
    EXPECT_EQ(law.backstresses[i].recovery, recovery[i]);
  }
  EXPECT_EQ(law.exponent, 4);
  EXPECT_NEAR(law.saturation, -0.05e9, 1);
  EXPECT_EQ(law.rate, 30);
  EXPECT_EQ(law.isotropic, 0);
}

// Large plastic strain brings the steel to its yield stress and all that its back-stresses grow to: the curve that the
// values were fitted to, 985 MPa at 7 %, within the 3 % of a fit by hand.
TEST(SteelKeys, ThePresetHasTheStrengthOfItsSteel) {
  const auto law = modelWith({{"rail.preset", "R260"}}).layer.law;
  const auto stressAt = [&](double plastic) {
    double stress = law.yieldStress;
    for (const auto& one : law.backstresses)
      stress += one.modulus / one.recovery * (1 - std::exp(-one.recovery * plastic));
    return stress;
  };
  EXPECT_NEAR(stressAt(0.002), 490e6, 0.03 * 490e6);
  EXPECT_NEAR(stressAt(0.02), 690e6, 0.03 * 690e6);
  EXPECT_NEAR(stressAt(0.07), 985e6, 0.03 * 985e6);
}

TEST(GrowthKeys, WearAndHardness) {
  const auto slope = [](tests::Values values) { return contact::wearLawOf(scenarioWith(values)).slope; };
  const double usual = slope({});
  EXPECT_NEAR(slope({{"growth.wear_coefficient", "0.0002"}}), 2 * usual, 1e-9 * usual);
  EXPECT_NEAR(slope({{"growth.hardness", "5.2"}}), usual / 2, 1e-9 * usual);
  EXPECT_EQ(slope({{"growth.wear", "none"}}), 0);
}

TEST(GrowthKeys, TheTrafficScattersAsStated) {
  const auto growth = scenarioWith({{"growth.wheelsets", "2"},
                                    {"growth.lateral_scatter", "4"},
                                    {"growth.load_scatter", "0.3"},
                                    {"growth.speed_scatter", "0.2"},
                                    {"growth.traction", "0.02"},
                                    {"growth.traction_scatter", "0.1"},
                                    {"growth.seed", "3"}})
                          .growth;
  EXPECT_EQ(growth.seed, 3);
  const auto draws = growth::drawTraffic(growth);
  ASSERT_EQ(draws.size(), 2u);
  EXPECT_NEAR(std::abs(draws[0].lateral), 0.004, 1e-12);  // two strata stand one standard deviation off the mean
  EXPECT_NEAR(std::abs(draws[0].load - 1), 0.3, 1e-12);
  EXPECT_NEAR(std::abs(draws[0].speed - 1), 0.2, 1e-12);
  EXPECT_NEAR(std::abs(draws[0].traction - 0.02), 0.1, 1e-12);
}

// No block may change the shape by more, but for what all wheelsets do as they roll once.
TEST(GrowthKeys, BlockChangeLimitsABlock) {
  Monitor silent;
  growth::GrowthOptions options;
  options.tonnage = 0.1e9, options.threads = 1;
  const auto largestStep = [&](const char* change) {
    const auto growth = growth::grow(cases::loadCase("light-defect", {"tiny",
                                                                      {{"motion.torque", "0"},
                                                                       {"growth.wheelsets", "1"},
                                                                       {"growth.wear_coefficient", "0.001"},
                                                                       {"growth.block_change", change}}}),
                                     options, silent);
    double largest = 0;
    for (std::size_t i = 1; i < growth.stages.size(); ++i) largest = std::max(largest, growth.stages[i].block);
    return largest;
  };
  EXPECT_LT(largestStep("0.0003"), 0.5 * largestStep("0.01"));
}

}  // namespace
}  // namespace squat
