// A ride in several files is the ride in one, sample by sample; passes stay apart; where neither is known, it is asked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using testing::HasSubstr;

constexpr int rideSamples = 3000;
constexpr double rideRate = 5000, rideSpeed = 30;  // [Hz], [m/s]

enum class Clock { stated, restarting, none, dates };

struct RideForm {
  Clock clock = Clock::stated;
  bool positions = true, headings = true;
  std::vector<std::string> names{"part-1.csv", "part-2.csv", "part-10.csv"};
};

double accelerationAt(int i) { return 80 * std::sin(0.4 * i); }

class Ride : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string timeText(const RideForm& form, int i, int first) {
    char text[64];
    const double t = (form.clock == Clock::restarting ? i - first : i) / rideRate;
    if (form.clock == Clock::dates)
      std::snprintf(text, sizeof text, "27.11.2026 09:59:59,%04d", i % 5000);  // below one second
    else
      std::snprintf(text, sizeof text, "%.4f", t);
    return text;
  }

  std::string write(const RideForm& form, const std::string& name, int first, int end, bool heading) {
    std::ofstream out(folder_ / name);
    const bool time = form.clock != Clock::none;
    if (heading)
      out << (time ? form.clock == Clock::dates ? "Zeit;" : "time [s];" : "") << (form.positions ? "position [m];" : "")
          << "aba [m/s2]\n";
    char text[96];
    for (int i = first; i < end; ++i) {
      if (time) out << timeText(form, i, first) << ';';
      if (form.positions) {
        std::snprintf(text, sizeof text, "%.6f;", 100 + rideSpeed * i / rideRate);
        out << text;
      }
      std::snprintf(text, sizeof text, "%.9f\n", accelerationAt(i));
      out << text;
    }
    return (folder_ / name).string();
  }

  std::vector<std::string> split(const RideForm& form) {
    std::vector<std::string> files;
    for (int part = 0; part < 3; ++part)
      files.push_back(write(form, form.names[static_cast<std::size_t>(part)], part * rideSamples / 3,
                            (part + 1) * rideSamples / 3, part == 0 || form.headings));
    return files;
  }

  static RecordOptions options() {
    RecordOptions read;
    read.columns.speed = rideSpeed, read.columns.rate = rideRate;
    return read;
  }

  static RecordOptions withoutRate() {
    auto read = options();
    read.columns.rate = 0;
    return read;
  }

  // The first ride of the files, whole.
  static void expectWholeRide(const std::vector<std::string>& files, const RecordOptions& read, Together together,
                              double start = 0) {
    const auto stream = openRide(inNumberOrder(files), read, together);
    RecordBlock block;
    int i = 0;
    while (stream->next(block)) {
      EXPECT_EQ(block.follows, i > 0);
      EXPECT_NEAR(block.time, start + i / rideRate, 1e-6);
      for (std::size_t k = 0; k < block.size(); ++k, ++i) ASSERT_NEAR(block.values[0][k], accelerationAt(i), 1e-9) << i;
    }
    EXPECT_EQ(i, rideSamples);
    EXPECT_EQ(stream->layout().files.size(), 3u);
    EXPECT_THAT(stream->layout().notes, testing::Contains(HasSubstr("3 files are read as one ride")));
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("squat-rides-" + std::to_string(::getpid()));
};

TEST_F(Ride, ContinuesWhereTimesFollowOn) { expectWholeRide(split({}), withoutRate(), Together::asTheyFollow); }

TEST_F(Ride, ContinuesInFilesWithoutHeadings) {
  RideForm form;
  form.headings = false;
  expectWholeRide(split(form), withoutRate(), Together::asTheyFollow);
}

TEST_F(Ride, ContinuesWhereDatesFollowOn) {
  RideForm form;
  form.clock = Clock::dates;
  constexpr double start = 86400.0 * (56 * 365 + 14 + 330) + 35999;  // 2026-11-27 09:59:59
  expectWholeRide(split(form), withoutRate(), Together::asTheyFollow, start);
}

TEST_F(Ride, ContinuesWherePositionsFollowOnAndClocksStartAgain) {
  RideForm form;
  form.clock = Clock::restarting;
  expectWholeRide(split(form), withoutRate(), Together::asTheyFollow);
}

TEST_F(Ride, ContinuesWherePositionsFollowOnWithoutTimes) {
  RideForm form;
  form.clock = Clock::none;
  expectWholeRide(split(form), options(), Together::asTheyFollow);
}

TEST_F(Ride, ContinuesWhereTheCallSaysSo) {
  RideForm form;
  form.clock = Clock::restarting, form.positions = false;
  expectWholeRide(split(form), withoutRate(), Together::consecutive);
}

TEST_F(Ride, IsAskedForWhereOnlyNamesFollowOn) {
  RideForm form;
  form.clock = Clock::restarting, form.positions = false;
  const auto stream = openRide(inNumberOrder(split(form)), withoutRate(), Together::asTheyFollow);
  RecordBlock block;
  try {
    while (stream->next(block)) continue;
    FAIL() << "one ride or passes, without a word";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--consecutive"));
  }
}

TEST_F(Ride, EndsBeforeTheNextPass) {
  RideForm form;
  form.clock = Clock::restarting;
  const std::vector<std::string> files{write(form, "pass-1.csv", 0, 1000, true),
                                       write(form, "pass-2.csv", 0, 1000, true)};
  const auto stream = openRide(files, withoutRate(), Together::asTheyFollow);
  RecordBlock block;
  std::size_t samples = 0;
  while (stream->next(block)) samples += block.size();
  EXPECT_EQ(samples, 1000u);
  EXPECT_EQ(stream->layout().files, std::vector<std::string>{files[0]});
}

TEST_F(Ride, EndsWhereTheTrainTurns) {
  RideForm form;
  form.clock = Clock::restarting;
  const auto there = write(form, "there.csv", 0, 1000, true);
  std::ofstream out(folder_ / "back.csv");
  out << "time [s];position [m];aba [m/s2]\n";
  for (int i = 0; i < 1000; ++i)
    out << i / rideRate << ';' << 100 + rideSpeed * (1000 - i) / rideRate << ';' << accelerationAt(i) << '\n';
  out.close();
  const auto stream = openRide({there, (folder_ / "back.csv").string()}, withoutRate(), Together::asTheyFollow);
  RecordBlock block;
  while (stream->next(block)) continue;
  EXPECT_EQ(stream->layout().files.size(), 1u);
}

TEST_F(Ride, RefusesPartsInOtherUnits) {
  const auto first = write({}, "part-1.csv", 0, 1000, true);
  std::ofstream out(folder_ / "part-2.csv");
  out << "time [s];position [m];aba [g]\n";
  for (int i = 1000; i < 2000; ++i)
    out << i / rideRate << ';' << 100 + rideSpeed * i / rideRate << ';' << accelerationAt(i) / 9.80665 << '\n';
  out.close();
  const auto stream = openRide({first, (folder_ / "part-2.csv").string()}, withoutRate(), Together::asTheyFollow);
  RecordBlock block;
  EXPECT_THROW(while (stream->next(block)) continue, FileError);
}

TEST_F(Ride, RefusesFilesInWrongOrder) {
  const auto files = split({});
  const auto stream = openRide({files[1], files[0]}, withoutRate(), Together::consecutive);
  RecordBlock block;
  EXPECT_THROW(while (stream->next(block)) continue, FileError);
}

TEST_F(Ride, IsInTheOrderOfItsNumbers) {
  EXPECT_EQ(inNumberOrder({"a/part-10.csv", "a/part-2.csv", "a/part-1.csv"}),
            (std::vector<std::string>{"a/part-1.csv", "a/part-2.csv", "a/part-10.csv"}));
  EXPECT_EQ(inNumberOrder({"b.csv", "a.csv"}), (std::vector<std::string>{"b.csv", "a.csv"}));
}

}  // namespace
}  // namespace squat::records
