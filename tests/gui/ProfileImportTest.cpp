// Tables of many makes, read as profiles.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "studio/common/Theme.h"
#include "studio/profile/ImportDialog.h"
#include "studio/profile/ProfileImport.h"

namespace squat::studio {
namespace {

TEST(ProfileImport, semicolonsDecimalCommasAndUnitsAreFound) {
  const std::string text = "Position [mm];Hoogte [um]\n0;0\n5;-10,5\n10;0\n";
  const ImportChoices choices = suggestedChoices(text);
  EXPECT_EQ(choices.delimiter, ';');
  EXPECT_TRUE(choices.decimalComma);
  EXPECT_DOUBLE_EQ(choices.positionUnit, 1e-3);
  EXPECT_DOUBLE_EQ(choices.heightUnit, 1e-6);
  const ImportedProfile profile = importProfile(text, choices);
  ASSERT_TRUE(profile.problem.empty()) << profile.problem;
  ASSERT_EQ(profile.points.size(), 3u);
  EXPECT_NEAR(profile.points[1].height, -10.5e-6, 1e-15);
}

// Each pair: a heading and the metres of its unit.
TEST(ProfileImport, unitsAreWordsNotLetters) {
  const std::pair<const char*, double> headings[] = {{"Column 2 [mm]", 1e-3},  {"maximum depth (mm)", 1e-3},
                                                     {"z_um", 1e-6},           {"height [\xc2\xb5m]", 1e-6},
                                                     {"Datum level [m]", 1.0}, {"number", 1e-3}};
  for (const auto& [heading, metres] : headings)
    EXPECT_DOUBLE_EQ(suggestedChoices(std::string("x [mm];") + heading + "\n0;0\n5;1\n").heightUnit, metres) << heading;
}

// Instruments write remarks above the heading, or make the heading a remark.
TEST(ProfileImport, unitsAreThoseOfTheHeadingBelowRemarks) {
  for (const char* head : {"# laser 3, Tuesday\n# line 17\nx [m];z [um]\n", "# line 17\n# x [m];z [um]\n"}) {
    const ImportChoices choices = suggestedChoices(std::string(head) + "0;0\n0.5;-20\n1;0\n");
    EXPECT_DOUBLE_EQ(choices.positionUnit, 1) << head;
    EXPECT_DOUBLE_EQ(choices.heightUnit, 1e-6) << head;
  }
}

TEST(ProfileImport, otherColumnsNeedNoNumbers) {
  const std::string text = "x [mm];z [mm];remark\n0;0;good\n5;-0,1;a dip, I think\n10;0;\n";
  const ImportChoices choices = suggestedChoices(text);
  EXPECT_TRUE(choices.decimalComma);
  const ImportedProfile profile = importProfile(text, choices);
  ASSERT_TRUE(profile.problem.empty()) << profile.problem;
  EXPECT_EQ(profile.skippedLines, 1);
  ASSERT_EQ(profile.points.size(), 3u);
  EXPECT_NEAR(profile.points[1].height, -1e-4, 1e-15);
}

TEST(ProfileImport, levellingTakesTheLineOff) {
  ImportChoices choices;
  choices.levelling = Levelling::throughEnds;
  const ImportedProfile profile = importProfile("0,1\n10,2\n20,3\n30,4\n", choices);
  for (const auto& point : profile.points) EXPECT_NEAR(point.height, 0, 1e-15);
}

TEST(ProfileImport, resamplingIsLinear) {
  ImportChoices choices;
  choices.levelling = Levelling::none;
  choices.resampleStep = 2.5e-3;
  const ImportedProfile profile = importProfile("0,0\n10,-1\n20,0\n", choices);
  ASSERT_EQ(profile.points.size(), 9u);
  EXPECT_NEAR(profile.points[1].height, -0.25e-3, 1e-12);
  EXPECT_NEAR(profile.points[4].height, -1e-3, 1e-12);
}

TEST(ProfileImport, flippedReversedAndScaled) {
  ImportChoices choices;
  choices.levelling = Levelling::none;
  choices.flip = choices.reverse = true;
  choices.heightScale = 2;
  const ImportedProfile profile = importProfile("0,0\n10,1\n30,0\n", choices);
  ASSERT_EQ(profile.points.size(), 3u);
  EXPECT_NEAR(profile.points[0].position, -0.03, 1e-15);
  EXPECT_NEAR(profile.points[1].height, -2e-3, 1e-15);
}

// 10 um deep, half as deep: 5 um; points every 2.5 mm of 10 mm.
TEST(ProfileImport, theDialogTakesDecimalCommas) {
  QTemporaryDir folder;
  QFile file(folder.filePath("dip.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("x [mm];z [um]\n0;0\n5;-10\n10;0\n");
  file.close();
  ImportDialog dialog(file.fileName(), figureStyle(false));
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  for (const auto& [name, typed] : {std::pair{"importScale", "0,5"}, {"importStep", "2,5"}}) {
    auto* box = dialog.findChild<QDoubleSpinBox*>(name);
    ASSERT_NE(box, nullptr);
    box->selectAll();
    QTest::keyClicks(box, typed);
  }
  ASSERT_EQ(dialog.points().size(), 5u);
  EXPECT_NEAR(dialog.points()[2].height, -5e-6, 1e-15);
}

TEST(ProfileImport, mistakesNameTheirLine) {
  EXPECT_EQ(importProfile("0,0\n5,x\n10,0\n", {}).problem, "line 2: the chosen columns do not hold two numbers");
  EXPECT_FALSE(importProfile("0,0\n5,1\n5,2\n9,0\n", {}).problem.empty());
  EXPECT_FALSE(importProfile("", {}).problem.empty());
  EXPECT_FALSE(importProfile("0,0\n1,nan\n2,0\n", {}).problem.empty());
  EXPECT_FALSE(importProfile("0,0\n1,900\n2,0\n", {}).problem.empty());  // 900 mm high
}

}  // namespace
}  // namespace squat::studio
