#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <numbers>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "readers/SignalFile.h"
#include "readers/TemporaryFile.h"
#include "results/Hdf5.h"

namespace squat::readers {
namespace {

using ::testing::HasSubstr;

const std::string files = std::string(SQUAT_SOURCE_DIR) + "/tests/readers/files/";

double aba(std::size_t i) {
  return 10 * std::sin(2 * std::numbers::pi * 300 * static_cast<double>(i) / 25000) + static_cast<double>(i) / 100;
}

std::string complaint(const std::string& path, const SignalFileOptions& options = {}) {
  try {
    readSignals(path, options);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST(Hdf5Signals, matlabVariableWithItsRate) {
  const auto runs = readSignals(files + "matlab73.mat");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 25000, 1e-9);
  ASSERT_EQ(runs[0].signals[0].values.size(), 100u);
  for (std::size_t i = 0; i < 100; ++i) ASSERT_NEAR(runs[0].signals[0].values[i], aba(i), 1e-12);
  EXPECT_TRUE(runs[0].position.empty());
}

TEST(Hdf5Signals, matlabStructWithTimeAndSpeed) {
  SignalFileOptions options;
  for (const auto* object : {"run2", "/run2/", "run2/aba"}) {
    options.object = object;
    const auto runs = readSignals(files + "matlab73.mat", options);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_NEAR(runs[0].signals[0].values[7], 2 * aba(7), 1e-12);
    EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 25000, 1e-6);
    EXPECT_NEAR(runs[0].position[99], 99 * 28 / 25000.0, 1e-9);
  }
}

TEST(Hdf5Signals, severalRunsInOneDataset) {
  SignalFileOptions options;
  options.object = "/line/track1/aba";
  const auto runs = readSignals(files + "runs.h5", options);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].run, "aba 2");
  EXPECT_NEAR(runs[1].signals[0].values[9], 2 * 9.80665 * aba(9), 1e-4);  // stored in single precision
  EXPECT_NEAR(signals::seriesOf(runs[1]).rate(), 25000, 1e-9);
  EXPECT_EQ(runs[1].signals[0].unit, "m/s2");
  options.object = "line/track1";
  options.column = "counts";
  EXPECT_NEAR(readSignals(files + "runs.h5", options)[0].signals[0].values[10], std::trunc(100 * aba(10)), 1e-12);
}

// As measuring programs export it: the step between samples as an attribute of the channel.
TEST(Hdf5Signals, theStepOfTheSamplesIsAnAttribute) {
  const tests::TemporaryFile file("", ".h5");
  const hid_t out = H5Fcreate(file.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t count = 100, one = 1;
  const hid_t line = H5Screate_simple(1, &count, nullptr), scalar = H5Screate_simple(1, &one, nullptr);
  const hid_t data = H5Dcreate2(out, "axle box", H5T_NATIVE_DOUBLE, line, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = aba(i);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  const hid_t step = H5Acreate2(data, "wf_increment", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
  const double increment = 1 / 51200.0;
  H5Awrite(step, H5T_NATIVE_DOUBLE, &increment);
  H5Aclose(step), H5Dclose(data), H5Sclose(line), H5Sclose(scalar), H5Fclose(out);
  const auto runs = readSignals(file.path());
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 51200, 1e-6);
  EXPECT_DOUBLE_EQ(runs[0].signals[0].values[42], aba(42));
}

TEST(Hdf5Signals, badRequestsGetOneClearMessage) {
  SignalFileOptions options;
  options.object = "/mixed";
  EXPECT_THAT(complaint(files + "runs.h5", options), HasSubstr("/mixed/time: has 90 values, the signal 100"));
  options.object = "/line/track9";
  EXPECT_THAT(complaint(files + "runs.h5", options), HasSubstr("/line/track1/counts"));
  options.object = "/line/track1";
  options.column = "abba";
  EXPECT_THAT(complaint(files + "runs.h5", options), HasSubstr("no column 'abba'"));
  const tests::TemporaryFile cut("\x89HDF\r\n\x1a\n cut off", ".h5");
  EXPECT_FALSE(complaint(cut.path()).empty());
}

// A file laid out like a result of this program: /signals with time, position and several signals.
TEST(Hdf5Signals, resultFile) {
  results::ArrayTree tree;
  std::vector<double> time, position, values;
  for (std::size_t i = 0; i < 200; ++i) {
    time.push_back(static_cast<double>(i) / 25000);
    position.push_back(-0.5 + 30 * time.back());
    values.push_back(aba(i));
  }
  tree.add("/signals/time", time, "s");
  tree.add("/signals/position", position, "m");
  tree.add("/signals/aba", values, "m/s2");
  tree.add("/signals/wheel_speed", std::vector<double>(200, 65.2), "rad/s");
  tree.add("/spectra/frequency", std::vector<double>{0, 1, 2}, "Hz");
  const auto bytes = results::encodeHdf5(tree, "test");
  const tests::TemporaryFile file(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), ".h5");
  const auto runs = readSignals(file.path());
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].signals[0].values, values);
  EXPECT_TRUE(runs[0].chainage);
  EXPECT_NEAR(runs[0].position[0], -0.5, 1e-12);
  SignalFileOptions options;
  options.column = "wheel_speed";
  EXPECT_DOUBLE_EQ(readSignals(file.path(), options)[0].signals[0].values[5], 65.2);
}

// A run that was stopped half-way lacks what the defect leaves behind: features of it are of another thing.
TEST(Hdf5Signals, anIncompleteRunIsNoted) {
  const auto notesOf = [](bool complete) {
    results::ArrayTree tree;
    setAttribute(tree.attributes, "schema", std::string("squat-result"));
    setAttribute(tree.attributes, "complete", std::int64_t{complete});
    setAttribute(tree.attributes, "stop_reason", std::string(complete ? "" : "cancelled"));
    tree.add("/signals/time", std::vector<double>{0, 1, 2, 3}, "s");
    tree.add("/signals/aba", std::vector<double>{0, 1, 2, 1}, "m/s2");
    const auto bytes = results::encodeHdf5(tree, "test");
    const tests::TemporaryFile file(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), ".h5");
    return readSignals(file.path()).at(0).notes;
  };
  EXPECT_THAT(notesOf(true), ::testing::IsEmpty());
  EXPECT_THAT(notesOf(false), ::testing::ElementsAre(HasSubstr("not complete (cancelled)")));
}

// Forty samples with rate and speed beside them, as a file.
void writeSamples(const std::string& path, double rate, const char* rateUnit, double speed, const char* speedUnit) {
  results::ArrayTree tree;
  std::vector<double> values;
  for (int i = 0; i < 40; ++i) values.push_back(i % 7);
  tree.add("/aba", values, "m/s2");
  tree.add("/fs", std::vector<double>{rate}, rateUnit);
  tree.add("/speed", std::vector<double>{speed}, speedUnit);
  writeDurably(path, results::encodeHdf5(tree, path));
}

TEST(Hdf5Signals, unitsOfRateAndSpeedCount) {
  const tests::TemporaryFile file("");
  writeSamples(file.path(), 25, "kHz", 108, "km/h");
  const auto runs = readSignals(file.path());
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(signals::seriesOf(runs[0]).rate(), 25000, 1e-6);
  EXPECT_NEAR(runs[0].position[39], 39 * 30 / 25000.0, 1e-9);
}

TEST(Hdf5Signals, anUnknownUnitOfTheSpeedIsNoGuess) {
  const tests::TemporaryFile file("");
  writeSamples(file.path(), 25000, "Hz", 67, "furlong");
  EXPECT_THAT(complaint(file.path()), HasSubstr("furlong"));
}

// Samples, or samples and runs; what a third dimension would mean, nobody can guess.
TEST(Hdf5Signals, threeDimensionsAreRefused) {
  const tests::TemporaryFile path("", ".h5");
  const std::vector<double> values(24, 1.0);
  const hid_t file = H5Fcreate(path.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t shape[3] = {6, 2, 2};
  const hid_t space = H5Screate_simple(3, shape, nullptr);
  const hid_t made = H5Dcreate2(file, "aba", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(made), H5Sclose(space), H5Fclose(file);
  EXPECT_THAT(complaint(path.path()), HasSubstr("more than two dimensions"));
}

// The library clips what its reader's type cannot hold.
TEST(Hdf5Signals, signedBytesAndUnsignedWordsKeepTheirValues) {
  const tests::TemporaryFile path("");
  const std::vector<std::int8_t> bytes{-100, 5, 100};
  const std::vector<std::uint32_t> words{1, 4000000000u, 3};
  const hid_t file = H5Fcreate(path.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t count = 3;
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const auto put = [&](const char* name, hid_t type, const void* data) {
    const hid_t made = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), 0);
    H5Dclose(made);
  };
  put("bytes", H5T_NATIVE_INT8, bytes.data());
  put("words", H5T_NATIVE_UINT32, words.data());
  H5Sclose(space), H5Fclose(file);
  const auto tree = results::readHdf5(path.path());
  EXPECT_EQ(std::get<std::vector<std::int32_t>>(tree.find("/bytes")->values),
            (std::vector<std::int32_t>{-100, 5, 100}));
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(tree.find("/words")->values),
            (std::vector<std::int64_t>{1, 4000000000, 3}));
}

}  // namespace
}  // namespace squat::readers
