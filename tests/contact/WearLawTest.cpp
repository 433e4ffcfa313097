// Depth that friction takes off.
#include "contact/WearLaw.h"

#include <gtest/gtest.h>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::contact {
namespace {

WearLaw lawOf(std::vector<std::pair<std::string, std::string>> values) {
  return wearLawOf(cases::resolve(cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", std::move(values)})));
}

// Archard: k p s / H of sliding s under pressure p; friction does mu p s of work per area.
TEST(WearLaw, ArchardIsProportionalToWork) {
  const auto law =
      lawOf({{"growth.wear_coefficient", "0.0003"}, {"growth.hardness", "2.5"}, {"contact.friction", "0.4"}});
  const double pressure = 1e9, sliding = 0.002;  // per metre rolled
  EXPECT_NEAR(wearDepth(law, 0.4 * pressure * sliding), 3e-4 * pressure * sliding / 2.5e9, 1e-22);
  EXPECT_DOUBLE_EQ(wearDepth(law, 2e9), 2 * wearDepth(law, 1e9));
}

// Lewis and Olofsson: 5.3 ug/(m mm2) per N/mm2 up to 10.4 N/mm2, 55 up to 77.2, 61.9 per N/mm2 beyond; steel weighs
// 7800 kg/m3 in this case. 1 ug/(m mm2) is 1e-3 kg/(m m2).
TEST(WearLaw, TGammaHasThreeBranches) {
  const auto law = lawOf({{"growth.wear", "t-gamma"}});
  const double depthPerMicrogram = 1e-3 / 7800;
  EXPECT_NEAR(wearDepth(law, 4e6), 5.3 * 4 * depthPerMicrogram, 1e-15);
  EXPECT_NEAR(wearDepth(law, 40e6), 5.3 * 10.4 * depthPerMicrogram, 1e-15);
  EXPECT_NEAR(wearDepth(law, 80e6), (5.3 * 10.4 + 61.9 * 2.8) * depthPerMicrogram, 1e-15);
}

// Three sources for mild wear of dry steel, computed apart: twin discs 6.75e-13 m3/J (5.3 ug, 7850 kg/m3), British Rail
// 7.85e-13, Archard with k = 5e-4 and 2.6 GPa 6.4e-13. The laws agree as the sources do, within 25 %.
TEST(WearLaw, BothLawsAgreeWhereWearIsMild) {
  const double archard = wearDepth(lawOf({{"growth.wear_coefficient", "0.0005"}}), 1e6),
               tGamma = wearDepth(lawOf({{"growth.wear", "t-gamma"}}), 1e6);
  EXPECT_NEAR(tGamma / 1e6, 6.75e-13, 0.1e-13);
  EXPECT_NEAR(archard / tGamma, 1, 0.25);
}

TEST(WearLaw, NothingWearsWithoutALawOrWithoutFriction) {
  EXPECT_EQ(wearDepth(lawOf({{"growth.wear", "none"}}), 1e9), 0);
  EXPECT_EQ(wearDepth(lawOf({{"contact.friction", "0"}}), 1e9), 0);
}

}  // namespace
}  // namespace squat::contact
