// squat warm and squat run --warm as a user calls them: files, exit codes, messages, signals and kills.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "core/DurableFile.h"
#include "results/ResultFile.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "simulation/StoppedRuns.h"
#include "simulation/WarmStateFile.h"
#include "trust/Program.h"

namespace squat {
namespace {

using ::testing::HasSubstr;
using tests::call;
using tests::Program;
using tests::TemporaryFolder;
using Words = std::vector<std::string>;

Words words(const std::string& command, const std::string& folder, const Words& besides = {}) {
  Words all{command, "light-defect",       "--mesh",    "tiny", "-o", folder, "--set", "motion.run_up=0.06",
            "--set", "motion.beyond=0.03", "--threads", "1"};
  if (command == "run") all.emplace_back("--no-figures");
  all.insert(all.end(), besides.begin(), besides.end());
  return all;
}

TEST(WarmProgram, KeepsAStateAndStartsFromIt) {
  const TemporaryFolder folder;
  const auto file = folder / "warm/light-defect.warm";
  std::string output;
  ASSERT_EQ(call(words("warm", folder / "warm"), &output), 0) << output;
  EXPECT_THAT(output, HasSubstr("written: " + file));
  ASSERT_EQ(call(words("run", folder / "whole"), &output), 0) << output;
  ASSERT_EQ(call(words("run", folder / "from", {"--warm", file}), &output), 0) << output;
  const auto whole = results::readResult(folder / "whole/light-defect.h5");
  const auto from = results::readResult(folder / "from/light-defect.h5");
  EXPECT_EQ(results::firstDifference(tests::comparable(whole), tests::comparable(from)), "");
  for (const auto& figure : from.performance) EXPECT_NE(figure.name, "seconds_equilibrium");

  EXPECT_EQ(call(words("run", folder / "other", {"--warm", file, "--set", "pad.stiffness=999"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("squat: invalid case: pad.stiffness is 999 MN/m, must be "));
  EXPECT_THAT(output, HasSubstr("as in " + file));
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
  const auto bytes = readWholeFile(file, 1 << 28);
  writeDurably(folder / "cut.warm", std::string_view(bytes).substr(0, bytes.size() / 2));
  EXPECT_EQ(call(words("run", folder / "other", {"--warm", folder / "cut.warm"}), &output), 4);
  EXPECT_THAT(output, HasSubstr("squat: invalid file: " + (folder / "cut.warm")));
  EXPECT_EQ(call(words("warm", folder / "other", {"--set", "defect.move_nodes=true"}), &output), 2);
  EXPECT_THAT(output, HasSubstr("defect.move_nodes is true, must be false for a warm state"));
}

// A shorter defect runs on the mesh of the state, says so, and resumes from its own checkpoint.
TEST(WarmProgram, AStoppedRunIsResumed) {
  const TemporaryFolder folder;
  const auto file = folder / "light-defect.warm";
  const Words zone{"--set", "mesh.zone_before=36", "--set", "mesh.zone_behind=60"};
  std::string output;
  ASSERT_EQ(call(words("warm", folder.path(), zone), &output), 0) << output;
  ASSERT_EQ(call(words("run", folder / "whole", zone), &output), 0) << output;
  Program program(words("run", folder / "run", {"--warm", file}));
  ASSERT_TRUE(program.waitForOutput("rolling")) << program.output();
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130) << program.output();
  EXPECT_THAT(program.output(), HasSubstr("mesh.zone_before = 36 mm, mesh.zone_behind = 60 mm"));
  EXPECT_EQ(call(words("run", folder / "run", {"--resume"}), &output), 2) << "the case on its own mesh is another one";
  ASSERT_EQ(call(words("run", folder / "run", {"--resume", "--warm", file}), &output), 0) << output;
  EXPECT_EQ(results::firstDifference(tests::comparable(results::readResult(folder / "whole/light-defect.h5")),
                                     tests::comparable(results::readResult(folder / "run/light-defect.h5"))),
            "");
}

TEST(WarmProgram, InterruptedItLeavesNothing) {
  for (const char* phase : {"mesh", "equilibrium"}) {
    const TemporaryFolder folder;
    Program program(words("warm", folder / "new/out"));
    ASSERT_TRUE(program.waitForOutput(phase)) << program.output();
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 130) << program.output();
    EXPECT_THAT(program.output(), HasSubstr("cancelled: no file written"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

// Kills at moments from start to end: what stood before is there, whole.
TEST(WarmProgram, KilledItLosesNothing) {
  const TemporaryFolder folder;
  std::string output;
  ASSERT_EQ(call(words("warm", folder.path()), &output), 0) << output;
  for (int kill = 0; kill < 6; ++kill) {
    Program program(words("warm", folder.path()));
    program.waitForOutput("mesh");
    std::this_thread::sleep_for(std::chrono::milliseconds(250 * kill));
    program.signal(SIGKILL);
    program.wait();
    EXPECT_NO_THROW(simulation::readWarmState(folder / "light-defect.warm")) << "after kill " << kill;
  }
}

}  // namespace
}  // namespace squat
