// The memory that a run reports is that of the whole command: drawing takes more than the simulation of a small mesh.
#include <gtest/gtest.h>

#include <regex>

#include "results/SampleResult.h"
#include "trust/Program.h"

namespace squat {
namespace {

// [MiB]; -1 where the line is not there.
double memoryAfter(const std::string& label, const std::string& output) {
  std::smatch found;
  return std::regex_search(output, found, std::regex(label + ":? +([0-9.]+) MiB")) ? std::stod(found.str(1)) : -1;
}

TEST(RunMemory, IsReportedAfterTheFiguresAreDrawn) {
  const tests::TemporaryFolder folder;
  std::string output;
  ASSERT_EQ(tests::call({"run", "light-defect", "--mesh", "tiny", "-o", folder / "out"}, &output), 0) << output;
  const double simulation = memoryAfter("peak memory of the simulation", output);
  const double whole = memoryAfter("peak memory of the command", output);
  EXPECT_GT(simulation, 0) << output;
  // Qt with its fonts and one picture of 600 points per inch take 30 MiB at least.
  EXPECT_GT(whole, simulation + 30) << output;
  EXPECT_LT(output.find("written:"), output.find("of the command")) << "said ahead of the figures";
}

}  // namespace
}  // namespace squat
