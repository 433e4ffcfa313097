// 200 short cases in a row, one of them poisoned: the others finish, memory stays flat, the summary names the failure.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/DurableFile.h"
#include "results/SampleResult.h"
#include "trust/Program.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using ::testing::HasSubstr;

constexpr int kRuns = 200;

double residentBytes(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096;
}

// What a tenth of the values lie below: a run has less memory in some phases and 5 % more in others, and which of both
// is the median depends on how busy the machine is. What is never given back raises the lowest as well.
double lowTenth(std::vector<double> values) {
  const auto tenth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 10);
  std::nth_element(values.begin(), tenth, values.end());
  return *tenth;
}

TEST(Soak, TwoHundredCasesOnePoisoned) {
  const tests::TemporaryFolder folder;
  // Steps a little below the stable one; the poisoned run asks for one far above, which only the run itself finds out.
  std::string steps = "output.time_step=";
  for (int i = 0; i < kRuns; ++i)
    steps += (i ? "," : "") + (i == 70 ? std::string("9") : std::to_string(0.4 + 1e-4 * i));
  std::vector<std::string> arguments{"study",       "light-defect", "--mesh", "tiny",   "-o",
                                     folder.path(), "--jobs",       "1",      "--vary", steps};
  for (const auto& [key, value] : tests::shortSets()) arguments.insert(arguments.end(), {"--set", key + "=" + value});
  tests::Program program(arguments);
  std::vector<double> memory;
  while (program.running()) {
    memory.push_back(residentBytes(program.process()));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  EXPECT_NE(program.wait(), 0);
  const auto table = readWholeFile(folder / "study.csv", 100000000);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), kRuns + 1);
  EXPECT_THAT(program.output(), HasSubstr("199 of 200 runs done"));
  EXPECT_THAT(program.output(), HasSubstr("failed: output.time_step=9"));
  // The last third against the second: the first holds what is loaded once.
  const auto third = static_cast<std::ptrdiff_t>(memory.size() / 3);
  const double second = lowTenth({memory.begin() + third, memory.begin() + 2 * third});
  const double last = lowTenth({memory.begin() + 2 * third, memory.end()});
  EXPECT_NEAR(last / second, 1, 0.02);
}

}  // namespace
}  // namespace squat
