// Long records from HDF5: the same record as from short readers, in pieces.
#include <gmock/gmock.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

#include "core/DurableFile.h"
#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"
#include "results/Hdf5.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::TemporaryFile;

const std::string shared = std::string(SQUAT_SOURCE_DIR) + "/tests/readers/files/";
const std::string own = std::string(SQUAT_SOURCE_DIR) + "/tests/records/files/";

// The signal in the files of tests/readers/files/make_files.py and tests/records/files/make_files.py.
double aba(std::size_t i) {
  return 10 * std::sin(2 * std::numbers::pi * 300 * static_cast<double>(i) / 25000) + static_cast<double>(i) / 100;
}

constexpr std::size_t samples = 200000;

// Left and right, written as this program writes its files: shuffled and deflated.
void write(const std::string& path, bool withTime) {
  results::ArrayTree tree;
  std::vector<double> time(samples), position(samples);
  std::vector<float> left(samples), right(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    time[i] = 3 + static_cast<double>(i) / 25000;
    position[i] = 1000 + 30 * static_cast<double>(i) / 25000;
    left[i] = static_cast<float>(i % 1001);
    right[i] = -left[i];
  }
  if (withTime) tree.add("/run/time", time, "s");
  tree.add("/run/position", position, "m");
  tree.add("/run/left", left, "g");
  tree.add("/run/right", right, "m/s2");
  tree.add("/other/short", std::vector<double>{1, 2, 3}, "m");
  tree.addScalar("/run/fs", 25000, "Hz");
  writeDurably(path, results::encodeHdf5(tree, path));
}

TEST(Hdf5Record, channelsOfAGroup) {
  const TemporaryFile file("", ".h5");
  for (const bool withTime : {true, false}) {
    write(file.path(), withTime);
    RecordOptions options;
    options.columns.signalUnit = "m/s2";
    options.blockLength = 30000;
    const auto whole = readWhole(file.path(), options);
    EXPECT_THAT(whole.faults, IsEmpty());
    EXPECT_EQ(whole.layout.samples, samples);
    EXPECT_EQ(whole.layout.rate, 25000);
    ASSERT_EQ(whole.layout.channels.size(), 2u);
    ASSERT_EQ(whole.stretches.size(), 1u);
    const auto& all = whole.stretches[0];
    ASSERT_EQ(all.size(), samples);
    EXPECT_NEAR(all.time, withTime ? 3 : 0, 1e-12);
    const std::size_t left = whole.layout.channels[0].name == "left" ? 0 : 1;
    for (std::size_t i = 0; i < samples; i += 77) {
      ASSERT_DOUBLE_EQ(all.values[left][i], 9.80665 * static_cast<double>(i % 1001));
      ASSERT_EQ(all.values[1 - left][i], -static_cast<double>(i % 1001));
      ASSERT_NEAR(all.position[i], 1000 + 30 * static_cast<double>(i) / 25000, 1e-9);
      ASSERT_NEAR(all.speed[i], 30, 1e-6);
    }
  }
}

// One channel as other programs write it: in one piece, or in chunks of 10000. Returns the byte at which value 150000
// is stored; the values are their own numbers.
std::size_t writePlain(const std::string& path, bool inChunks) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t extent = samples, chunk = 10000;
  const hid_t space = H5Screate_simple(1, &extent, nullptr), creation = H5Pcreate(H5P_DATASET_CREATE);
  if (inChunks) H5Pset_chunk(creation, 1, &chunk);
  const hid_t set = H5Dcreate2(file, "aba", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  std::vector<double> values(samples);
  std::iota(values.begin(), values.end(), 0.0);
  EXPECT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  haddr_t at = 0;
  if (inChunks) {
    hsize_t first = 150000, size = 0;
    unsigned filters = 0;
    EXPECT_GE(H5Dget_chunk_info_by_coord(set, &first, &filters, &at, &size), 0);
  } else {
    at = H5Dget_offset(set) + 150000 * sizeof(double);
  }
  H5Dclose(set), H5Pclose(creation), H5Sclose(space), H5Fclose(file);
  return at;
}

TEST(Hdf5Record, whatIsLeftOfAFileThatIsCutOff) {
  for (const bool inChunks : {false, true}) {
    const TemporaryFile whole("", ".h5");
    const auto at = writePlain(whole.path(), inChunks);
    const auto bytes = readWholeFile(whole.path(), std::size_t{64} << 20);
    const TemporaryFile cut(bytes.substr(0, at + 5), ".h5");  // value 150000 is not whole
    RecordOptions options;
    options.columns.signalUnit = "m/s2";
    options.columns.rate = 25000, options.columns.speed = 30;
    const auto left = readWhole(cut.path(), options);
    const auto truncated = left.faultsOf(FaultKind::truncated);
    ASSERT_EQ(truncated.size(), 1U);
    EXPECT_THAT(truncated[0].text, HasSubstr(std::to_string(bytes.size() - at - 5) + " bytes"));
    ASSERT_EQ(left.stretches.size(), 1U);
    ASSERT_EQ(left.stretches[0].size(), 150000U) << (inChunks ? "chunks" : "one piece");
    for (std::size_t i = 0; i < 150000; ++i) ASSERT_EQ(left.stretches[0].values[0][i], static_cast<double>(i));
  }
}

// The channels of this program's own files, packed: what is left of each is right.
TEST(Hdf5Record, whatIsLeftOfPackedChannels) {
  const TemporaryFile packed("", ".h5");
  write(packed.path(), false);
  const auto bytes = readWholeFile(packed.path(), std::size_t{64} << 20);
  for (const double share : {0.95, 0.8}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    const TemporaryFile cut(bytes.substr(0, kept), ".h5");
    RecordOptions options;
    options.columns.signalUnit = "m/s2";
    options.columns.rate = 25000;  // written last, and lost
    const auto left = readWhole(cut.path(), options);
    ASSERT_EQ(left.faultsOf(FaultKind::truncated).size(), 1U);
    ASSERT_FALSE(left.stretches.empty());
    const auto& first = left.stretches[0];
    for (std::size_t c = 0; c < first.values.size(); ++c) {
      std::size_t end = first.size();
      for (const auto& fault : left.faultsOf(FaultKind::notANumber))
        if (fault.channel == static_cast<int>(c)) end = std::min<std::size_t>(end, fault.first);
      EXPECT_GT(end, 0U);
      const double factor = left.layout.channels[c].name == "left" ? 9.80665 : -1;
      for (std::size_t i = 0; i < end; ++i)
        ASSERT_DOUBLE_EQ(first.values[c][i], factor * static_cast<double>(i % 1001)) << c << ' ' << i;
    }
  }
}

TEST(Hdf5Record, matlabFiles) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  const auto whole = readWhole(shared + "matlab73.mat", options);
  EXPECT_EQ(whole.layout.rate, 25000);
  ASSERT_EQ(whole.stretches[0].size(), 100u);
  for (std::size_t i = 0; i < 100; ++i) ASSERT_NEAR(whole.stretches[0].values[0][i], aba(i), 1e-12);
  options.columns.object = "run2";
  options.columns.speed = 0;
  const auto second = readWhole(shared + "matlab73.mat", options);
  EXPECT_EQ(second.stretches[0].speed[5], 28);
  EXPECT_NEAR(second.stretches[0].values[0][7], 2 * aba(7), 1e-12);
}

TEST(Hdf5Record, runsOfADatasetAreChannels) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  options.columns.object = "/line/track1/aba";
  const auto whole = readWhole(shared + "runs.h5", options);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  EXPECT_EQ(whole.layout.channels[1].name, "aba 2");
  for (std::size_t i = 0; i < 100; ++i)  // stored in single precision
    ASSERT_NEAR(whole.stretches[0].values[1][i], 2 * 9.80665 * aba(i), 2e-5);
  options.columns.object = "/line/track9";
  EXPECT_THAT(complaintAbout(shared + "runs.h5", options), HasSubstr("/line/track1/counts"));
}

TEST(Hdf5Record, pandasFrames) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  for (const char* object : {"", "/time", "dated"}) {
    options.columns.object = object;
    const auto whole = readWhole(own + "pandas.h5", options);
    ASSERT_EQ(whole.layout.channels.size(), 2u) << object;
    EXPECT_EQ(whole.layout.channels[0].name, "left");
    // Seconds since 1970 are known to 2.4e-7 s as doubles; over 99 steps of 4e-5 s that is 1.2e-4 of the rate.
    EXPECT_NEAR(whole.layout.rate, 25000, *object == 'd' ? 3 : 1e-3);
    EXPECT_TRUE(whole.layout.hasPosition);
    ASSERT_EQ(whole.stretches[0].size(), *object == 'd' ? 100u : 400u);
    EXPECT_NEAR(whole.stretches[0].values[0][50], 9.80665 * aba(50), 1e-9);
    EXPECT_NEAR(whole.stretches[0].values[1][50], 2 * 9.80665 * aba(50), 1e-9);
    EXPECT_NEAR(whole.stretches[0].position[50], 500 + 0.001 * 50, 1e-9);
  }
}

TEST(Hdf5Record, damageIsAnErrorOfOurs) {
  const TemporaryFile whole("", ".h5");
  write(whole.path(), true);
  const std::string bytes = readWholeFile(whole.path(), std::size_t{1} << 30);
  // Cut off before its first value, and with a piece of its middle overwritten.
  const TemporaryFile cut(bytes.substr(0, bytes.size() / 1000), ".h5");
  EXPECT_THAT(complaintAbout(cut.path()), HasSubstr(cut.path()));
  for (std::size_t at = 600; at + 4000 < bytes.size(); at += bytes.size() / 7) {
    std::string spoilt = bytes;
    std::memset(spoilt.data() + at, 0x5a, 2000);
    const TemporaryFile file(spoilt, ".h5");
    EXPECT_NO_THROW(complaintAbout(file.path())) << at;
  }
}

}  // namespace
}  // namespace squat::records
