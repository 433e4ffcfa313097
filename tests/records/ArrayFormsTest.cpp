// The same record as other programs write it into files of arrays: tests/records/files/make_arrays.py.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "readers/SignalFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string files = std::string(SQUAT_SOURCE_DIR) + "/tests/records/files/";
constexpr double gravity = 9.80665;

double left(std::size_t i) {
  return gravity *
         (10 * std::sin(2 * std::numbers::pi * 300 * static_cast<double>(i) / 25000) + static_cast<double>(i) / 100);
}

std::size_t channelNamed(const std::vector<RecordChannel>& channels, const std::string& name) {
  std::size_t c = 0;
  while (c < channels.size() && channels[c].name != name) ++c;
  return c;
}

struct Form {
  const char* file;
  double tolerance;  // [m/s2] of a value: what the numbers of the file can hold
};

std::ostream& operator<<(std::ostream& out, const Form& form) { return out << form.file; }

class ArrayForms : public ::testing::TestWithParam<Form> {};

// Without a unit, a column or an object in the call; pandas writes no units.
TEST_P(ArrayForms, GiveTheRecordThatWasWritten) {
  RecordOptions options;
  options.columns.speed = 30;
  options.blockLength = 150;
  if (std::string(GetParam().file) == "pandas-table.h5") options.columns.signalUnit = "g";
  const auto whole = readWhole(files + GetParam().file, options);
  EXPECT_THAT(whole.faults, IsEmpty());
  EXPECT_NEAR(whole.layout.rate, 25000, 1e-6);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  const std::size_t l = channelNamed(whole.layout.channels, "left"), r = channelNamed(whole.layout.channels, "right");
  ASSERT_LT(l, 2u);
  ASSERT_LT(r, 2u);
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.stretches[0].size(), 400u);
  for (std::size_t i = 0; i < 400; ++i) {
    ASSERT_NEAR(whole.stretches[0].values[l][i], left(i), GetParam().tolerance);
    ASSERT_NEAR(whole.stretches[0].values[r][i], 2 * left(i), 1e-9);
  }
}

TEST_P(ArrayForms, GiveTheSameToShortReaders) {
  readers::SignalFileOptions options;
  options.column = "left";
  options.speed = 30;
  if (std::string(GetParam().file) == "pandas-table.h5") options.signalUnit = "g";
  const auto runs = readers::readSignals(files + GetParam().file, options);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 25000, 1e-6);
  ASSERT_EQ(runs[0].signals[0].values.size(), 400u);
  for (std::size_t i = 0; i < 400; ++i) ASSERT_NEAR(runs[0].signals[0].values[i], left(i), GetParam().tolerance);
}

// Single precision holds 200 m/s2 to 1e-5; steps of 0.01 m/s2 to half of that.
INSTANTIATE_TEST_SUITE_P(Written, ArrayForms,
                         ::testing::Values(Form{"simulink.mat", 1e-9}, Form{"cells.mat", 1e-9},
                                           Form{"cells73.mat", 1e-9}, Form{"structures73.mat", 1e-9},
                                           Form{"compound.h5", 1e-5}, Form{"pandas-table.h5", 1e-9},
                                           Form{"channels.h5", 1e-9}, Form{"packed.nc", 0.005001}),
                         [](const auto& form) {
                           std::string name;
                           for (const char* c = form.param.file; *c && *c != '.'; ++c)
                             if (*c != '-') name += *c;
                           return name;
                         });

TEST(ArrayRecord, ChannelsOfTwoRatesAreNotOneRecord) {
  RecordOptions options;
  options.columns.speed = 30;
  EXPECT_THAT(complaintAbout(files + "two-rates.mat", options),
              HasSubstr("/channels{2}/fs: states 12500, /channels{1}/fs 25000"));
  options.columns.object = "/channels{2}/data";
  const auto right = readWhole(files + "two-rates.mat", options);
  EXPECT_NEAR(right.layout.rate, 12500, 1e-6);
  ASSERT_EQ(right.layout.channels.size(), 1u);
  EXPECT_NEAR(right.stretches.at(0).values[0][7], 2 * left(7), 1e-9);
}

TEST(ArrayRecord, AnArrayInARecordIsChosenByItsPlace) {
  RecordOptions options;
  options.columns.signalUnit = "g";
  options.columns.speed = 30;
  options.columns.column = "pair 2";
  const auto pair = readWhole(files + "compound.h5", options);
  ASSERT_EQ(pair.layout.channels.size(), 1u);
  for (std::size_t i = 0; i < 400; ++i) ASSERT_NEAR(pair.stretches.at(0).values[0][i], 2 * left(i), 1e-9);
}

TEST(ArrayRecord, ClassicNetCdfIsNamed) {
  EXPECT_THAT(complaintAbout(files + "classic.nc", {}), HasSubstr("nccopy -k netCDF-4"));
}

}  // namespace
}  // namespace squat::records
