#include "commands/PaperTable.h"

#include <gmock/gmock.h>

#include "app/MadeUpPaperRun.h"
#include "case/CaseFile.h"

namespace squat::commands {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const char* const kVibration = "residual vibration before the defect (0.20 m)";
const char* const kPeak = "axle box acceleration, maximum / minimum";

results::RunResult made(double firstLine, double secondLine) {
  return tests::madeUpPaperRun("light-defect", {{45, firstLine}, {35, secondLine}});
}

PaperRow row(const results::RunResult& result, const std::string& what) {
  for (const auto& candidate : paperRows(result))
    if (candidate.what == what) return candidate;
  return {};
}

// The rail is no longer smooth where a long defect begins: what the wheel feels there is not noise of the start.
TEST(PaperTable, ResidualVibrationIsJudgedWhereTheRailIsSmooth) {
  auto result = made(310, 1000);
  result.signals[0].values[166] = 50;  // at x = -0.1 m
  EXPECT_EQ(row(result, kVibration).verdict, "failed");
  result.profilePosition = {-0.3, -0.15, 0.15, 0.3}, result.profileHeight = {0, -1e-4, -1e-4, 0};
  EXPECT_EQ(row(result, "residual vibration before the defect (0.15 m)").verdict, "passed");
}

TEST(PaperTable, LinesWithinTheBandsAreMet) {
  const auto result = tests::madeUpPaperRun("light-defect", {{45, 306}, {30, 620}, {35, 1005}});
  EXPECT_EQ(row(result, "line at 300 Hz").verdict, "met");
  EXPECT_NEAR(std::stod(row(result, "line at 300 Hz").ours), 306, 6);  // steps of 3 Hz, flanks of the other lines
  EXPECT_EQ(row(result, "line at 300 Hz").paper, "250 to 400 Hz");
  EXPECT_EQ(row(result, "line at 500 or 700 Hz").verdict, "met");
  EXPECT_EQ(row(result, "line at 1000 Hz").verdict, "met");
  EXPECT_THAT(paperTable(result), Not(HasSubstr("Natural modes")));
  // 0.38 m at 30 m/s are 12.7 ms: Hann tells lines apart that are 2/T = 158 Hz from each other.
  EXPECT_THAT(row(result, "strongest lines of the PSD").paper, HasSubstr("resolution 158 Hz"));
}

TEST(PaperTable, ALineOutsideIsNotMetAndTheModesStandBesideIt) {
  const auto result = made(450, 1005);
  EXPECT_EQ(row(result, "line at 300 Hz").verdict, "not met");
  EXPECT_THAT(paperTable(result), HasSubstr("Natural modes"));
  EXPECT_THAT(paperTable(result), HasSubstr("345"));
}

// A dip of one's own whose file is called like the paper's case: its lines are nobody's statement.
TEST(PaperTable, ACaseOfOnesOwnIsNotJudgedByItsName) {
  auto result = made(310, 1000);
  result.stem = "light-defect-assen";
  results::setCase(result, cases::parseCase("[defect]\nshape = \"profile\"\npoints = [[0, 0], [20, -0.2], [40, 0]]\n",
                                            "dip", {}, {"tiny", {}}));
  EXPECT_THAT(row(result, "line at 1000 Hz").what, IsEmpty());
  EXPECT_THAT(row(result, "peak, measured in the paper").what, IsEmpty());
}

TEST(PaperTable, ThePapersCaseIsJudgedUnderAnyName) {
  auto result = made(310, 1000);
  result.stem = "assen";
  EXPECT_EQ(row(result, "line at 1000 Hz").verdict, "met");
  // The distance rolled beyond the defect and the mesh change nothing that the paper states.
  results::setCase(result, cases::loadCase("light-defect", {"draft", {{"motion.beyond", "0.6"}}}));
  EXPECT_EQ(row(result, "line at 1000 Hz").verdict, "met");
}

TEST(PaperTable, AChangedKeyIsNotJudgedAndSaysWhy) {
  auto result = made(310, 1000);
  results::setCase(result, cases::loadCase("light-defect", {"tiny", {{"motion.speed", "25"}}}));
  EXPECT_THAT(row(result, "line at 1000 Hz").what, IsEmpty());
  EXPECT_THAT(row(result, "peak, measured in the paper").what, IsEmpty());
  EXPECT_EQ(row(result, "differs from light-defect").ours, "motion.speed = 25 m/s");
  EXPECT_EQ(row(result, "differs from light-defect").paper, "paper's case: 30 m/s");
  EXPECT_EQ(row(result, "differs from light-defect").verdict, "not judged");
}

// What the user has just set is looked for first; keys of the right side are named as they are set.
TEST(PaperTable, OfManyChangedKeysThoseSetByHandComeFirst) {
  auto result = made(310, 1000);
  const cases::CaseOverrides overrides{"tiny",
                                       {{"model.extent", "whole"},
                                        {"motion.speed", "25"},
                                        {"pad.stiffness", "800"},
                                        {"ballast.stiffness", "30"},
                                        {"right.pad.stiffness", "900"},
                                        {"right.defect.shape", "none"}}};
  results::setCase(result, cases::loadCase("light-defect", overrides));
  const auto changed = [&](const std::vector<std::string>& setByHand) {
    std::vector<std::string> found;
    for (const auto& each : paperRows(result, setByHand))
      if (each.what == "differs from light-defect") found.push_back(each.ours);
    return found;
  };
  const auto all = changed({});
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[3], "and 3 more keys");
  const auto byHand = changed({"right.defect.shape", "ballast.stiffness", "right.pad.stiffness"});
  EXPECT_THAT(byHand, ::testing::ElementsAre("ballast.stiffness = 30 MN/m", "right.defect.shape = none",
                                             "right.pad.stiffness = 900 MN/m", "and 3 more keys"));
  EXPECT_THAT(paperTable(result, {"right.pad.stiffness"}), HasSubstr("right.pad.stiffness = 900 MN/m"));
}

// The same on both rails, as the paper has it, though it is stated; without effect in a half model.
TEST(PaperTable, TheRightSideCountsWhereItDiffers) {
  auto result = made(310, 1000);
  results::setCase(result,
                   cases::loadCase("light-defect", {"tiny", {{"motion.speed", "25"}, {"right.pad.stiffness", "900"}}}));
  EXPECT_THAT(paperTable(result), Not(HasSubstr("right.pad")));
  results::setCase(result, cases::loadCase("light-defect",
                                           {"tiny", {{"model.extent", "whole"}, {"right.contact.friction", "0.6"}}}));
  EXPECT_THAT(paperTable(result), HasSubstr("model.extent = whole"));
  EXPECT_THAT(paperTable(result), HasSubstr("right.contact.friction = 0.6"));
}

TEST(PaperTable, PeakWavelengthEnergyAndHertz) {
  const auto result = made(306, 1005);
  EXPECT_EQ(row(result, kPeak).ours.substr(0, 2), "80");
  EXPECT_EQ(row(result, "peak, measured in the paper").paper, "72 to 128 m/s²");  // 100 and 28 %
  // The wave has 1000 Hz: 30 mm at 30 m/s; the decaying tone's ridge wanders by a few per cent.
  EXPECT_NEAR(std::stod(row(result, "mean wavelength after the impact").ours), 30, 1.5);
  EXPECT_EQ(row(result, "wavelength").ours, row(result, "mean wavelength after the impact").ours);
  EXPECT_EQ(row(result, "energy balance error, maximum").ours, "0.05 %");
  EXPECT_EQ(row(result, "energy balance error, maximum").verdict, "passed");
  EXPECT_EQ(row(result, "contact patch, semi-axis along the rail").verdict, "+2.9 %");  // 7.0 against 6.8 mm
  EXPECT_EQ(row(result, kVibration).verdict, "passed");
}

// Of whole models and bogies; the table of a single wheel has no such row.
TEST(PaperTable, EachOfSeveralWheelsHasItsSmallestForce) {
  auto result = made(310, 1000);
  const auto force = [&](const char* name, double inTheMiddle) {
    results::Channel channel{name, "N", "", std::vector<double>(1000, 8.5e4)};
    for (int i = 300; i < 310; ++i) channel.values[static_cast<std::size_t>(i)] = inTheMiddle;
    result.signals.push_back(channel);
  };
  force("contact_force", 2.5e4);
  EXPECT_THAT(paperTable(result), Not(HasSubstr("contact force of the")));
  force("second_contact_force", 6e4);
  EXPECT_EQ(row(result, "contact force of the wheel, minimum").ours, "25 kN");
  EXPECT_EQ(row(result, "contact force of the wheel of the second wheelset, minimum").ours, "60 kN");
  force("contact_force_right", 0);
  EXPECT_EQ(row(result, "contact force of the left wheel, minimum").ours, "25 kN");
  EXPECT_THAT(row(result, "contact force of the left wheel, minimum").paper, IsEmpty());
  // 300 samples of 25 kHz; ten of them.
  EXPECT_EQ(row(result, "contact force of the right wheel, minimum").ours,
            "0 kN, lifts off at 12 ms, in the air for 0.4 ms");
}

TEST(PaperTable, AStoppedRunIsNotJudged) {
  auto result = made(310, 1000);
  result.complete = false;
  EXPECT_THAT(row(result, "line at 1000 Hz").what, IsEmpty());
  EXPECT_THAT(row(result, kPeak).ours, Not(IsEmpty()));
}

TEST(PaperTable, PhasesAreListedWithTheirTime) {
  results::RunResult result;
  result.performance = {{"steps", "1", "", 8000}, {"seconds_mesh", "s", "", 0.5}, {"seconds_rolling", "s", "", 12}};
  EXPECT_THAT(phasesTable(result), HasSubstr("mesh     0.5\nrolling  12"));
  EXPECT_THAT(phasesTable(result), Not(HasSubstr("steps")));
}

TEST(PaperTable, AnEmptyResultGivesATableAllTheSame) {
  EXPECT_THAT(paperTable(results::RunResult{}), HasSubstr("not available"));
}

}  // namespace
}  // namespace squat::commands
