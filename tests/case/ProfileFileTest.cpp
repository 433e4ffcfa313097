// Profiles as CSV, in every dialect that is taken and with every mistake that is refused.
#include "case/ProfileFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/Errors.h"

namespace squat::cases {
namespace {

using testing::AllOf;
using testing::HasSubstr;

void expectDip(const std::string& text) {
  try {
    const auto points = parseProfile(text, "p.csv");
    ASSERT_EQ(points.size(), 3u) << text;
    EXPECT_EQ(points[0].position, -0.0055) << text;
    EXPECT_EQ(points[1].position, 0) << text;
    EXPECT_EQ(points[1].height, -0.00015) << text;
    EXPECT_EQ(points[2].position, 0.005) << text;
    EXPECT_EQ(points[2].height, 0) << text;
  } catch (const FileError& error) {
    ADD_FAILURE() << error.what() << "\n" << text;
  }
}

std::string refusalOfProfile(const std::string& text) {
  try {
    parseProfile(text, "p.csv", Defect());
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "p.csv");
    return error.what();
  }
  ADD_FAILURE() << "taken: " << text;
  return {};
}

Defect filtered() {
  Defect defect;
  defect.filter = ProfileFilter::outliers;
  return defect;
}

TEST(ProfileFile, Delimiters) {
  expectDip("position [mm],height [mm]\n-5.5,0\n0,-0.15\n5,0\n");
  expectDip("position [mm];height [mm]\n-5.5;0\n0;-0.15\n5;0\n");
  expectDip("position [mm]\theight [mm]\n-5.5\t0\n0\t-0.15\n5\t0\n");
}

TEST(ProfileFile, DecimalComma) {
  expectDip("position [mm];height [mm]\n-5,5;0\n0;-0,15\n5;0\n");
  expectDip("position [mm]\theight [mm]\n-5,5\t0,0\n0,0\t-0,15\n5,0\t0,0\n");
}

TEST(ProfileFile, UnitsInBracketsParenthesesOrBehindACommaOrABlank) {
  expectDip("Position (m);Height (um)\n-0.0055;0\n0;-150\n0.005;0\n");
  expectDip("x, mm; z, \xC2\xB5m\n-5.5;0\n0;-150\n5;0\n");
  expectDip("x, mm; z, \xCE\xBCm\n-5.5;0\n0;-150\n5;0\n");
  expectDip("x mm;z \xB5m\n-5.5;0\n0;-150\n5;0\n");  // Latin-1
  expectDip("position, mm, height, mm\n-5.5,0\n0,-0.15\n5,0\n");
  expectDip("\"Position [MM]\";\"Height [ mm ]\"\n-5.5;0\n0;-0.15\n5;0\n");
}

// As devices and offices write tables: lines above the heading, a row of units below it, other delimiters, more
// columns.
TEST(ProfileFile, TablesOfAnyMake) {
  expectDip("Device;RM1200\nOperator: A. N.\n\nPosition;Height\nmm;um\n-5.5;0\n0;-150\n5;0\n");
  expectDip("Position;Tiefe\n[mm];[\xC2\xB5m]\n-5,5;0\n0;150\n5;0\n");
  expectDip("# position [mm]; height [mm]\n-5.5;0\n0;-0.15\n5;0\n");
  expectDip("position [mm];height [mm]\n# scanned;3 March\n-5.5;0\n0;-0.15\n5;0\n");
  expectDip("position_mm height_mm\n-5.5 0\n0 -0.15\n5 0\n");
  expectDip("position [mm] | height [mm]\n-5.5 | 0\n0 | -0.15\n5 | 0\n");
  expectDip("Nr;Stationierung [m];H\xC3\xB6he [mm];Bemerkung\n1;-0,0055;0;\n2;0;-0,15;Delle\n3;0,005;0;\n");
  expectDip("afstand [cm];diepte [mm]\n-0.55;0\n0;0.15\n0.5;0\n");
  expectDip("\"hauteur, mm\";\"abscisse, mm\"\n\"0\";\"-5,5\"\n\"-0,15\";\"0\"\n\"0\";\"5\"\n");
  expectDip("position [mm],height [um],lower [um],upper [um],felt\n-5.5,0,-1,1,1\n0,-150,-160,-140,1\n5,0,-1,1,0\n");
}

// The inch is 25.4 mm by definition (1959); chainages as kilometres and metres.
TEST(ProfileFile, OtherUnitsOfLength) {
  const auto inches = parseProfile("position [inch];height [in]\n0;0\n2;-0.01\n4;0\n", "p.csv");
  ASSERT_EQ(inches.size(), 3u);
  EXPECT_DOUBLE_EQ(inches[1].position, 0.0508);
  EXPECT_DOUBLE_EQ(inches[1].height, -0.000254);
  const auto chainage = parseProfile("km;height [mm]\n12+345.500;0\n12+345.505;-0.1\n12+345.510;0\n", "p.csv");
  ASSERT_EQ(chainage.size(), 3u);
  EXPECT_DOUBLE_EQ(chainage[1].position, 12345.505);
}

TEST(ProfileFile, HeightMayComeFirst) { expectDip("height [mm]; position [mm]\n0;-5.5\n-0.15;0\n0;5\n"); }

TEST(ProfileFile, MarksCommentsAndLineEnds) {
  expectDip("\xEF\xBB\xBFposition [mm];height [mm]\r\n-5.5;0\r\n0;-0.15\r\n5;0");
  expectDip("# device 7\n\n  # 3 March\nposition [mm] ; height [mm]\n -5.5 ; 0 \n\n0;-0.15\n# end\n5;0\n\n");
  expectDip("position [mm];height [mm]\n-5.5e0;+0.0\n0.0;-1.5E-1\n5;0\n");
}

TEST(ProfileFile, KeepsChainagesExact) {
  const auto points = parseProfile("s [m]; z [mm]\n123456.780; 0\n123456.785; -0.1\n", "p.csv");
  EXPECT_EQ(points[0].position, 123456.780);
  EXPECT_EQ(points[1].position, 123456.785);
}

TEST(ProfileFile, RefusesUnsortedAndDuplicatePositionsWithTheLine) {
  EXPECT_THAT(refusalOfProfile("# c\nx [mm];z [mm]\n0;0\n10;0\n5;0\n"), AllOf(HasSubstr("line 5"), HasSubstr("Sort")));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;0\n5.0;0\n"), AllOf(HasSubstr("line 4"), HasSubstr("twice")));
}

TEST(ProfileFile, RefusesWhatIsNoNumber) {
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;nan\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;inf\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;-\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;1e999\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n5;\n"), AllOf(HasSubstr("line 3"), HasSubstr("missing")));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n#N/A;1\n5;x\n"), HasSubstr("line 4"));
}

TEST(ProfileFile, RefusesMixedDecimalMarks) {
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0.5;0\n1,5;0\n"), AllOf(HasSubstr("line 3"), HasSubstr("mixed")));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n1.234,5;0\n"), HasSubstr("mixed"));
}

TEST(ProfileFile, RefusesWrongNumbersOfColumns) {
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0;0\n"), AllOf(HasSubstr("line 2"), HasSubstr("3 columns")));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0\n"), HasSubstr("1 column"));
  EXPECT_THAT(refusalOfProfile("x [mm];y [mm];z [mm]\n0;0;0\n"), AllOf(HasSubstr("line 1"), HasSubstr("3 columns")));
  EXPECT_THAT(refusalOfProfile("x [mm],z [mm]\n0,5,0,1\n"), HasSubstr("decimal comma"));
  EXPECT_THAT(refusalOfProfile("x z\n0 0\n"), HasSubstr("line 1"));
}

// A dip of 0.1 mm, whatever it is called and however its sign is meant there.
TEST(ProfileFile, DepthsArePositiveDownwards) {
  for (const char* name : {"depth", "dip", "Tiefe", "diepte", "profondeur"}) {
    const auto points = parseProfile("position [mm];" + std::string(name) + " [mm]\n0;0\n5;0.1\n10;-0.01\n", "dip.csv");
    ASSERT_EQ(points.size(), 3u);
    EXPECT_DOUBLE_EQ(points[1].height, -1e-4) << name;
    EXPECT_DOUBLE_EQ(points[2].height, 1e-5) << name;
  }
}

// "Profile" and "level" alone do not say which way is up; a depth of either is a depth.
TEST(ProfileFile, ADepthOfAProfileIsADepth) {
  for (const char* name : {"Profiltiefe", "profile depth", "depth below level", "profondeur du profil"})
    EXPECT_DOUBLE_EQ(parseProfile("x [mm];" + std::string(name) + " [mm]\n0;0\n5;0.1\n10;0\n", "dip.csv")[1].height,
                     -1e-4)
        << name;
  for (const char* name : {"profile", "height of the profile", "level", "hauteur du profil"})
    EXPECT_DOUBLE_EQ(parseProfile("x [mm];" + std::string(name) + " [mm]\n0;0\n5;-0.1\n10;0\n", "dip.csv")[1].height,
                     -1e-4)
        << name;
}

// Scans against the chainage, as loggers write them: depths, a row of units, kilometres and metres, dropouts.
TEST(ProfileFile, FallingPositionsOfOtherMakes) {
  for (const char* text : {"Linie 2\nStationierung;Tiefe\nm;mm\n1200,010;0\n1200,005;0,15\n1200,0;-0,02\n",
                           "pk\tprofondeur [um]\n1+200.010\t0\n1+200.005\t150\n1+200.000\t-20\n"}) {
    const auto points = parseProfile(text, "p.csv");
    ASSERT_EQ(points.size(), 3u) << text;
    EXPECT_DOUBLE_EQ(points[0].position, 1200) << text;
    EXPECT_DOUBLE_EQ(points[0].height, 2e-5) << text;
    EXPECT_DOUBLE_EQ(points[1].position, 1200.005) << text;
    EXPECT_DOUBLE_EQ(points[1].height, -1.5e-4) << text;
  }
  const auto points = parseProfile("x [mm] z [mm]\n10 0\n8 nan\n5 -0.1\n2 0\n0 0.02\n", "p.csv", filtered());
  ASSERT_EQ(points.size(), 4u);
  EXPECT_DOUBLE_EQ(points[2].position, 0.005);
}

TEST(ProfileFile, PositionsMayFall) {
  const auto points = parseProfile("position [mm];height [mm]\n10;0\n5;-0.1\n0;0.02\n", "dip.csv");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_DOUBLE_EQ(points[0].position, 0);
  EXPECT_DOUBLE_EQ(points[0].height, 2e-5);
  EXPECT_DOUBLE_EQ(points[1].height, -1e-4);
  EXPECT_DOUBLE_EQ(points[2].position, 0.01);
  EXPECT_THAT(refusalOfProfile("position [mm];height [mm]\n10;0\n5;0\n7;0\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("larger than the previous")));
}

TEST(ProfileFile, RefusesHeadersWithoutUnits) {
  EXPECT_THAT(refusalOfProfile("0;0\n5;0\n"), AllOf(HasSubstr("line 1"), HasSubstr("no header")));
  EXPECT_THAT(refusalOfProfile("position;height\n0;0\n"), HasSubstr("unit"));
  EXPECT_THAT(refusalOfProfile("position [mm];height [furlong]\n0;0\n"), HasSubstr("unit"));
  EXPECT_THAT(refusalOfProfile("position [mm;height [mm]\n0;0\n"), HasSubstr("unit"));
  EXPECT_THAT(refusalOfProfile("position [mm];depth [mm]\n0;0\n5;-0.1\n"), HasSubstr("positive upwards"));
  EXPECT_THAT(refusalOfProfile("position [mm];Tiefe [mm]\n0;-0.08\n5;0.1\n"), HasSubstr("both signs"));
}

TEST(ProfileFile, RefusesTooFewAndAbsurdPoints) {
  EXPECT_THAT(refusalOfProfile(""), HasSubstr("empty"));
  EXPECT_THAT(refusalOfProfile("# nothing\n"), HasSubstr("empty"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n"), HasSubstr("two points"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n"), HasSubstr("two points"));
  EXPECT_THAT(refusalOfProfile("x [mm];z [m]\n0;0\n5;-0.15\n"), AllOf(HasSubstr("line 3"), HasSubstr("unit")));
  EXPECT_THAT(refusalOfProfile("x [m];z [mm]\n0;0\n5000000;-0.15\n"), HasSubstr("line 3"));
}

TEST(ProfileFile, RefusesOtherEncodings) {
  EXPECT_THAT(refusalOfProfile(std::string("\xFF\xFEx\0;\0z\0", 8)), HasSubstr("UTF-16"));
  EXPECT_THAT(refusalOfProfile(std::string("\x89HDF\r\n\x1a\n\0\0", 10)), HasSubstr("not a text file"));
}

// Marks for no value as instruments write them: refused with the place, left out where a filter is asked for.
TEST(ProfileFile, DropoutsAreNamedOrLeftOut) {
  for (const char* mark : {"", "NaN", "n/a", "-", "-9999", "9999", "-999.25", "-99999"}) {
    const std::string text = "position [mm];height [um]\n-5.5;0.1\n-2;" + std::string(mark) + "\n0;-150\n5;0.2\n8;0\n";
    EXPECT_THAT(refusalOfProfile(text), AllOf(HasSubstr("line 3"), HasSubstr("defect.filter"))) << mark;
    const auto points = parseProfile(text, "p.csv", filtered());
    ASSERT_EQ(points.size(), 4u) << mark;
    EXPECT_EQ(points[1].position, 0) << mark;
    EXPECT_EQ(points[1].height, -0.00015) << mark;
  }
  EXPECT_THAT(refusalOfProfile("x [mm];z [mm]\n0;0\n1;-9999\n2;0\n3;0\n"), HasSubstr("stands for no value"));
  // Depths that only look like a mark: others are about as deep.
  EXPECT_EQ(parseProfile("x [mm];z [um]\n0;0\n1;-700\n2;-999\n3;-650\n4;0\n", "p.csv").size(), 5u);
  try {
    parseProfile("x [mm];z [mm]\n0;0\n1;\n2;\n3;0\n", "p.csv", filtered());
    ADD_FAILURE() << "taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 of 4 rows"));
  }
}

// 10 m at 0.1 mm with a dip at 7.3 m, on a slow wave: more rows than a case holds.
TEST(ProfileFile, LongScansNameTheStretchToTake) {
  std::string text = "chainage [m];height [mm]\n";
  for (int i = 0; i <= 100000; ++i) {
    const double x = i * 1e-4, s = (x - 7.3) / 0.05;
    const double height = std::sin(x) - (std::abs(s) < 0.5 ? 0.1 * (1 + std::cos(2 * std::numbers::pi * s)) : 0);
    char row[64];
    std::snprintf(row, sizeof row, "%.4f;%.6f\n", 100 + x, height);
    text += row;
  }
  EXPECT_THAT(refusalOfProfile(text), AllOf(HasSubstr("100001 rows"), HasSubstr("80000 points"), HasSubstr("at 107.3"),
                                            HasSubstr("defect.from = 107.05"), HasSubstr("defect.to = 107.5")));
  Defect asked;
  asked.from = 107.05, asked.to = 107.55;
  const auto points = parseProfile(text, "p.csv", asked);
  ASSERT_EQ(points.size(), 5001u);
  EXPECT_EQ(points.front().position, 107.05);
  asked.from = 200, asked.to = 201;
  EXPECT_THROW(parseProfile(text, "p.csv", asked), FileError);
}

// Heights of an irregularity and of a tread are read in the same way, and have none of its keys.
TEST(ProfileFile, AdviceNamesKeysOfADefectForADefectAlone) {
  std::string longScan = "position [mm];height [mm]\n";
  for (int i = 0; i <= 80000; ++i) longScan += std::to_string(i) + (i == 40000 ? ";-0.1\n" : ";0\n");
  for (const auto& text : {std::string("position [mm];height [mm]\n0;0\n1;\n2;0\n"),
                           std::string("position [mm];height [mm]\n0;0\n1;-0.1\n2;-9999\n3;0\n4;0.1\n"), longScan}) {
    EXPECT_THAT(refusalOfProfile(text), HasSubstr("defect."));
    try {
      parseProfile(text, "p.csv");
      ADD_FAILURE() << "taken: " << text.substr(0, 80);
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), Not(HasSubstr("defect")));
    }
  }
}

// Several profiles side by side: the headers name their lateral positions.
TEST(ProfileFile, LinesSideBySide) {
  for (const char* text : {"position [mm],y = -10 mm [mm],height at y=5.5 mm [um]\n-5.5,0,0\n0,-0.15,-200\n5,0,0\n",
                           "position [mm];y=-10 mm [mm];y = 5,5 mm [um]\n-5,5;0;0\n0;-0,15;-200\n5;0;0\n"}) {
    const auto lines = parseProfileLines(text, "p.csv");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].lateral, -0.010);
    EXPECT_EQ(lines[1].lateral, 0.0055);
    ASSERT_EQ(lines[1].points.size(), 3u);
    EXPECT_EQ(lines[0].points[1].height, -0.00015);
    EXPECT_EQ(lines[1].points[0].position, -0.0055);
    EXPECT_EQ(lines[1].points[1].height, -0.0002);
  }
  const auto one = parseProfileLines("position [mm],height [mm]\n0,0\n5,-0.1\n", "p.csv");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].lateral, 0);
}

TEST(ProfileFile, MistakesInLinesSideBySide) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      parseProfileLines(text, "p.csv");
    } catch (const FileError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_THAT(refused("position [mm],y=-10 mm [mm],height [mm]\n0,0,0\n1,0,0\n"), HasSubstr("two are expected"));
  EXPECT_THAT(refused("position [mm],y=10 mm [mm],y=-10 mm [mm]\n0,0,0\n1,0,0\n"), HasSubstr("must ascend"));
  EXPECT_THAT(refused("position [mm],y=0 mm [mm],y=90 mm [mm]\n0,0,0\n1,0,0\n"), HasSubstr("-36 to 36 mm"));
  EXPECT_THAT(refused("position [mm],y=0 mm [mm],y=9 mm [mm]\n0,0,0\n1,0\n"), HasSubstr("3 are expected"));
  EXPECT_THAT(refused("position [mm],y=0 mm [mm],y=9 mm [mm]\n0,0,0\n1,0,70\n"), HasSubstr("beyond 50 mm"));
  EXPECT_THAT(refusalOfProfile("position [mm],y=0 mm [mm],y=9 mm [mm]\n0,0,0\n1,0,0\n"), HasSubstr("side by side"));
}

}  // namespace
}  // namespace squat::cases
