// Runs that find no room: the disk fills up while they roll, the folder of the checkpoints is gone.
#include <gmock/gmock.h>
#include <sys/resource.h>

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
using testing::TemporaryFolder;

constexpr std::size_t kMost = 100000000;

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
  results::writeResult(path, testing::sampleResult());
  const auto before = readWholeFile(path, kMost);
  std::string output;
  {
    const FileSizeLimit limit(20000);
    EXPECT_EQ(testing::call(testing::shortRun(folder.path()), &output), 4) << output;
  }
  EXPECT_THAT(output, HasSubstr("the run goes on without this checkpoint"));
  EXPECT_THAT(output, HasSubstr(path + ": cannot be written"));
  EXPECT_THAT(output, HasSubstr("bytes needed"));
  EXPECT_EQ(readWholeFile(path, kMost), before);
}

TEST(Starved, ARunOutlivesTheFolderOfItsCheckpoints) {
  class Messages : public Monitor {
   public:
    void message(const std::string& text) override { all += text + "\n"; }
    std::string all;
  } monitor;
  const TemporaryFolder folder;
  cases::CaseOverrides overrides;
  overrides.preset = "tiny";
  overrides.values = testing::shortSets();
  simulation::RunOptions options;
  options.threads = 1;
  options.checkpointPath = folder / "gone/run.checkpoint";
  options.checkpointSeconds = 0;
  const auto result = simulation::runCase(cases::loadCase("light-defect", overrides), options, monitor);
  EXPECT_TRUE(result.complete);
  EXPECT_THAT(monitor.all, HasSubstr(options.checkpointPath + ": cannot be written: No such file or directory"));
  EXPECT_EQ(std::count(monitor.all.begin(), monitor.all.end(), '\n'), static_cast<long>(result.warnings.size()))
      << "told once, and kept with the result";
}

}  // namespace
}  // namespace squat
