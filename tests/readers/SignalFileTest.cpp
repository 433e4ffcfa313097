#include "readers/SignalFile.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "core/Errors.h"
#include "readers/TemporaryFile.h"

namespace squat::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::TemporaryFile;

std::string table(const std::string& header, std::size_t n, const std::function<std::string(std::size_t)>& row) {
  std::string text = header;
  for (std::size_t i = 0; i < n; ++i) text += row(i) + "\n";
  return text;
}

std::string text(double value, int digits = 12) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

// What readSignals says of a file; empty where it is content.
std::string complaint(const std::string& content, const SignalFileOptions& options = {}) {
  const TemporaryFile file(content);
  try {
    readSignals(file.path(), options);
  } catch (const FileError& error) {
    return error.what();
  } catch (const CaseError& error) {
    return error.what();
  }
  return {};
}

signals::Record only(const std::string& content, const SignalFileOptions& options = {}) {
  const TemporaryFile file(content);
  auto runs = readSignals(file.path(), options);
  EXPECT_EQ(runs.size(), 1u);
  return runs.at(0);
}

TEST(SignalFile, timeColumnGivesTheRate) {
  const auto signal = only(table("time [ms],aba [g],speed [km/h]\n", 50, [](std::size_t i) {
    return text(100 + 0.04 * static_cast<double>(i)) + "," + text(0.1 * static_cast<double>(i)) + ",108";
  }));
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 25000, 1e-6);
  EXPECT_NEAR(signals::seriesOf(signal).start, 0.1, 1e-12);
  EXPECT_EQ(signal.signals[0].unit, "m/s2");
  EXPECT_NEAR(signal.signals[0].values[10], 9.80665, 1e-12);
  ASSERT_EQ(signal.position.size(), 50u);
  EXPECT_NEAR(signal.position[49], 49 * 30 / 25000.0, 1e-12);
  EXPECT_FALSE(signal.chainage);
  EXPECT_EQ(signal.run, "aba");
}

TEST(SignalFile, noHeaderAndDecimalComma) {
  const auto signal = only("0,0000 1,5\n0,0001 2,5\n0,0002 -3,5\n0,0003 4,5\n");
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 10000, 1e-6);
  EXPECT_THAT(signal.signals[0].values, ElementsAre(1.5, 2.5, -3.5, 4.5));
}

TEST(SignalFile, oneColumnWithTheRateGiven) {
  SignalFileOptions options;
  options.rate = 25000;
  options.speed = 30;
  const auto signal = only("1\n2\n3\n", options);
  EXPECT_EQ(signal.signals[0].values.size(), 3u);
  EXPECT_NEAR(signal.position[2], 2 * 30 / 25000.0, 1e-15);
  EXPECT_NEAR(passageWithPositions(signal).position[1], 30 / 25000.0, 1e-15);
  options.speed = 0;
  EXPECT_THROW(passageWithPositions(only("1\n2\n3\n", options)), CaseError);
  EXPECT_THAT(complaint("1\n2\n3\n"), HasSubstr("sampling rate is not known"));
}

// Chainage as km+m, falling along the run, with a constant speed: equal steps of the way are equal steps of time.
TEST(SignalFile, chainageInKilometresAndMetres) {
  SignalFileOptions options;
  options.speed = 30;
  const auto signal = only(table("km;aba\n", 40,
                                 [](std::size_t i) {
                                   const double metres = 100.0 - 0.0012 * static_cast<double>(i);
                                   return "57+" + text(metres) + ";" + text(static_cast<double>(i));
                                 }),
                           options);
  EXPECT_TRUE(signal.falling);
  EXPECT_TRUE(signal.chainage);
  EXPECT_NEAR(signal.position.front(), -57100, 1e-9);
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 25000, 0.01);
  EXPECT_FALSE(signal.notes.empty());
}

// Samples every 1.2 mm of the way while the speed rises from 24 to 36 m/s: put on equal steps of time. The signal is a
// function of the position, which must hold afterwards.
TEST(SignalFile, sampledByTheWayWithASpeedColumn) {
  const auto shape = [](double x) { return std::sin(2 * M_PI * x / 0.05); };
  const std::size_t n = 1000;
  const auto signal = only(table("position [m],speed [m/s],aba\n", n, [&](std::size_t i) {
    const double x = 0.0012 * static_cast<double>(i);
    return text(x) + "," + text(24 + 10 * x) + "," + text(shape(x));
  }));
  ASSERT_EQ(signal.signals[0].values.size(), n);
  // dt = dx/v: T = ln((24 + 10 L)/24)/10.
  EXPECT_NEAR(signals::seriesOf(signal).step * 999, std::log((24 + 10 * 1.1988) / 24) / 10, 1e-7);
  for (std::size_t i = 20; i < n - 20; i += 7)
    ASSERT_NEAR(signal.signals[0].values[i], shape(signal.position[i]), 2e-3) << i;
  const auto& x = signal.position;
  EXPECT_NEAR((x[1] - x[0]) / signals::seriesOf(signal).step, 24, 0.05);
  EXPECT_NEAR((x[998] - x[997]) / signals::seriesOf(signal).step, 36, 0.05);
}

TEST(SignalFile, coarsePositionsAreSpread) {
  const auto signal = only(table("time,position,aba\n", 100, [](std::size_t i) {
    return text(1e-3 * static_cast<double>(i)) + "," + text(std::floor(static_cast<double>(i) / 10)) + "," +
           text(static_cast<double>(i % 7));
  }));
  EXPECT_NEAR(signal.position[15], 1.5, 1e-12);
  EXPECT_NEAR(signal.position[99], 9.9, 1e-12);
  EXPECT_EQ(signal.notes.size(), 1u);
}

TEST(SignalFile, severalRuns) {
  // side by side, the second shorter
  const TemporaryFile beside("t,left,right\n0,1,4\n0.1,2,5\n0.2,3,6\n0.3,4,\n");
  SignalFileOptions options;
  options.column = "all";
  const auto columns = readSignals(beside.path(), options);
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[1].run, "right");
  EXPECT_THAT(columns[1].signals[0].values, ElementsAre(4, 5, 6));
  options.column = "2";
  EXPECT_THAT(readSignals(beside.path(), options)[0].signals[0].values, ElementsAre(1, 2, 3, 4));
  options.column = "right,left";
  EXPECT_EQ(readSignals(beside.path(), options)[1].run, "left");
  // one below the other: by a run column, and by a time that begins again
  const TemporaryFile below("run,t,aba\n3,0,1\n3,0.1,2\n3,0.2,3\n8,5,4\n8,5.1,5\n");
  const auto rows = readSignals(below.path());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].run, "aba, run 8");
  EXPECT_THAT(rows[1].signals[0].values, ElementsAre(4, 5));
  const TemporaryFile again("t,aba\n0,1\n0.1,2\n0.2,3\n0,4\n0.1,5\n0.2,6\n");
  ASSERT_EQ(readSignals(again.path()).size(), 2u);
}

// Which of two columns of one name is meant, only their numbers tell: by default and by name alike.
TEST(SignalFile, columnsOfOneNameAreToldApartByNumber) {
  const std::string twice = "t,aba,aba\n0,1,4\n0.1,2,5\n0.2,3,6\n";
  SignalFileOptions options;
  for (const auto* column : {"", "aba", "ABA"}) {
    options.column = column;
    EXPECT_THAT(complaint(twice, options), HasSubstr("'" + std::string(*column ? column : "aba") + "': 2 and 3"));
  }
  options.column = "3";
  EXPECT_THAT(only(twice, options).signals[0].values, ElementsAre(4, 5, 6));
  options.column = "Left";  // names that differ in case are two names
  EXPECT_THAT(only("t,left,Left\n0,1,4\n0.1,2,5\n0.2,3,6\n", options).signals[0].values, ElementsAre(4, 5, 6));
}

// A header in Latin-1, as older programs write it: the name comes out in UTF-8, and the unit is known.
TEST(SignalFile, namesAreUtf8WhateverTheFileIsIn) {
  const auto signal = only("t [\xB5s];Achslager \xE4u\xDF\x65ren [m/s\xB2]\n0;1\n40;2\n80;3\n");
  EXPECT_EQ(signal.run, "Achslager \xC3\xA4u\xC3\x9F\x65ren");
  EXPECT_EQ(signal.signals[0].unit, "m/s2");
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 25000, 1e-6);
  SignalFileOptions options;
  options.column = "\xC3\xA4";
  EXPECT_EQ(only("t,\xC3\xA4,b\n0,1,0\n1,2,0\n2,3,0\n", options).run, "\xC3\xA4") << "UTF-8 stays as it is";
  EXPECT_EQ(only("t,\xE4,b\n0,1,0\n1,2,0\n2,3,0\n", options).run, "\xC3\xA4");
}

TEST(SignalFile, badFilesGetOneClearMessage) {
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n0.2,3\n0.7,4\n0.8,5\n"), HasSubstr("line 5: a gap of 500 ms"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,-1e307\n0.2,3\n"), HasSubstr("line 3: 'aba' is -1e+307 here, too large"));
  EXPECT_EQ(complaint("t,aba\n0,1\n0.1,-1e99\n0.2,3\n"), "");
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,nan\n0.2,3\n"), HasSubstr("line 3: 'aba' has no number here"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,\n0.2,3\n"), HasSubstr("line 3"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,oops\n0.2,3\n"), HasSubstr("line 3"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n0.1,3\n0.2,4\n"), HasSubstr("line 4: the time does not advance"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n0.2,3\n0.15,4\n0.4,4\n"), HasSubstr("line 5: the time goes back"));
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2,7\n0.2,3\n"), HasSubstr("line 3: has 3 fields, the table 2"));
  SignalFileOptions options;
  options.column = "abba";
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n", options),
              testing::AllOf(HasSubstr("has no column 'abba'"), HasSubstr("1 t, 2 aba")));
  options.column = "7";
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n", options), HasSubstr("has no column '7'"));
  EXPECT_THAT(complaint("t,left,right\n0,1,2\n0.1,2,3\n"), HasSubstr("several columns"));
  EXPECT_THAT(complaint("t,aba\n0,1\n"), HasSubstr("at least 2"));
  EXPECT_THAT(complaint(""), HasSubstr("no table of numbers"));
  EXPECT_THAT(complaint("hello\nworld\n"), HasSubstr("no table of numbers"));
  EXPECT_THAT(complaint(std::string("PK\0\3 binary", 11)), HasSubstr("not a text file"));
  EXPECT_THAT(complaint(std::string("\xFF\xFEt\0", 4)), HasSubstr("UTF-16"));
  EXPECT_THAT(complaint("position,speed,aba\n0,30,1\n1,0,2\n2,30,3\n"), HasSubstr("line 3: the speed is 0 m/s"));
  EXPECT_THAT(complaint("t,position,aba\n0,1,1\n1,3,2\n2,2,3\n3,5,1\n"), HasSubstr("line 4: the position goes back"));
  EXPECT_THAT(complaint("t,position,aba\n0,1,1\n1,1,2\n2,1,3\n"), HasSubstr("does not change"));
  options = {};
  options.rate = -5;
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n", options), HasSubstr("rate"));
  options.rate = 10;
  EXPECT_THAT(complaint("t,aba\n0,1\n0.1,2\n0.5,3\n", options), HasSubstr("line 4: a gap"));
  EXPECT_THAT(complaint("time [s],aba [m/s2],speed [furlong]\n0,1,67\n0.1,2,67\n0.2,1,67\n"),
              testing::AllOf(HasSubstr("column 3: 'speed' is in furlong"), HasSubstr("km/h")));
  EXPECT_THAT(complaint("position [parsec],aba [g]\n0,1\n1,2\n2,1\n"), HasSubstr("'position' is in parsec"));
  EXPECT_THAT(complaint("time [moon],aba [g]\n0,1\n1,2\n2,1\n"), HasSubstr("'time' is in moon"));
  EXPECT_THAT(complaint("run,t,aba\nnorth,0,1\nnorth,0.1,2\nsouth,0,1\nsouth,0.1,2\n"),
              HasSubstr("'run' is not a number here"));
  EXPECT_THROW(readSignals("/no/such/file.csv"), FileError);
  EXPECT_THROW(readSignals("/"), FileError);
}

// Six digits of seconds at 25.6 kHz: steps of 39 and 40 us. The rate is that of the whole record.
TEST(SignalFile, roundedTimesGiveTheMeanRate) {
  const auto signal = only(table("t,aba\n", 2561, [](std::size_t i) {
    return text(std::round(1e6 * static_cast<double>(i) / 25600) / 1e6) + "," + text(static_cast<double>(i % 5));
  }));
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 25600, 0.3);  // half a microsecond in 0.1 s
}

TEST(SignalFile, aMillionSamples) {
  const std::size_t n = 1000000;
  std::string content = "time [s];aba [m/s2]\n";
  content.reserve(n * 24);
  for (std::size_t i = 0; i < n; ++i) {
    const std::string micro = std::to_string(1000000000 + 40 * i);
    content += std::to_string(i * 40 / 1000000) + "," + micro.substr(micro.size() - 6) + ";" +
               std::to_string(static_cast<int>(i % 2001) - 1000) + ",25\n";
  }
  const auto signal = only(content);
  ASSERT_EQ(signal.signals[0].values.size(), n);
  EXPECT_NEAR(signals::seriesOf(signal).rate(), 25000, 1e-6);
  EXPECT_DOUBLE_EQ(signal.signals[0].values[2], -998.25);
}

TEST(SignalFile, columnsCalledRunWithAUnitAreSignals) {
  SignalFileOptions options;
  options.column = "all";
  const TemporaryFile file(table("time [s],run 1 [m/s2],run 2 [m/s2]\n", 40, [](std::size_t i) {
    return text(1e-3 * static_cast<double>(i)) + "," + text(static_cast<double>(i % 7)) + "," +
           text(static_cast<double>(i % 5));
  }));
  const auto runs = readSignals(file.path(), options);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].signals[0].values.size(), 40u);
}

// Seconds labelled as microseconds: 1 kHz becomes 1 GHz, whose spectra would outgrow any memory.
TEST(SignalFile, anAbsurdRateIsAWrongUnit) {
  const auto said = complaint(table("time [us],aba\n", 40, [](std::size_t i) {
    return text(1e-3 * static_cast<double>(i)) + "," + text(static_cast<double>(i % 7));
  }));
  EXPECT_THAT(said, HasSubstr("check the unit of time"));
}

// A pipe that nobody writes into is refused, not waited for.
TEST(SignalFile, aPipeIsNoFile) {
  const TemporaryFile beside("x");
  const std::string pipe = beside.path() + ".pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(readSignals(pipe), FileError);
  ::unlink(pipe.c_str());
}

}  // namespace
}  // namespace squat::readers
