// The table of `squat run --timings`.
#include "commands/TimingsTable.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace squat::commands {
namespace {

using dynamics::StepPhase;
using dynamics::StepTimings;

TEST(TimingsTable, HasARowForEachPhaseThatTookTimeAndAColumnForEachThread) {
  StepTimings timings(2);
  timings.end(0, StepPhase::wheelset);
  timings.end(0, StepPhase::stations);
  timings.end(1, StepPhase::waiting);
  timings.countSteps(10);
  std::istringstream table(timingsTable(timings));
  std::string heading, line;
  std::getline(table, heading);
  EXPECT_TRUE(std::regex_search(heading, std::regex("phase of a step +thread 1 \\[us\\] +thread 2 \\[us\\] +share")));
  std::getline(table, line);  // below the heading
  std::vector<std::string> phases;
  double shares = 0;
  while (std::getline(table, line)) {
    phases.push_back(line.substr(0, line.find("  ")));
    shares += std::stod(line.substr(line.rfind(' ')));
  }
  EXPECT_EQ(phases, (std::vector<std::string>{"wheelset", "stations", "waiting"}));
  EXPECT_NEAR(shares, 100, 0.2);  // three numbers of one decimal
}

TEST(TimingsTable, IsEmptyWithoutSteps) { EXPECT_EQ(timingsTable(StepTimings(2)), ""); }

}  // namespace
}  // namespace squat::commands
