// Nine real runs, as short as features allow, killed in the fifth and resumed: the table of an undisturbed study.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "simulation/RunCase.h"
#include "studies/CaseStudy.h"

namespace squat::studies {
namespace {

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Kills the process in the middle of rolling.
struct KillInRolling : Monitor {
  void report(const Progress& progress) override {
    if (progress.phase == "rolling" && progress.fraction > 0.5) ::raise(SIGKILL);
  }
};

TEST(RealStudy, killedHalfWayAndResumedGivesTheSameTable) {
  const auto root = std::filesystem::temp_directory_path() / ("squat-real-study-" + std::to_string(::getpid()));
  const std::string whole = (root / "whole").string(), cut = (root / "cut").string();
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  // As coarse and short as a run may be: about five seconds of one core each.
  overrides.values = {{"motion.run_up", "0.05"},    {"motion.beyond", "0.07"},    {"track.length", "3"},
                      {"mesh.section_size", "30"},  {"mesh.section_growth", "2"}, {"mesh.contact_size", "8"},
                      {"mesh.rolling_size", "12"},  {"mesh.far_size", "200"},     {"mesh.wheel_sectors", "24"},
                      {"defect.wave_depth", "0.04"}};  // no wave deeper than the shallowest dip
  const auto definition = studyOf(std::string(SQUAT_SOURCE_DIR) + "/resources/cases/class-c-squat.toml", overrides,
                                  {"defect.length=20:60:3", "defect.depth=0.05:0.15:3"});
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = options.snapshots = false;
  int runs = 0;
  bool killing = false;
  const auto run = [&](const cases::CaseDescription& description, const StudyPoint&, Monitor& own) {
    KillInRolling deadly;
    return simulation::runCase(description, options, ++runs == 5 && killing ? deadly : own);
  };
  Monitor monitor;
  const pid_t child = ::fork();
  if (child == 0) {
    killing = true;
    runCaseStudy(definition, overrides, run, {cut, 1, false}, monitor);
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  const std::string half = read(cut + "/study.csv");
  runCaseStudy(definition, overrides, run, {cut, 1, false}, monitor);
  EXPECT_EQ(runs, 5);  // four stood already
  const auto table = runCaseStudy(definition, overrides, run, {whole, 1, false}, monitor);
  EXPECT_EQ(runs, 14);
  EXPECT_EQ(table.count(RowState::done), 9u);
  const std::string text = read(whole + "/study.csv");
  EXPECT_EQ(text.compare(0, half.size(), half), 0);
  EXPECT_LT(half.size(), text.size());
  EXPECT_EQ(read(cut + "/study.csv"), text);
  EXPECT_EQ(read(cut + "/study.json"), read(whole + "/study.json"));
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace squat::studies
