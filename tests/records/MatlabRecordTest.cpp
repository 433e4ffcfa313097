// MATLAB files of the versions 5 to 7.2, as SciPy writes them: tests/records/files/make_files.py.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/DurableFile.h"
#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::TemporaryFile;

const std::string files = std::string(SQUAT_SOURCE_DIR) + "/tests/records/files/";

double aba(std::size_t i) {
  return 10 * std::sin(2 * std::numbers::pi * 300 * static_cast<double>(i) / 25000) + static_cast<double>(i) / 100;
}

TEST(MatlabRecord, aVariableWithItsRate) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  const auto whole = readWhole(files + "matlab5.mat", options);
  EXPECT_THAT(whole.faults, IsEmpty());
  EXPECT_EQ(whole.layout.rate, 25000);
  ASSERT_EQ(whole.layout.channels.size(), 1u);
  EXPECT_EQ(whole.layout.channels[0].name, "aba");
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.stretches[0].size(), 400u);
  for (std::size_t i = 0; i < 400; ++i) ASSERT_NEAR(whole.stretches[0].values[0][i], aba(i), 1e-12);
}

TEST(MatlabRecord, aDeflatedStructureOfSeveralTypes) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.object = "run";
  options.columns.column = "left,counts";
  options.blockLength = 100;
  const auto whole = readWhole(files + "matlab7.mat", options);
  EXPECT_NEAR(whole.layout.rate, 25000, 1e-6);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  const std::size_t left = whole.layout.channels[0].name == "left" ? 0 : 1;
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.stretches[0].size(), 400u);
  for (std::size_t i = 0; i < 400; ++i) {
    ASSERT_NEAR(whole.stretches[0].values[left][i], aba(i), 1e-6);                // single precision
    ASSERT_EQ(whole.stretches[0].values[1 - left][i], std::trunc(100 * aba(i)));  // as SciPy cut it to 16 bits
    ASSERT_EQ(whole.stretches[0].speed[i], 28);
  }
}

TEST(MatlabRecord, columnsOfAMatrixAreChannels) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.object = "channels";
  options.columns.rate = 25000;
  options.columns.speed = 30;
  const auto whole = readWhole(files + "matlab7.mat", options);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  for (std::size_t i = 0; i < 400; i += 7) {
    ASSERT_NEAR(whole.stretches[0].values[0][i], aba(i), 1e-12);
    ASSERT_NEAR(whole.stretches[0].values[1][i], 2 * aba(i), 1e-12);
  }
}

TEST(MatlabRecord, shortReadersReadThemAsWell) {
  const auto runs = readers::readSignals(files + "matlab5.mat");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 25000, 1e-9);
  EXPECT_NEAR(runs[0].signals[0].values[7], aba(7), 1e-12);
}

TEST(MatlabRecord, whatIsThereIsNamed) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.object = "axle";
  EXPECT_THAT(complaintAbout(files + "matlab7.mat", options), HasSubstr("/run/left"));
}

TEST(MatlabRecord, damageIsAnErrorOfOurs) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  for (const char* name : {"matlab5.mat", "matlab7.mat"}) {
    const std::string bytes = readWholeFile(files + name, std::size_t{1} << 20);
    for (std::size_t size = 130; size < bytes.size(); size += bytes.size() / 5) {
      const TemporaryFile cut(bytes.substr(0, size), ".mat");
      EXPECT_THAT(complaintAbout(cut.path(), options), HasSubstr("cut off")) << name << ' ' << size;
    }
    for (std::size_t at = 128; at + 8 < bytes.size(); at += bytes.size() / 40) {
      std::string spoilt = bytes;
      for (std::size_t i = 0; i < 8; ++i) spoilt[at + i] = static_cast<char>(0x5a + i);
      const TemporaryFile file(spoilt, ".mat");
      EXPECT_NO_THROW(complaintAbout(file.path(), options)) << name << ' ' << at;
    }
  }
}

}  // namespace
}  // namespace squat::records
