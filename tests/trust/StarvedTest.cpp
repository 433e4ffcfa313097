// Runs that find no room: the disk fills up while they roll, the folder of the checkpoints is gone.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cstdlib>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"
#include "simulation/RunCase.h"
#include "trust/Program.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using ::testing::HasSubstr;
using tests::TemporaryFolder;

constexpr std::size_t kMaximum = 100000000;

// For programs started meanwhile: no file grows beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(Starved, AFullDiskCostsNeitherTheEarlierResultNorTheProgramsLife) {
  const TemporaryFolder folder;
  const auto path = folder / "light-defect.h5";
  results::writeResult(path, tests::sampleResult());
  const auto before = readWholeFile(path, kMaximum);
  std::string output;
  {
    const FileSizeLimit limit(20000);
    EXPECT_EQ(tests::call(tests::shortRun(folder.path()), &output), 4) << output;
  }
  EXPECT_THAT(output, HasSubstr("the run continues without this checkpoint"));
  EXPECT_THAT(output, HasSubstr(path + ": cannot be written"));
  EXPECT_THAT(output, HasSubstr("bytes needed"));
  EXPECT_EQ(readWholeFile(path, kMaximum), before);
  // What was computed is not lost with it: the numbers are seen, the signals fit.
  EXPECT_THAT(output, HasSubstr("contact force at equilibrium"));
  EXPECT_THAT(output, HasSubstr(folder / "light-defect.partial.csv"));
  EXPECT_THAT(readWholeFile(folder / "light-defect.partial.csv", kMaximum), ::testing::StartsWith("time [s],"));
}

// /dev/full is a disk without room. A shell as users have it: the program cannot see where its output goes.
TEST(Starved, OutputThatIsLostIsReported) {
  const TemporaryFolder folder;
  const auto call = [&](const std::string& words) {
    const int status = std::system((std::string(SQUAT_PROGRAM) + " " + words + " 2> " + (folder / "reported")).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  for (const char* words : {"describe light-defect", "describe light-defect --json", "--version", "--help"}) {
    EXPECT_EQ(call(std::string(words) + " > /dev/full"), 4) << words;
    EXPECT_THAT(readWholeFile(folder / "reported", kMaximum), HasSubstr("cannot write the complete output")) << words;
    EXPECT_EQ(call(std::string(words) + " >&-"), 0) << "nobody wants to see it: " << words;
  }
  EXPECT_EQ(call("describe no-such-case > /dev/full"), 4);
  EXPECT_EQ(call("describe --bogus > /dev/full"), 2);
  EXPECT_EQ(call("describe light-defect | head -c 1 > " + (folder / "head")), 0);
  EXPECT_EQ(readWholeFile(folder / "reported", kMaximum), "") << "who reads the beginning only wants no more";
}

// Whoever was to read the numbers has gone: the run stands in its files all the same.
TEST(Starved, AReaderThatHasGoneCostsNoRun) {
  const TemporaryFolder folder;
  std::string words = SQUAT_PROGRAM;
  for (const auto& word : tests::shortRun(folder.path())) words += " " + word;
  std::system((words + " 2> /dev/null | true").c_str());
  EXPECT_TRUE(results::isCompleteResult(folder / "light-defect.h5"));
  EXPECT_THAT(readWholeFile(folder / "light-defect.csv", kMaximum), ::testing::StartsWith("time [s],"));
}

TEST(Starved, ARunOutlivesTheFolderOfItsCheckpoints) {
  class Messages : public Monitor {
   public:
    void message(const std::string& text) override {
      all += text + "\n";
      if (text.starts_with("warning: ")) ++warnings;
    }
    std::string all;
    std::size_t warnings = 0;
  } monitor;
  const TemporaryFolder folder;
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  overrides.values = tests::shortSets();
  simulation::RunOptions options;
  options.threads = 1;
  options.checkpointPath = folder / "gone/run.checkpoint";
  options.checkpointSeconds = 0;
  const auto result =
      simulation::runCase(cases::loadCase(tests::fixtureCase("light-defect"), overrides), options, monitor);
  EXPECT_TRUE(result.complete);
  EXPECT_THAT(monitor.all, HasSubstr(options.checkpointPath + ": cannot be written: No such file or directory"));
  EXPECT_EQ(monitor.warnings, result.warnings.size()) << "reported once, and kept with the result";
}

}  // namespace
}  // namespace squat
