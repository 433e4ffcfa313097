// What is said while and after something is computed.
#include <gtest/gtest.h>

#include "studio/runs/ProgressText.h"

namespace squat::studio {
namespace {

TEST(ProgressText, aRunThatIsDoneNamesItsTimeAndItsPeaks) {
  results::RunResult result;
  result.signals = {{"aba_filtered", "m/s2", "", {0, 112.24, -98.06, 3}},
                    {"contact_force", "N", "", {9e4, 131240, 8e4}}};
  result.performance = {{"steps", "-", "", 9000}, {"seconds", "s", "", 83.4}};
  EXPECT_EQ(completionText(result).toStdString(),
            "Done in 1 min 23 s: axle box acceleration -98.1 to 112.2 m/s², contact force up to 131.2 kN.");
}

TEST(ProgressText, ofSeveralWheelsThoseThatLiftOffAreNamed) {
  results::RunResult result;
  result.time = {0, 0.001, 0.002};
  result.signals = {{"contact_force", "N", "", {9e4, 0, 8e4}}};
  EXPECT_EQ(completionText(result), "Done: contact force up to 90.0 kN.");
  result.signals.push_back({"contact_force_right", "N", "", {8e4, 7e4, 0}});
  EXPECT_EQ(
      completionText(result).toStdString(),
      "Done: contact force up to 90.0 kN, the left wheel lifts off at 1.0 ms, the right wheel lifts off at 2.0 ms.");
}

TEST(ProgressText, whatAResultLacksIsLeftOut) {
  results::RunResult result;
  EXPECT_EQ(completionText(result), "Done.");
  result.performance = {{"seconds", "s", "", 4.2}};
  EXPECT_EQ(completionText(result), "Done in 4 s.");
  EXPECT_EQ(completionText(result, true), "Done, 4 s after it was resumed.");
}

}  // namespace
}  // namespace squat::studio
