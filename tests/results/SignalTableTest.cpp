#include "results/SignalTable.h"

#include <gmock/gmock.h>

#include <clocale>
#include <sstream>

#include "results/SampleResult.h"

namespace squat::results {
namespace {

TEST(SignalTable, HeaderNamesUnitsAndNumbersReadBackExactly) {
  const auto result = tests::sampleResult(5);
  std::istringstream table(signalTable(result));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "time [s],position [m],wheel_speed [m/s2],aba [m/s2],contact_force [m/s2]");
  int rows = 0;
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    std::string time, position, speed, aba;
    std::getline(cells, time, ',');
    std::getline(cells, position, ',');
    std::getline(cells, speed, ',');
    std::getline(cells, aba, ',');
    EXPECT_EQ(std::stod(time), result.time[rows]);
    EXPECT_EQ(std::stod(aba), result.signals[1].values[rows]);
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

}  // namespace
}  // namespace squat::results
