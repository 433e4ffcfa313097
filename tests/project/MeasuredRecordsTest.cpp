// Measured signals along the track: laid automatically, and by hand.
#include "project/MeasuredRecords.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "analysis/Folder.h"
#include "core/Errors.h"

namespace squat::project {
namespace {

using tests::Folder;

// One sample of 50 m/s2 at 0.1 s, 1000 samples a second: too slow to be filtered, so that every value is known.
MeasuredRecord strike(const Folder& folder, double impact) {
  std::string text = "time [s],aba [m/s2]\n";
  for (int i = 0; i < 200; ++i) text += std::to_string(i / 1000.0) + "," + (i == 100 ? "50" : "0.5") + "\n";
  folder.write("strike.csv", text);
  return measuredRecords(folder.path("strike.csv"), 20, {{}, impact}).at(0);
}

TEST(MeasuredRecords, TheLargestValueLiesWhereItIsPut) {
  const Folder folder;
  const auto measured = strike(folder, 0.25);
  EXPECT_NEAR(measured.record->position[100], 0.25, 1e-12);
  EXPECT_NEAR(measured.record->position[101] - measured.record->position[100], 20 / 1000.0, 1e-12);
  EXPECT_EQ(measured.reading.options.speed, 20);  // it was assumed: a project has to know
}

TEST(MeasuredRecords, AreLaidAnewWithAnotherPlaceSpeedAndGain) {
  const Folder folder;
  const auto measured = strike(folder, 0.25);
  auto wanted = measured.reading;
  wanted.impact = -0.1, wanted.options.speed = 25, wanted.gain = 2;
  const auto anew = realigned(measured, wanted);
  EXPECT_NEAR(anew.record->position[100], -0.1, 1e-12);
  EXPECT_NEAR(anew.record->position[101] - anew.record->position[100], 25 / 1000.0, 1e-12);
  EXPECT_EQ((*anew.record->signal("aba"))[100], 100);
  EXPECT_EQ((*anew.record->signal("aba_filtered"))[99], 1);
  EXPECT_EQ(anew.reading.gain, 2);
  // Numbers of the whole signal have the gain as well.
  EXPECT_EQ(wholeRecord(anew).signals.front().values[100], 100);
  EXPECT_EQ(wholeRecord(measured).signals.front().values[100], 50);
}

TEST(MeasuredRecords, AreMovedForAMoment) {
  const Folder folder;
  const auto measured = strike(folder, 0.25);
  const auto dragged = moved(*measured.record, 0.05);
  EXPECT_NEAR(dragged->position[100], 0.3, 1e-12);
  EXPECT_EQ(*dragged->signal("aba"), *measured.record->signal("aba"));
}

TEST(MeasuredRecords, AFileThatIsGoneIsNamed) {
  const Folder folder;
  const auto measured = strike(folder, 0);
  std::filesystem::remove(folder.path("strike.csv"));
  EXPECT_THROW(realigned(measured, measured.reading), FileError);
}

TEST(MeasuredRecords, ANameSaysItsGain) {
  EXPECT_EQ(nameWithGain("run 1", {}), "run 1");
  EXPECT_EQ(nameWithGain("run 1", {{}, 0, 1.25}), "run 1 × 1.25");
}

}  // namespace
}  // namespace squat::project
