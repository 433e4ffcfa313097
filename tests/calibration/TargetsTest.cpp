#include "calibration/Targets.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::calibration {
namespace {

using ::testing::HasSubstr;

class TargetFiles : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    auto path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  Targets read(const std::string& body) const {
    return readTargets({write("t.json", R"({"schema": "squat-targets", "schema_version": 1, )" + body + "}")},
                       "light-defect");
  }
  std::string refusalOf(const std::string& body) const {
    try {
      read(body);
    } catch (const FileError& error) {
      return error.what();
    }
    return "taken";
  }
  squat::tests::TemporaryFolder folder_;
};

TEST_F(TargetFiles, StatementsOfTheCaseItself) {
  const auto targets = read(R"("statements": [{"statement": "peak", "measure": "maximum", "expected": 100,
                               "tolerance": 0.2, "unit": "m/s2", "weight": 3}])");
  ASSERT_EQ(targets.statements.size(), 1u);
  EXPECT_EQ(targets.statements[0].weight, 3);
  EXPECT_NEAR(targets.statements[0].statement.low, 80, 1e-9);
  EXPECT_EQ(targets.statements[0].statement.run, targets.runs.back().name);
  EXPECT_EQ(targets.runs.back().caseName, "light-defect");
  EXPECT_EQ(targets.names(), std::vector<std::string>{"peak"});
}

// Section 3 of paper.json about the run at 30 m/s alone: 10 statements (counted by hand in the file), none of 40 m/s.
TEST_F(TargetFiles, SectionThreeOfThePaper) {
  const auto targets = read(R"("paper": [{"run": "light-defect", "sections": ["3"]}])");
  EXPECT_EQ(targets.statements.size(), 10u);
  for (const auto& target : targets.statements) {
    EXPECT_EQ(target.statement.run, "light-defect");
    EXPECT_EQ(target.statement.section[0], '3');
  }
}

TEST_F(TargetFiles, ReceptanceAndSignalsAreFoundBesideTheFile) {
  write("h.csv", "frequency [Hz],magnitude [m/N]\n100,1e-8\n200,1e-8\n300,1e-8\n");
  write("a.csv", "time [s],aba [m/s2]\n0,1\n0.001,2\n");
  const auto targets =
      read(R"("receptance": [{"file": "h.csv", "point": "midspan"}], "signals": [{"files": ["a.csv"]}])");
  EXPECT_EQ(targets.receptances.at(0).point, "midspan");
  EXPECT_EQ(targets.signals.at(0).files.size(), 1u);
}

TEST_F(TargetFiles, TablesAreTargetsByThemselves) {
  const auto receptance = write("h.csv", "frequency [Hz],magnitude [m/N]\n100,1e-8\n200,1e-8\n300,1e-8\n");
  const auto one = write("a.csv", "time [s],aba [m/s2]\n0,1\n0.001,2\n0.002,1\n");
  const auto two = write("b.csv", "time [s],aba [m/s2]\n0,1\n0.001,2\n0.002,1\n");
  const auto targets = readTargets({receptance, one, two}, "light-defect");
  EXPECT_EQ(targets.receptances.size(), 1u);
  ASSERT_EQ(targets.signals.size(), 1u);  // repeated runs over one defect
  EXPECT_EQ(targets.signals[0].files.size(), 2u);
}

TEST_F(TargetFiles, EmptyIsSaid) {
  EXPECT_THAT(refusalOf(R"("statements": [])"), HasSubstr("holds no target"));
  EXPECT_THAT(refusalOf(R"("signals": [{"files": []}])"), HasSubstr("signals 1"));
}

TEST_F(TargetFiles, AWrongUnitIsSaidWithTheRightOne) {
  const auto text = refusalOf(R"("statements": [{"statement": "short waves", "measure": "wavelength", "low": 0.02,
                                 "high": 0.04, "unit": "m"}])");
  EXPECT_THAT(text, HasSubstr("short waves"));
  EXPECT_THAT(text, HasSubstr("must be 'mm'"));
}

TEST_F(TargetFiles, ContradictionsNameBothStatements) {
  const auto text = refusalOf(R"("statements": [
      {"statement": "small peak", "measure": "maximum", "low": 10, "high": 20, "unit": "m/s2"},
      {"statement": "large peak", "measure": "maximum", "low": 90, "high": 110, "unit": "m/s2"}])");
  EXPECT_THAT(text, HasSubstr("small peak"));
  EXPECT_THAT(text, HasSubstr("large peak"));
  EXPECT_THAT(text, HasSubstr("contradict"));
}

TEST_F(TargetFiles, OtherMistakesNameTheEntry) {
  EXPECT_THAT(refusalOf(R"("statements": [{"statement": "x", "measure": "loudness", "low": 1, "unit": "1"}])"),
              HasSubstr("loudness"));
  EXPECT_THAT(refusalOf(R"("statements": [{"statement": "x", "measure": "maximum", "low": 1, "unit": "m/s2",
                           "weight": -1}])"),
              HasSubstr("weight"));
  EXPECT_THAT(refusalOf(R"("runs": [{"name": "fast", "set": ["motion.speed=35"]},
                                    {"name": "fast", "set": ["motion.speed=40"]}],
                           "statements": [{"statement": "x", "run": "fast", "measure": "maximum", "low": 1,
                                           "unit": "m/s2"}])"),
              HasSubstr("run 'fast': is given twice"));
  EXPECT_THAT(refusalOf(R"("receptance": [{"file": "nowhere.csv"}])"), HasSubstr("'nowhere.csv' is missing"));
  EXPECT_THAT(refusalOf(R"("paper": [{"run": "heavy-defect"}])"), HasSubstr("heavy-defect"));
  write("a.csv", "time [s],aba [m/s2]\n0,1\n0.001,2\n");
  EXPECT_THAT(refusalOf(R"("signals": [{"files": ["a.csv"], "run": "other"}])"), HasSubstr("run 'other'"));
  EXPECT_THAT(refusalOf(R"("statements": [{"statement": )"), HasSubstr("t.json"));
}

}  // namespace
}  // namespace squat::calibration
