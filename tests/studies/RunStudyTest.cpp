#include "studies/RunStudy.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/Errors.h"

namespace squat::studies {
namespace {

using ::testing::HasSubstr;

class Study : public testing::Test {
 protected:
  Study() { std::filesystem::create_directories(root_); }
  ~Study() override { std::filesystem::remove_all(root_); }
  std::string folder(const std::string& name) const { return (root_ / name).string(); }
  static std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::filesystem::path root_ =
      std::filesystem::temp_directory_path() / ("squat-study-" + std::to_string(::getpid()));
  const StudyDefinition definition_{
      "light-defect",
      "12345678",
      {variationFromText("defect.length=20:60:3"), variationFromText("defect.depth=0.1:0.3:3")}};
  Monitor monitor_;
};

// Features that depend on the point alone; the point 40, 0.2 fails.
std::optional<FeatureRow> pretend(const StudyPoint& point, Monitor&) {
  if (point.values == std::vector<std::string>{"40", "0.2"})
    throw RunError("contact lost, \"for good\"", 7, 0.01, "element 3");
  const double length = std::stod(point.values[0]), depth = std::stod(point.values[1]);
  return FeatureRow{{"peak [m/s2]", length * depth / 3}, {"wavelength, mean [m]", 1 / length}};
}

TEST_F(Study, oneTableWithTheFailedRunNamed) {
  const auto table = runStudy(definition_, pretend, {folder("a"), 1, false}, monitor_);
  EXPECT_EQ(table.count(RowState::done), 8u);
  EXPECT_EQ(table.count(RowState::failed), 1u);
  EXPECT_THAT(table.rows[4].message, HasSubstr("contact lost"));
  const std::string text = read(folder("a/study.csv"));
  EXPECT_EQ(text, tableText(table));
  EXPECT_THAT(text, HasSubstr("defect.length,defect.depth,state,peak [m/s2],\"wavelength, mean [m]\",message\n"));
  EXPECT_THAT(text, HasSubstr("\n20,0.1,done,0.6666666666666666,0.05,\n"));
  EXPECT_THAT(text, HasSubstr("\n40,0.2,failed,,,"));
}

// Whatever a run has no number for keeps its column, also after the study was resumed.
TEST_F(Study, columnsDoNotDependOnWhatWasFound) {
  const auto gaps = [](const StudyPoint& point, Monitor&) -> std::optional<FeatureRow> {
    return FeatureRow{{"peak [m/s2]", std::stod(point.values[0])}, {"peak 2 frequency [Hz]", std::nan("")}};
  };
  struct Impatient : Monitor {
    bool cancelled() override { return ended >= 3; }
    void message(const std::string&) override { ++ended; }
    int ended = 0;
  } impatient;
  runStudy(definition_, gaps, {folder("g"), 1, false}, impatient);
  runStudy(definition_, gaps, {folder("g"), 1, false}, monitor_);
  const std::string text = read(folder("g/study.csv"));
  EXPECT_THAT(text, HasSubstr("state,peak [m/s2],peak 2 frequency [Hz],message\n"));
  EXPECT_THAT(text, HasSubstr("\n20,0.1,done,20,,\n"));
  EXPECT_EQ(text, tableText(runStudy(definition_, gaps, {folder("h"), 1, false}, monitor_)));
}

// Killed without warning in the fifth run, then called again: the same bytes as without the interruption, and no run
// is made twice.
TEST_F(Study, killedAndResumedGivesTheSameTable) {
  for (const int jobs : {1, 2}) {
    const std::string whole = folder("whole" + std::to_string(jobs)), cut = folder("cut" + std::to_string(jobs));
    runStudy(definition_, pretend, {whole, jobs, false}, monitor_);
    const pid_t child = ::fork();
    if (child == 0) {
      std::atomic<int> runs{0};
      runStudy(
          definition_,
          [&](const StudyPoint& point, Monitor& monitor) {
            if (++runs == 5) ::raise(SIGKILL);
            return pretend(point, monitor);
          },
          {cut, jobs, false}, monitor_);
      ::_exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    const std::string half = read(cut + "/study.csv");
    EXPECT_LT(half.size(), read(whole + "/study.csv").size());
    std::atomic<int> runs{0};
    runStudy(
        definition_,
        [&](const StudyPoint& point, Monitor& monitor) {
          ++runs;
          return pretend(point, monitor);
        },
        {cut, jobs, false}, monitor_);
    EXPECT_EQ(read(cut + "/study.csv"), read(whole + "/study.csv"));
    EXPECT_EQ(read(cut + "/study.json"), read(whole + "/study.json"));
    EXPECT_GE(runs, 5);
    EXPECT_LE(runs, 6);  // four ended before; with two jobs one more may have been under way
  }
}

TEST_F(Study, cancelledRunsStayOpen) {
  struct Impatient : Monitor {
    bool cancelled() override { return ended >= 3; }
    void message(const std::string&) override { ++ended; }
    int ended = 0;
  } impatient;
  auto table = runStudy(definition_, pretend, {folder("c"), 1, false}, impatient);
  EXPECT_EQ(table.count(RowState::done), 3u);
  EXPECT_EQ(table.count(RowState::open), 6u);
  // a run that notices the cancelling itself and returns nothing
  table = runStudy(
      definition_, [](const StudyPoint&, Monitor&) { return std::optional<FeatureRow>(); }, {folder("c"), 1, false},
      monitor_);
  EXPECT_EQ(table.count(RowState::done), 3u);
  table = runStudy(definition_, pretend, {folder("c"), 1, false}, monitor_);
  EXPECT_EQ(table.count(RowState::open), 0u);
}

TEST_F(Study, failedRunsAreRepeatedOnRequestOnly) {
  runStudy(definition_, pretend, {folder("d"), 1, false}, monitor_);
  int runs = 0;
  const auto count = [&](const StudyPoint&, Monitor&) {
    ++runs;
    return std::optional<FeatureRow>(FeatureRow{{"peak [m/s2]", 1}});
  };
  EXPECT_EQ(runStudy(definition_, count, {folder("d"), 1, false}, monitor_).count(RowState::failed), 1u);
  EXPECT_EQ(runs, 0);
  EXPECT_EQ(runStudy(definition_, count, {folder("d"), 1, true}, monitor_).count(RowState::failed), 0u);
  EXPECT_EQ(runs, 1);
}

TEST_F(Study, anotherStudyIsNotOverwritten) {
  runStudy(definition_, pretend, {folder("e"), 1, false}, monitor_);
  auto other = definition_;
  other.variations[1] = variationFromText("defect.depth=0.1:0.4:3");
  EXPECT_THROW(runStudy(other, pretend, {folder("e"), 1, false}, monitor_), CaseError);
  other = definition_;
  other.caseHash = "87654321";
  EXPECT_THROW(runStudy(other, pretend, {folder("e"), 1, false}, monitor_), CaseError);
  std::ofstream(folder("e/study.csv"), std::ios::app) << "20,0.7,done,1,2,\n";
  try {
    runStudy(definition_, pretend, {folder("e"), 1, false}, monitor_);
    FAIL() << "a damaged table was accepted";
  } catch (const FileError& error) {
    EXPECT_EQ(error.location(), "line 11");
  }
}

TEST_F(Study, progressCountsTheWholeStudy) {
  struct Listener : Monitor {
    void report(const Progress& progress) override {
      fractions.push_back(progress.fraction);
      reports.push_back(progress);
    }
    std::vector<double> fractions;
    std::vector<Progress> reports;
  } listener;
  runStudy(
      definition_,
      [](const StudyPoint& point, Monitor& monitor) {
        Progress progress;
        progress.phase = "rolling";
        for (const double fraction : {0.1, 0.5}) {
          progress.fraction = fraction;
          monitor.report(progress);
        }
        return pretend(point, monitor);
      },
      {folder("f"), 1, false}, listener);
  ASSERT_EQ(listener.fractions.size(), 27u);
  EXPECT_NEAR(listener.fractions[1], 0.5 / 9, 1e-12);
  EXPECT_NEAR(listener.fractions.back(), 1, 1e-12);
  EXPECT_TRUE(std::is_sorted(listener.fractions.begin(), listener.fractions.end()));
  // The time left is not known after a hundredth, then it is, and at the end there is none.
  EXPECT_LT(listener.reports[0].remainingSeconds, 0);
  EXPECT_GT(listener.reports[1].remainingSeconds, 0);
  EXPECT_EQ(listener.reports.back().remainingSeconds, 0);
  EXPECT_EQ(listener.reports[0].phase, "0 of 9 runs done");
  EXPECT_EQ(listener.reports[3].phase, "1 of 9 runs done");
  EXPECT_EQ(listener.reports.back().phase, "9 of 9 runs done");
}

}  // namespace
}  // namespace squat::studies
