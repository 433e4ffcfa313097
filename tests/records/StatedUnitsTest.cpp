// What a record's headings and the call say of units, and records that contradict themselves. The control is the same
// record in SI units with brackets; all were written by hand from closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

#include "core/Errors.h"
#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::TemporaryFile;

struct Written {
  std::string time = "time [s]", position = "position [m]", speed = "speed [m/s]", signal = "aba [m/s2]";
  double perSecond = 1, perMetre = 1, perSpeed = 1, perAcceleration = 1;  // written numbers for one of SI
  double rate = 5000, start = 0;                                          // [Hz], [s]
};

std::string contentsOf(const Written& w) {
  std::string text = w.time + "," + w.position + "," + w.speed + "," + w.signal + "\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = i / w.rate;
    char row[200];
    std::snprintf(row, sizeof row, "%.7f,%.6f,%.4f,%.4f\n", (w.start + t) * w.perSecond, 30 * t * w.perMetre,
                  30 * w.perSpeed, 80 * std::sin(2000 * t) * w.perAcceleration);
    text += row;
  }
  return text;
}

WholeRecord read(const Written& written, const RecordOptions& options = {}) {
  const TemporaryFile file(contentsOf(written));
  return readWhole(file.path(), options);
}

std::string refusal(const Written& written, const RecordOptions& options = {}) {
  try {
    read(written, options);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

// Four decimals are written: an acceleration in g is off by at most 0.5e-4 g, a speed in km/h by less.
void expectTheControl(const WholeRecord& whole) {
  static const auto control = read({});
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_EQ(whole.layout.rate, control.layout.rate);
  ASSERT_EQ(whole.stretches[0].size(), control.stretches[0].size());
  for (std::size_t i = 0; i < control.stretches[0].size(); ++i) {
    ASSERT_NEAR(whole.stretches[0].values[0][i], control.stretches[0].values[0][i], 1e-3) << i;
    ASSERT_NEAR(whole.stretches[0].speed[i], 30, 0.1) << i;
  }
}

TEST(StatedUnits, InNamesAreThoseInBrackets) {
  expectTheControl(read({.time = "time_ms", .perSecond = 1e3}));
  expectTheControl(read({.time = "Zeit/ms", .perSecond = 1e3}));
  expectTheControl(read({.position = "chainage_km", .perMetre = 1e-3}));
  expectTheControl(read({.speed = "speed_kmh", .perSpeed = 3.6}));
  expectTheControl(read({.speed = "snelheid km/h", .perSpeed = 3.6}));
  expectTheControl(read({.signal = "aba_g", .perAcceleration = 1 / 9.80665}));
  expectTheControl(read({.speed = "speed [mph]", .perSpeed = 1 / 0.44704}));
}

TEST(StatedUnits, OfTheCallStandBeforeThoseOfTheFile) {
  RecordOptions options;
  options.columns.timeUnit = "ms";
  expectTheControl(read({.time = "time", .perSecond = 1e3}, options));
  options.columns.timeUnit.clear();
  options.columns.units = {{"aba", "g"}, {"speed", "km/h"}};
  expectTheControl(read({.speed = "speed", .signal = "aba", .perSpeed = 3.6, .perAcceleration = 1 / 9.80665}, options));
}

TEST(StatedUnits, ATimeWithoutAUnitIsAskedForWhereSecondsMakeNoSense) {
  EXPECT_THAT(refusal({.time = "time", .position = "remark", .perSecond = 1e3}),
              AllOf(HasSubstr("states no unit"), HasSubstr("5 Hz"), HasSubstr("--time-unit")));
  const auto whole = read({.time = "time"});
  expectTheControl(whole);
  EXPECT_THAT(whole.layout.notes, testing::Contains(HasSubstr("seconds are assumed")));
}

TEST(StatedUnits, ColumnsThatContradictEachOtherAreNamed) {
  EXPECT_THAT(refusal({.perSpeed = 3.6}),
              AllOf(HasSubstr("'speed' is 108 m/s"), HasSubstr("'position' moves at 30 m/s")));
  EXPECT_THAT(refusal({.perMetre = 1e3}), AllOf(HasSubstr("'position' moves at 30"), HasSubstr("at most 150 m/s")));
}

WholeRecord readText(const std::string& text, const RecordOptions& options = {}) {
  const TemporaryFile file(text);
  return readWhole(file.path(), options);
}

// Rows of the control: time [s] times `perSecond` and acceleration, as `format` prints them.
std::string rowsOf(const char* format, double perSecond) {
  std::string text;
  for (int i = 0; i < 4000; ++i) {
    char row[100];
    std::snprintf(row, sizeof row, format, i / 5000.0 * perSecond, 80 * std::sin(0.4 * i));
    text += row;
  }
  return text;
}

TEST(StatedUnits, AHeadingWithMoreWordsThanColumnsKeepsItsUnits) {
  RecordOptions options;
  options.columns.speed = 30;
  const auto blanks = readText("time [ms]  aba [g]\n" + rowsOf("%.4f  %.4f\n", 1e3), options);
  EXPECT_EQ(blanks.layout.rate, 5000);
  EXPECT_NEAR(blanks.stretches.at(0).values[0][4], 80 * std::sin(1.6) * 9.80665, 1e-3);
  const auto remark = readText("time [ms],aba [m/s2],remark\n" + rowsOf("%.4f,%.4f,\n", 1e3), options);
  EXPECT_EQ(remark.layout.rate, 5000);
  EXPECT_EQ(remark.layout.channels.at(0).name, "aba");
}

// A spreadsheet that has the decimal comma and parts fields by commas puts its numbers between quotes.
TEST(StatedUnits, QuotedDecimalCommasAreNumbers) {
  RecordOptions options;
  options.columns.speed = 30;
  auto rows = rowsOf("\"%.4f\",\"%.4f\"\n", 1);
  for (char& c : rows) c = c == '.' ? ',' : c;
  const auto whole = readText("\"time [s]\",\"aba [m/s2]\"\n" + rows, options);
  EXPECT_EQ(whole.layout.rate, 5000);
  EXPECT_NEAR(whole.stretches.at(0).values[0][4], 80 * std::sin(1.6), 1e-3);
}

TEST(StatedUnits, NumbersThatStandForNoneAreLeftOut) {
  RecordOptions options;
  options.columns.speed = 30;
  std::string text = "time [s],aba [m/s2]\n";
  for (int i = 0; i < 4000; ++i) {
    char row[100];
    std::snprintf(row, sizeof row, "%.4f,%.4f\n", i / 5000.0, i >= 700 && i < 740 ? -9999 : 80 * std::sin(0.4 * i));
    text += row;
  }
  const auto whole = readText(text, options);
  EXPECT_THAT(whole.layout.notes, ::testing::Contains(HasSubstr("-9999 stands for no number")));
  for (const auto& stretch : whole.stretches)
    for (const double value : stretch.values[0]) ASSERT_LE(std::abs(value), 80.01);
}

TEST(StatedUnits, CountersAndOtherSensorsAreNoAccelerations) {
  RecordOptions options;
  options.columns.speed = 30, options.everyAcceleration = true;
  options.columns.signalUnit = "m/s2";
  std::string text = "time [s],n,aba [m/s2],box,gyro_x,rate [deg/s]\n";
  for (int i = 0; i < 4000; ++i) {
    char row[140];
    const double a = 80 * std::sin(0.4 * i);
    std::snprintf(row, sizeof row, "%.4f,%d,%.4f,%.4f,%.4f,%.4f\n", i / 5000.0, i, a, 0.5 * a, 0.1 * a, 0.2 * a);
    text += row;
  }
  const auto whole = readText(text, options);
  ASSERT_EQ(whole.layout.channels.size(), 2u);
  EXPECT_EQ(whole.layout.channels[0].name, "aba");
  EXPECT_EQ(whole.layout.channels[1].name, "box");
  EXPECT_THAT(whole.layout.notes,
              ::testing::Contains(AllOf(HasSubstr("passed over"), HasSubstr("2 n"), HasSubstr("gyro_x"))));
}

// A column of dates beside one of exact times, a date above the heading, a cell that a spreadsheet took for a date.
TEST(StatedUnits, DatesDoNotTakeThePlaceOfBetterTimes) {
  RecordOptions options;
  options.columns.speed = 30;
  std::string both = "utc;time [s];aba [m/s2]\n", dated = "27.11.2026;09:30:00\ntime [s];aba [m/s2]\n";
  for (int i = 0; i < 3000; ++i) {
    char row[100];
    std::snprintf(row, sizeof row, "2026-11-27 09:30:%02d;%.7f;%.4f\n", i / 2048, i / 2048.0, 80 * std::sin(0.4 * i));
    both += row;
    dated += std::string(row).substr(20);
  }
  EXPECT_NEAR(readText(both, options).layout.rate, 2048, 0.01);
  EXPECT_NEAR(readText(dated, options).layout.rate, 2048, 0.01);
  const auto cell = dated.find(';', dated.size() / 2);
  dated.replace(cell + 1, dated.find('\n', cell) - cell - 1, "03.12.2026");
  const auto whole = readText(dated, options);
  for (const auto& stretch : whole.stretches)
    for (const double value : stretch.values[0]) ASSERT_LT(std::abs(value), 81);
}

TEST(StatedUnits, ClocksGoOnBehindMidnight) {
  RecordOptions options;
  options.columns.speed = 30;
  std::string text = "clock;aba [m/s2]\n";
  for (int i = 0; i < 4000; ++i) {
    char row[100];
    const int tenths = (86399 * 10000 + 9000 + 2 * i) % 864000000;  // of a millisecond
    std::snprintf(row, sizeof row, "%02d:%02d:%02d.%04d;%.4f\n", tenths / 36000000, tenths / 600000 % 60,
                  tenths / 10000 % 60, tenths % 10000, 80 * std::sin(0.4 * i));
    text += row;
  }
  const auto whole = readText(text, options);
  EXPECT_EQ(whole.layout.rate, 5000);
  ASSERT_EQ(whole.stretches.size(), 1u);
  EXPECT_EQ(whole.stretches[0].size(), 4000u);
  EXPECT_TRUE(whole.faults.empty());
}

TEST(StatedUnits, AHeadLineThatIsNotThereIsRefused) {
  RecordOptions options;
  options.columns.speed = 30, options.columns.headLine = 50;
  const tests::TemporaryFile file("time [s],aba [m/s2]\n0,1\n0.0001,2\n0.0002,3\n");
  EXPECT_NE(complaintAbout(file.path(), options), "");
}

// "lat" and "lon" without units: accelerations across and along, for they swing.
TEST(StatedUnits, CoordinatesDoNotSwing) {
  RecordOptions options;
  options.columns.speed = 30, options.everyAcceleration = true, options.columns.signalUnit = "m/s2";
  std::string text = "time [s],lat,lon\n";
  for (int i = 0; i < 2000; ++i) {
    char row[100];
    std::snprintf(row, sizeof row, "%.4f,%.4f,%.4f\n", i / 5000.0, 8 * std::sin(0.4 * i), 5 * std::cos(0.7 * i));
    text += row;
  }
  const auto whole = readText(text, options);
  EXPECT_FALSE(whole.layout.hasCoordinates);
  EXPECT_EQ(whole.layout.channels.size(), 2u);
}

// Every fiftieth of the rows is missing. A straight line misses the middle of a sine by 1 - cos(w dt) of its amplitude
// at most: 0.2 % at 50 Hz and 5 kHz. The rate is that of the times, and the file has as many samples as were taken.
TEST(StatedUnits, LostSamplesAreBridgedAndReported) {
  RecordOptions options;
  options.columns.speed = 30;
  options.blockLength = 512;
  std::string text = "time [s],aba [m/s2]\n";
  const auto truth = [](int i) { return 80 * std::sin(2 * 3.14159265358979 * 50 * i / 5000); };
  for (int i = 0; i < 4000; ++i) {
    char row[100];
    std::snprintf(row, sizeof row, "%.4f,%.4f\n", i / 5000.0, truth(i));
    if (i % 50 != 17) text += row;
  }
  const auto whole = readText(text, options);
  EXPECT_EQ(whole.layout.rate, 5000);
  EXPECT_THAT(whole.layout.notes, ::testing::Contains(HasSubstr("80 samples were lost")));
  EXPECT_THAT(whole.faults, IsEmpty());
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.stretches[0].size(), 4000u);
  for (int i = 0; i < 4000; ++i) ASSERT_NEAR(whole.stretches[0].values[0][i], truth(i), 0.002 * 80 + 1e-4) << i;
}

// A receiver without a fix writes 0, 0: there is no place of that name on a railway.
TEST(StatedUnits, CoordinatesWithoutAFixAreNone) {
  RecordOptions options;
  options.columns.speed = 30;
  std::string text = "time [s],latitude,longitude,aba [m/s2]\n";
  for (int i = 0; i < 4000; ++i) {
    char row[100];
    const bool fixed = i >= 1000;
    std::snprintf(row, sizeof row, "%.4f,%.7f,%.7f,%.4f\n", i / 5000.0, fixed ? 52 + 1e-7 * i : 0.0, fixed ? 5.1 : 0.0,
                  80 * std::sin(0.4 * i));
    text += row;
  }
  const auto whole = readText(text, options);
  ASSERT_EQ(whole.stretches.size(), 1u);
  for (const double latitude : whole.stretches[0].latitude) ASSERT_TRUE(std::isnan(latitude) || latitude > 51);
}

// A time since 1970 has seven digits less behind the point: 2.4e-7 s in a double. No sample of any usual rate is lost.
TEST(StatedUnits, TimesSince1970LoseNoSample) {
  for (const double rate : {20000.0, 25000.0, 25600.0, 48000.0, 50000.0, 51200.0}) {
    const auto whole = read({.rate = rate, .start = 1700000000});
    EXPECT_THAT(whole.faults, IsEmpty()) << rate;
    ASSERT_EQ(whole.stretches.size(), 1u) << rate;
    EXPECT_EQ(whole.stretches[0].size(), 4000u) << rate;
    EXPECT_NEAR(whole.layout.rate, rate, 1e-5 * rate);  // 4000 steps, ends off by 2.4e-7 s each: 6e-6 at 51.2 kHz
  }
}

}  // namespace
}  // namespace squat::records
