// Case files: precedence, units, and one message for every kind of mistake.
#include "case/CaseFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::vector<CaseProblem> problemsOf(const std::string& text, const CaseOverrides& overrides = {}) {
  try {
    parseCase(text, "x.toml", {}, overrides);
  } catch (const CaseError& error) {
    return error.problems();
  }
  ADD_FAILURE() << "taken as right:\n" << text;
  return {};
}

std::string fileErrorOf(const std::string& text) {
  try {
    parseCase(text, "x.toml");
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "x.toml");
    return error.what();
  }
  ADD_FAILURE() << "taken as right:\n" << text;
  return {};
}

class CaseFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("case-" + std::to_string(::getpid()) + "-" +
                                              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  fs::path folder_;
};

TEST(CaseFile, EmptyFileIsTheDefaultCase) { EXPECT_EQ(writeCase(parseCase("", "x.toml")), writeCase(defaultCase())); }

TEST(CaseFile, ReadsEveryFormOfTable) {
  EXPECT_EQ(parseCase("[pad]\nstiffness = 550\n", "x").pad.stiffness, 550e6);
  EXPECT_EQ(parseCase("pad.stiffness = 5.5e2", "x").pad.stiffness, 550e6);
  EXPECT_EQ(parseCase("pad = { stiffness = 5_50 }", "x").pad.stiffness, 550e6);
  EXPECT_EQ(parseCase("[pad]\nstiffness = 0x226\n", "x").pad.stiffness, 550e6);
  EXPECT_EQ(parseCase("\xEF\xBB\xBF[pad]\r\nstiffness = 550\r\n", "x").pad.stiffness, 550e6);
}

// 0.1 mm is 1e-4 m to the last bit, not 0.1 * 1e-3.
TEST(CaseFile, AppliesUnitsToTheDigits) {
  EXPECT_EQ(parseCase("[defect]\ndepth = 0.1", "x").defect.depth, 1e-4);
  EXPECT_EQ(parseCase("title = 'µ'\n[defect]\ndepth = 0.1 # µ", "x").defect.depth, 1e-4);
  EXPECT_EQ(parseCase("defect = { \"depth\" = 0.12345678901234567, length = 50 }", "x").defect.depth,
            0.12345678901234567e-3);
}

TEST(CaseFile, ReadsPointsInMillimetres) {
  const auto defect =
      parseCase("[defect]\nshape = 'profile'\npoints = [[0, 0], [5, -0.1], [10.5, -0.05],\n [20, 0]]", "x").defect;
  ASSERT_EQ(defect.points.size(), 4u);
  EXPECT_EQ(defect.points[2].position, 0.0105);
  EXPECT_EQ(defect.points[1].height, -1e-4);
}

TEST(CaseFile, StatedKeysGoBeforePresets) {
  const auto c = parseCase("[mesh]\npreset = 'tiny'\ncontact_size = 4\n", "x");
  EXPECT_EQ(c.mesh.contactSize, 4e-3);
  EXPECT_EQ(c.track.length, 3);
  EXPECT_EQ(c.mesh.preset, MeshPreset::tiny);
}

TEST(CaseFile, PresetOfTheCommandLineGoesBeforeThatOfTheFile) {
  const CaseOverrides tiny{"tiny", {}};
  const auto c = parseCase("[mesh]\npreset = 'paper'\nfar_size = 40\n", "x", {}, tiny);
  EXPECT_EQ(c.mesh.preset, MeshPreset::tiny);
  EXPECT_EQ(c.mesh.contactSize, 5e-3);
  EXPECT_EQ(c.mesh.farSize, 40e-3);
}

TEST(CaseFile, PresetActsOnWrittenCasesToo) {
  CaseDescription description = defaultCase();
  applyPreset(description, MeshPreset::paper);
  setValue(description, "mesh.far_size", "37.5");
  const auto c = parseCase(writeCase(description), "x", {}, {"tiny", {}});
  EXPECT_EQ(c.mesh.contactSize, 5e-3);
  EXPECT_EQ(c.motion.runUp, 0.1);
  EXPECT_EQ(c.mesh.farSize, 37.5e-3) << "stated against its own preset";
}

TEST(CaseFile, SetGoesBeforeEverything) {
  const CaseOverrides overrides{"draft", {{"mesh.preset", "tiny"}, {"motion.speed", "20"}, {"mesh.contact_size", "3"}}};
  const auto c = parseCase("[motion]\nspeed = 40\n[mesh]\ncontact_size = 2", "x", {}, overrides);
  EXPECT_EQ(c.motion.speed, 20);
  EXPECT_EQ(c.mesh.contactSize, 3e-3);
  EXPECT_EQ(c.mesh.preset, MeshPreset::tiny);
  EXPECT_EQ(c.track.length, 3);
}

TEST(CaseFile, ReportsAllMistakesAtOnceWithTheirLines) {
  const auto problems = problemsOf(
      "[pad]\nstiffness = -1\nstifness = 3\n[rail]\nyield_stress = 'hard'\npoisson_ratio = nan\n[motion]\nspeed = inf\n"
      "torque = true\n[defect]\nshape = 'round'\nfile = 3\n[wheel]\nradius = 0.46\n");
  std::vector<std::string> keys;
  for (const auto& problem : problems) {
    keys.push_back(problem.key);
    EXPECT_FALSE(problem.advice.empty()) << problem.key;
    if (problem.advice.starts_with("unknown key")) continue;  // of which nothing is allowed
    EXPECT_FALSE(problem.value.empty()) << problem.key;
    EXPECT_FALSE(problem.allowed.empty()) << problem.key;
  }
  EXPECT_THAT(keys,
              testing::ElementsAre("pad.stiffness (line 2)", "pad.stifness (line 3)", "rail.yield_stress (line 5)",
                                   "rail.poisson_ratio (line 6)", "motion.speed (line 8)", "motion.torque (line 9)",
                                   "defect.shape (line 11)", "defect.file (line 12)", "wheel.radius (line 14)"));
}

TEST(CaseFile, JudgesRelationsBesideOtherMistakes) {
  const auto problems = problemsOf("[pad]\nstiffness = -1\n[rail]\ntangent_modulus = 300\n");
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[1].key, "rail.tangent_modulus (line 4)");
}

TEST(CaseFile, DoesNotJudgeRelationsOfWrongValues) {
  EXPECT_EQ(problemsOf("[rail]\nyoung_modulus = -5\ntangent_modulus = 300\n").size(), 1u);
}

TEST(CaseFile, UnknownKeysNameTheNearest) {
  EXPECT_THAT(problemsOf("[pad]\nstifness = 1")[0].advice, HasSubstr("pad.stiffness"));
  EXPECT_THAT(problemsOf("speed = 30")[0].advice, HasSubstr("motion.speed"));
  EXPECT_THAT(problemsOf("[pda]\nstiffness = 30")[0].advice, HasSubstr("pad.stiffness"));
  EXPECT_EQ(problemsOf("[nothing]").size(), 1u);
  EXPECT_EQ(problemsOf("[[pad]]\nstiffness = 1").size(), 1u);
  EXPECT_EQ(problemsOf("pad = 3").size(), 1u);
  EXPECT_EQ(problemsOf("[pad.stiffness]\nvalue = 3").size(), 1u);
}

TEST(CaseFile, RefusesWrongTypes) {
  EXPECT_EQ(problemsOf("[pad]\nstiffness = '1300'")[0].value, "a string");
  EXPECT_EQ(problemsOf("[pad]\nstiffness = [1300]")[0].value, "an array");
  EXPECT_EQ(problemsOf("[pad]\nstiffness = 1979-05-27")[0].value, "a date or time");
  EXPECT_EQ(problemsOf("[rail]\nplastic = 1")[0].value, "a number");
  EXPECT_EQ(problemsOf("title = 3")[0].value, "a number");
  EXPECT_EQ(problemsOf("[defect]\npoints = [[0, 'a']]").size(), 1u);
  EXPECT_EQ(problemsOf("[defect]\npoints = [[0, 0, 0]]").size(), 1u);
  EXPECT_EQ(problemsOf("[defect]\npoints = [[0, 0], [0, nan]]").size(), 1u);
  EXPECT_EQ(problemsOf("[mesh]\nwheel_sectors = 64.5").size(), 1u);
  EXPECT_EQ(problemsOf("[mesh]\nwheel_sectors = 9223372036854775807").size(), 1u);
}

TEST(CaseFile, RefusesWrongOverrides) {
  const auto problems =
      problemsOf("", {"fine", {{"motion.speed", "30 mph"}, {"motion.sped", "30"}, {"mesh.preset2", "x"}}});
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].key, "--mesh");
  EXPECT_THAT(problems[0].allowed, HasSubstr("tiny, draft, standard, paper"));
  EXPECT_EQ(problems[1].key, "motion.speed (--set)");
  EXPECT_THAT(problems[2].advice, HasSubstr("motion.speed"));
  EXPECT_EQ(problemsOf("", {"", {{"mesh.preset", "fine"}}}).size(), 1u);
}

TEST(CaseFile, BrokenTomlNamesTheLine) {
  EXPECT_THAT(fileErrorOf("[pad]\nstiffness = = 3\n"), HasSubstr("line 2"));
  EXPECT_THAT(fileErrorOf("[pad]\nstiffness = 1\nstiffness = 2\n"), HasSubstr("line 3"));
  EXPECT_THAT(fileErrorOf("[pad\n"), HasSubstr("line 1"));
  EXPECT_THAT(fileErrorOf("title = \"\xff\xfe\""), HasSubstr("line 1"));
  EXPECT_THAT(fileErrorOf("stiffness = 1,5"), HasSubstr("line 1"));
}

TEST(CaseFile, RefusesNewerSchemasWithAdvice) {
  EXPECT_THAT(fileErrorOf("\nschema = 99"), AllOf(HasSubstr("line 2"), HasSubstr("newer version")));
  EXPECT_EQ(problemsOf("schema = 'one'").size(), 1u);
  EXPECT_EQ(problemsOf("schema = 0").size(), 1u);
  EXPECT_EQ(writeCase(parseCase("schema = 1", "x")), writeCase(defaultCase()));
}

TEST_F(CaseFolder, FindsProfilesBesideTheCase) {
  write("data/dip.csv", "x [mm]; z [mm]\n0; 0\n5; -0.1\n10; 0\n");
  const auto path = write("cases/one.toml", "[defect]\nshape = 'profile'\nfile = '../data/dip.csv'\n");
  const auto c = readCase(path);
  EXPECT_EQ(c.defect.points.size(), 3u);
  EXPECT_EQ(c.defect.file, "../data/dip.csv");
  // A written case holds the points and reads back without the file.
  fs::remove(folder_ / "data" / "dip.csv");
  EXPECT_EQ(caseHash(parseCase(writeCase(c), "x", folder_ / "elsewhere")), caseHash(c));
}

TEST_F(CaseFolder, ProfileOfTheCommandLineReplacesPoints) {
  const auto profile = write("other.csv", "x [mm]; z [mm]\n0; 0\n5; -0.2\n10; -0.1\n15; 0\n");
  const auto path = write("one.toml", "[defect]\nshape = 'profile'\npoints = [[0, 0], [5, -0.1], [10, 0]]\n");
  EXPECT_EQ(readCase(path, {"", {{"defect.file", profile.string()}}}).defect.points.size(), 4u);
}

TEST_F(CaseFolder, MissingFilesAreFileErrors) {
  EXPECT_THROW(readCase(folder_ / "none.toml"), FileError);
  EXPECT_THROW(readCase(folder_), FileError);
  EXPECT_THROW(loadCase("no-such-case"), FileError);
  const auto path = write("one.toml", "[defect]\nshape = 'profile'\nfile = 'none.csv'\n");
  try {
    readCase(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), (folder_ / "none.csv").string());
  }
}

// Who names a profile wants to roll over it; only who chooses another shape in the same place has one that rests.
TEST_F(CaseFolder, AProfileIsNeverIgnoredInSilence) {
  const std::string points = "[[0, 0], [10, -0.2], [20, 0]]";
  for (const std::string& text : {std::string("file = 'none.csv'\n"), "points = " + points + "\n"})
    EXPECT_THAT(problemsOf("[defect]\n" + text),
                testing::ElementsAre(testing::Field(&CaseProblem::key, "defect.shape (line 2)")))
        << text;
  const CaseOverrides file{"", {{"defect.file", "none.csv"}}};
  EXPECT_THAT(problemsOf("[defect]\nshape = 'cosine'", file),
              testing::ElementsAre(testing::Field(&CaseProblem::key, "defect.shape (--set)")));
  EXPECT_THAT(problemsOf("", {"", {{"defect.points", points}}}), testing::SizeIs(1));

  const auto other = parseCase("[defect]\nshape = 'cosine'\nfile = 'none.csv'\npoints = " + points, "x");
  EXPECT_EQ(writeCase(parseCase(writeCase(other), "y")), writeCase(other));
  EXPECT_EQ(parseCaseOfResult(writeCase(other), "result").defect.points.size(), 3u);
  const CaseOverrides smooth{"", {{"defect.shape", "none"}}};
  EXPECT_NO_THROW(parseCase("[defect]\nshape = 'profile'\npoints = " + points, "x", {}, smooth));
  EXPECT_EQ(parseUnfinishedCase("[defect]\nfile = 'none.csv'", "x").defect.file, "none.csv");
}

TEST_F(CaseFolder, MistakesOfTheCaseComeBeforeThoseOfItsProfile) {
  const auto path = write("one.toml", "[defect]\nshape = 'profile'\nfile = 'none.csv'\n[pad]\nstiffness = -1\n");
  EXPECT_THROW(readCase(path), CaseError);
}

TEST_F(CaseFolder, SavesWholeFilesOnly) {
  const fs::path path = folder_ / "saved.toml";
  saveCase(defaultCase(), path);
  EXPECT_EQ(writeCase(readCase(path)), writeCase(defaultCase()));
  CaseDescription broken = defaultCase();
  broken.motion.speed = -1;
  EXPECT_THROW(saveCase(broken, path), CaseError);
  EXPECT_EQ(writeCase(readCase(path)), writeCase(defaultCase())) << "the earlier file must stay";
  EXPECT_THROW(saveCase(defaultCase(), folder_ / "nowhere" / "saved.toml"), FileError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "nothing may be left beside";
}

TEST(CaseFile, StemIsTheNameWithoutEnding) {
  EXPECT_EQ(caseStem("light-defect"), "light-defect");
  EXPECT_EQ(caseStem("/some/where/my case.toml"), "my case");
  EXPECT_EQ(caseStem("squat.v2.toml"), "squat.v2");
}

// A file with several columns of heights becomes lines; they are written with the case and read back as they are.
TEST_F(CaseFolder, ProfilesSideBySide) {
  write("p.csv", "position [mm],y=-8 mm [mm],y=8 mm [mm]\n-10,0,0\n0,-0.1,-0.2\n10,0,0\n");
  const auto path = write("c.toml", "[defect]\nshape = \"profile\"\nfile = \"p.csv\"\n");
  const auto read = readCase(path);
  ASSERT_EQ(read.defect.lines.size(), 2u);
  EXPECT_TRUE(read.defect.points.empty());
  EXPECT_EQ(read.defect.lines[1].lateral, 0.008);
  EXPECT_EQ(read.defect.lines[1].points[1].height, -0.0002);
  const std::string text = writeCase(read);
  const auto again = parseCase(text, "again.toml", folder_ / "elsewhere");
  EXPECT_EQ(writeCase(again), text);
  EXPECT_EQ(caseHash(again), caseHash(read));
  ASSERT_EQ(again.defect.lines.size(), 2u);
  EXPECT_EQ(again.defect.lines[0].points[1].height, -0.0001);
}

// A result may be untrusted: the file that its case names is not opened, and the case lacks its profile.
TEST(CaseFile, TheCaseOfAResultOpensNoFile) {
  try {
    parseCaseOfResult("[defect]\nshape = \"profile\"\nfile = \"/etc/passwd\"\n", "result");
    FAIL() << "accepted";
  } catch (const CaseError& error) {
    EXPECT_EQ(std::string(error.what()).find("/etc/passwd"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace squat::cases
