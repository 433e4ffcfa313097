// How far from below the axle contact is looked for.
// Expected: where a rigid wheel of 0.46 m touches a cosine dip, the largest of its offsets while it rolls over, found
// by trying every point of the path outside this program. The patch reaches 7 mm beyond (Hertz, 87.8 kN).
#include <gtest/gtest.h>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "model/Model.h"

namespace squat::contact {
namespace {

struct Dip {
  const char *length, *depth;  // [mm]
  double offset;               // [m]
};

double reachOf(const Dip& dip) {
  const auto description = cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny",
                                                                               {{"defect.shape", "cosine"},
                                                                                {"defect.length", dip.length},
                                                                                {"defect.depth", dip.depth},
                                                                                {"motion.run_up", "0.2"},
                                                                                {"motion.beyond", "0.2"}}});
  return model::buildModel(cases::resolve(description)).surfaces.reach;
}

TEST(Reach, HoldsThePatchOnTheSlopesOfDeepDips) {
  for (const Dip& dip :
       {Dip{"57", "1", 0.0202}, Dip{"100", "2", 0.0282}, Dip{"150", "4", 0.0384}, Dip{"200", "5", 0.0360}})
    EXPECT_GE(reachOf(dip), dip.offset + 0.007) << dip.length << " x " << dip.depth << " mm";
}

// 20 mm hold any patch on smooth rail; looking farther costs time.
TEST(Reach, StaysShortOnShallowOnes) { EXPECT_DOUBLE_EQ(reachOf({"50", "0.15", 0}), 0.020); }

}  // namespace
}  // namespace squat::contact
