// Measured signals along the track: laid automatically, and by hand.
#include "project/MeasuredRecords.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

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

// A ringing of 45 mm that begins at 0 [m]; its lobes are raised by `gains`, one after the other.
double ringing(double x, const std::vector<double>& gains) {
  constexpr double wavelength = 0.045, decay = 0.06;
  if (x <= 0) return 0;
  const auto lobe = static_cast<std::size_t>(x / (wavelength / 2));
  const double gain = lobe < gains.size() ? gains[lobe] : 1;
  return gain * 100 * std::exp(-x / decay) * std::sin(2 * std::numbers::pi * x / wavelength);
}

constexpr double passSpeed = 30;  // [m/s]

// Rolled at 25 kHz from 0.1 m ahead of the defect to 0.3 m behind it; the wheel feels it from `begin` on.
signals::Record rolled(double begin, const std::vector<double>& gains) {
  signals::Record run;
  run.speed = passSpeed;
  signals::Channel channel{"aba_filtered", "m/s2", "", {}};
  for (int i = 0; i <= 333; ++i) {
    run.time.push_back(i / 25000.0);
    run.position.push_back(-0.1 + passSpeed * run.time.back());
    channel.values.push_back(ringing(run.position.back() - begin, gains));
  }
  run.signals = {channel};
  return run;
}

// Measured at 20 kHz for 0.2 s; the wheel feels the defect from 0.1 s on.
std::string passed(const Folder& folder, const std::function<double(double)>& value) {
  std::string text = "time [s],aba [m/s2]\n";
  for (int i = 0; i < 4000; ++i)
    text += std::to_string(i / 20000.0) + "," + std::to_string(value(passSpeed * (i / 20000.0 - 0.1))) + "\n";
  folder.write("passed.csv", text);
  return folder.path("passed.csv");
}

// The run is largest in its second lobe, downwards, the measured signal in its first, upwards: 22 mm apart. Laid beside
// the run they coincide within half a millimetre, a third of the way between two samples; the lobes that differ pull
// them apart by less.
TEST(MeasuredRecords, BesideARunASignalLiesWhereTheWholeOfItMatches) {
  const Folder folder;
  const auto run = rolled(0.02, {1, 1.8});
  const auto path = passed(folder, [](double x) { return ringing(x, {1.1}); });
  const auto measured = measuredRecords(path, passSpeed, {}, &run).at(0);
  // The first lobe is highest where tan(k x) = k decay.
  const double k = 2 * std::numbers::pi / 0.045, top = 0.02 + std::atan(0.06 * k) / k;
  EXPECT_NEAR(measured.reading.impact, top, 0.5e-3);
  EXPECT_GT(std::abs(impactOf(&run) - top), 0.02) << "where the largest values would meet";
  const auto match = matchBeside(run, *measured.record);
  EXPECT_NEAR(match.impact, measured.reading.impact, 0.1e-3);
  EXPECT_GT(match.correlation.value_or(0), 0.9);
  EXPECT_THAT(measured.record->notes.back(), testing::HasSubstr("cross-correlation"));
  // Read again for a project, it lies there to the last digit.
  EXPECT_EQ(realigned(measured, measured.reading).record->position, measured.record->position);
}

// White noise has no place beside the run of a squat: the largest values meet, and the note says so.
TEST(MeasuredRecords, ASignalUnlikeTheRunIsLaidByItsLargestValue) {
  const Folder folder;
  const auto run = rolled(0.02, {});
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  const auto path = passed(folder, [&](double) { return noise(random); });
  const auto measured = measuredRecords(path, passSpeed, {}, &run).at(0);
  EXPECT_EQ(measured.reading.impact, impactOf(&run));
  EXPECT_THAT(measured.record->notes.front(), testing::HasSubstr("unlike the run"));
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
