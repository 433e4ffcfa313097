// Expected numbers: what the bytes were made from, worked out by hand.
#include "loggers/TdmsFile.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "core/Errors.h"
#include "loggers/TdmsBytes.h"

namespace squat::loggers {
namespace {

using tdms::bytes, tdms::index, tdms::object, tdms::property, tdms::segment, tdms::values;
using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;
using TdmsInts = std::vector<std::int32_t>;
using TdmsDoubles = std::vector<double>;

// 2026-11-27 09:30:00 UTC is 20784 days and 34200 s after 1970, that is 2082844800 s after 1904.
constexpr std::int64_t tdmsMorning = 2082844800 + std::int64_t{20784} * 86400 + 34200;
constexpr std::uint64_t tdmsQuarter = std::uint64_t{1} << 62;  // [2^-64 s]

LoggerTable tdmsParsed(const std::string& file, const std::string& group = "") {
  return parseTdms(file, "a.tdms", group);
}

std::string tdmsErrorOf(const std::string& file, const std::string& group = "") {
  try {
    tdmsParsed(file, group);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

std::string tdmsTwoChannels(std::uint32_t flags = tdms::first) {
  return segment(flags, {object("/'g'/'a'", index(tdms::i32, 2)), object("/'g'/'b'", index(tdms::i32, 2))},
                 values(TdmsInts{1, 2, 3, 4}));
}

std::string tdmsOneChannel(const std::vector<std::string>& properties) {
  return segment(tdms::first, {object("/'g'/'a'", index(tdms::i16, 3), properties)},
                 values(std::vector<std::int16_t>{1, 2, 3}));
}

TEST(TdmsFile, isKnownByItsHead) {
  EXPECT_TRUE(isTdmsFile(tdmsTwoChannels()));
  EXPECT_FALSE(isTdmsFile("TDS"));
  EXPECT_FALSE(isTdmsFile("time;a"));
}

TEST(TdmsFile, rateUnitAndName) {
  const auto read =
      tdmsParsed(tdmsOneChannel({property("wf_increment", 1.0 / 25600), property("unit_string", " m/s2 ")}));
  ASSERT_EQ(read.table.columns.size(), 1u);
  EXPECT_EQ(read.table.columns[0].name, "a");
  EXPECT_EQ(read.table.columns[0].unit, "m/s2");
  EXPECT_DOUBLE_EQ(read.rate, 25600);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, 2, 3));
  EXPECT_THAT(read.table.lines, ElementsAre(1, 2, 3));
  EXPECT_EQ(read.table.rowWord, "sample");
  EXPECT_EQ(read.table.path, "a.tdms");
  EXPECT_THAT(read.notes, IsEmpty());
}

TEST(TdmsFile, marksInNames) {
  const auto read =
      tdmsParsed(segment(tdms::first, {object("/'Dr. T''s'/'a/''b'", index(tdms::u8, 1))}, "\x07"), "Dr. T's");
  EXPECT_EQ(read.table.columns[0].name, "a/'b");
}

// Several chunks, a segment of values alone, one whose objects are "as before", one that changes one length.
TEST(TdmsFile, metaDataThatBuildUponEachOther) {
  std::string file = segment(tdms::first,
                             {object("/", tdms::noValues()), object("/'g'", tdms::noValues()),
                              object("/'g'/'a'", index(tdms::i32, 2)), object("/'g'/'b'", index(tdms::i32, 2))},
                             values(TdmsInts{1, 2, 11, 12, 3, 4, 13, 14}));
  file += segment(tdms::rawData, {}, values(TdmsInts{5, 6, 15, 16}));
  file += segment(tdms::first, {object("/'g'/'b'", tdms::asBefore()), object("/'g'/'a'", tdms::asBefore())},
                  values(TdmsInts{17, 18, 7, 8}));
  file +=
      segment(tdms::metaData | tdms::rawData, {object("/'g'/'a'", index(tdms::i32, 1))}, values(TdmsInts{19, 20, 9}));
  file += segment(tdms::metaData | tdms::rawData, {object("/'g'/'b'", tdms::noValues())}, values(TdmsInts{10}));
  file +=
      segment(tdms::metaData, {object("/'g'/'a'", tdms::noValues(), {property("unit_string", std::string("g"))})}, "");
  const auto read = tdmsParsed(file);
  ASSERT_EQ(read.table.columns.size(), 2u);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(11, 12, 13, 14, 15, 16, 17, 18, 19, 20));
  EXPECT_EQ(read.table.columns[0].unit, "g");
}

TEST(TdmsFile, interleavedOfDifferentWidth) {
  std::string rows;
  for (int i = 1; i <= 5; ++i)
    rows += bytes(static_cast<std::int8_t>(-i)) + bytes(0.5 * i) + bytes(static_cast<std::uint16_t>(60000 + i));
  const auto read = tdmsParsed(segment(tdms::first | tdms::interleaved,
                                       {object("/'g'/'a'", index(tdms::i8, 2)), object("/'g'/'b'", index(tdms::f64, 2)),
                                        object("/'g'/'c'", index(tdms::u16, 2))},
                                       rows));
  ASSERT_EQ(read.table.columns.size(), 3u);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(-1, -2, -3, -4, -5));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(0.5, 1, 1.5, 2, 2.5));
  EXPECT_THAT(read.table.columns[2].values, ElementsAre(60001, 60002, 60003, 60004, 60005));
}

TEST(TdmsFile, bigEndian) {
  const std::string file =
      segment(tdms::first | tdms::bigEndian,
              {object("/'g'/'a'", index(tdms::i32, 2, true), {property("wf_increment", 0.5, true)}, true),
               object("/'g'/'t'", index(tdms::stamp, 2, true), {}, true)},
              values(TdmsInts{-258, 70000}, true) + tdms::moment(tdmsMorning, 0, true) +
                  tdms::moment(tdmsMorning, tdmsQuarter, true));
  const auto read = tdmsParsed(file);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(-258, 70000));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(0, 0.25));
  EXPECT_EQ(read.rate, 2);
}

template <typename T>
void expectTdmsExtremes(std::uint32_t type) {
  const std::vector<T> extremes{std::numeric_limits<T>::lowest(), T{1}, std::numeric_limits<T>::max()};
  for (const bool big : {false, true}) {
    const auto read = tdmsParsed(segment(tdms::first | (big ? tdms::bigEndian : 0),
                                         {object("/'g'/'a'", index(type, 3, big), {}, big)}, values(extremes, big)));
    EXPECT_THAT(read.table.columns[0].values,
                ElementsAre(static_cast<double>(extremes[0]), 1, static_cast<double>(extremes[2])));
  }
}

TEST(TdmsFile, everyTypeOfNumber) {
  expectTdmsExtremes<std::int8_t>(tdms::i8);
  expectTdmsExtremes<std::int16_t>(tdms::i16);
  expectTdmsExtremes<std::int32_t>(tdms::i32);
  expectTdmsExtremes<std::int64_t>(tdms::i64);
  expectTdmsExtremes<std::uint8_t>(tdms::u8);
  expectTdmsExtremes<std::uint16_t>(tdms::u16);
  expectTdmsExtremes<std::uint32_t>(tdms::u32);
  expectTdmsExtremes<std::uint64_t>(tdms::u64);
  expectTdmsExtremes<float>(tdms::f32);
  expectTdmsExtremes<double>(tdms::f64);
  expectTdmsExtremes<float>(tdms::f32Unit);
  expectTdmsExtremes<double>(tdms::f64Unit);
}

TEST(TdmsFile, notANumberIsNoted) {
  const auto read = tdmsParsed(segment(tdms::first, {object("/'g'/'a'", index(tdms::f64, 3))},
                                       values(TdmsDoubles{1, std::numeric_limits<double>::infinity(), std::nan("")})));
  const auto& column = read.table.columns[0];
  EXPECT_TRUE(std::isnan(column.values[1]) && std::isnan(column.values[2]));
  EXPECT_EQ(column.badRow, 1u);
  EXPECT_EQ(column.badText, "infinity");
}

// 51.2 kHz a century after the epoch: a double of the whole date would be off by up to 0.24 us.
TEST(TdmsFile, timeStampsKeepTheirPrecision) {
  const auto step = static_cast<std::uint64_t>(std::ldexp(1.0 / 51200, 64));
  const auto read = tdmsParsed(segment(tdms::first, {object("/'g'/'t'", index(tdms::stamp, 3))},
                                       tdms::moment(tdmsMorning, std::uint64_t{0} - step) +
                                           tdms::moment(tdmsMorning + 1, 0) + tdms::moment(tdmsMorning + 1, step)));
  const auto& column = read.table.columns[0];
  EXPECT_EQ(column.values[0], 0);
  EXPECT_NEAR(column.values[1], 1.0 / 51200, 1e-15);
  EXPECT_NEAR(column.values[2], 2.0 / 51200, 1e-15);
  EXPECT_EQ(column.unit, "s");
  EXPECT_EQ(column.moments, text::MomentKind::dateTime);
  EXPECT_EQ(read.rate, 0);
  EXPECT_THAT(read.notes, ElementsAre("'t' counts from 2026-11-27 09:30:00.999980 UTC"));
}

TEST(TdmsFile, startIsNoted) {
  const auto read = tdmsParsed(tdmsOneChannel({property("wf_increment", 0.001), property("wf_start_offset", 1.5),
                                               tdms::momentProperty("wf_start_time", tdmsMorning, tdmsQuarter)}));
  EXPECT_THAT(read.notes,
              ElementsAre("recorded from 2026-11-27 09:30:00.250000 UTC on, the first sample 1.5 s after that"));
}

TEST(TdmsFile, anotherStartIsNoted) {
  const auto start = [](std::int64_t seconds) {
    return std::vector{property("wf_increment", 0.001), tdms::momentProperty("wf_start_time", seconds, 0)};
  };
  const auto read = tdmsParsed(segment(tdms::first,
                                       {object("/'g'/'a'", index(tdms::u8, 1), start(tdmsMorning)),
                                        object("/'g'/'b'", index(tdms::u8, 1), start(tdmsMorning + 1))},
                                       "\x01\x02"));
  EXPECT_EQ(read.table.columns.size(), 2u);
  EXPECT_THAT(read.notes, Contains(HasSubstr("'b' began at another time")));
}

TEST(TdmsFile, linearScale) {
  const std::vector<std::string> scale{property("NI_Scaling_Status", std::string("unscaled")),
                                       property("NI_Number_Of_Scales", 1U),
                                       property("NI_Scale[0]_Scale_Type", std::string("Linear")),
                                       property("NI_Scale[0]_Linear_Slope", 2.0),
                                       property("NI_Scale[0]_Linear_Y_Intercept", 10.0),
                                       property("NI_Scale[0]_Linear_Input_Source", 0xFFFFFFFFU)};
  EXPECT_THAT(tdmsParsed(tdmsOneChannel(scale)).table.columns[0].values, ElementsAre(12, 14, 16));
  auto scaled = scale;
  scaled[0] = property("NI_Scaling_Status", std::string("scaled"));
  EXPECT_THAT(tdmsParsed(tdmsOneChannel(scaled)).table.columns[0].values, ElementsAre(1, 2, 3));
  // The same properties of the group hold for its channels.
  const auto ofGroup =
      segment(tdms::first, {object("/'g'", tdms::noValues(), scale), object("/'g'/'a'", index(tdms::u8, 1))}, "\x04");
  EXPECT_THAT(tdmsParsed(ofGroup).table.columns[0].values, ElementsAre(18));
}

// First 3 x + 1, then 1 + 2 y + y^2 of that: 25, 64 and 121 from 1, 2 and 3. The scale between is not on the way.
TEST(TdmsFile, scalesUponEachOther) {
  const auto read = tdmsParsed(tdmsOneChannel(
      {property("NI_Number_Of_Scales", 3U), property("NI_Scale[0]_Scale_Type", std::string("Linear")),
       property("NI_Scale[0]_Linear_Slope", 3.0), property("NI_Scale[0]_Linear_Y_Intercept", 1.0),
       property("NI_Scale[1]_Scale_Type", std::string("Thermocouple")),
       property("NI_Scale[2]_Scale_Type", std::string("Polynomial")),
       property("NI_Scale[2]_Polynomial_Coefficients_Size", 3U),
       property("NI_Scale[2]_Polynomial_Coefficients[0]", 1.0), property("NI_Scale[2]_Polynomial_Coefficients[1]", 2.0),
       property("NI_Scale[2]_Polynomial_Coefficients[2]", 1.0), property("NI_Scale[2]_Polynomial_Input_Source", 0U)}));
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(25, 64, 121));
}

TEST(TdmsFile, otherScalesAreNamed) {
  const std::vector<std::string> scale{property("NI_Number_Of_Scales", 1U),
                                       property("NI_Scale[0]_Scale_Type", std::string("RTD"))};
  EXPECT_THAT(tdmsErrorOf(tdmsOneChannel(scale)), HasSubstr("its scale 0 is of the type 'RTD'"));
  const auto read = tdmsParsed(
      segment(tdms::first, {object("/'g'/'a'", index(tdms::u8, 1), scale), object("/'g'/'b'", index(tdms::u8, 1))},
              "\x01\x02"));
  ASSERT_EQ(read.table.columns.size(), 1u);
  EXPECT_EQ(read.table.columns[0].name, "b");
  EXPECT_THAT(read.notes, Contains(HasSubstr("left out (its scale 0 is of the type 'RTD'")));
}

TEST(TdmsFile, scalesInACircle) {
  EXPECT_THAT(tdmsErrorOf(tdmsOneChannel(
                  {property("NI_Number_Of_Scales", 1U), property("NI_Scale[0]_Scale_Type", std::string("Linear")),
                   property("NI_Scale[0]_Linear_Slope", 3.0), property("NI_Scale[0]_Linear_Y_Intercept", 1.0),
                   property("NI_Scale[0]_Linear_Input_Source", 0U)})),
              HasSubstr("do not lead to its values"));
}

// Four channels of 100 Hz, one of 10 Hz with as many samples, one shorter, one of text; and a time without a rate.
TEST(TdmsFile, channelsThatDiffer) {
  const std::vector<std::string> fast{property("wf_increment", 0.01)}, slow{property("wf_increment", 0.1)};
  const auto read = tdmsParsed(
      segment(tdms::first,
              {object("/'g'/'slow'", index(tdms::u8, 2), slow), object("/'g'/'Time'", index(tdms::u8, 2)),
               object("/'g'/'a'", index(tdms::u8, 2), fast), object("/'g'/'b'", index(tdms::u8, 2), fast),
               object("/'g'/'short'", index(tdms::u8, 1), fast), object("/'g'/'remark'", tdms::textIndex(1, 9)),
               object("/'g'/'c'", index(tdms::complex, 1)), object("/'g'/'empty'", tdms::noValues())},
              std::string("\x01\x02\x03\x04\x05\x06\x07\x08\x09") + bytes(5U) + "start" + std::string(16, 'c')));
  ASSERT_EQ(read.table.columns.size(), 3u);
  EXPECT_EQ(read.table.columns[0].name, "Time");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(3, 4));
  EXPECT_THAT(read.table.columns[2].values, ElementsAre(7, 8));
  EXPECT_DOUBLE_EQ(read.rate, 100);
  EXPECT_THAT(read.notes, Contains("left out (of another length): 'short'"));
  EXPECT_THAT(read.notes, Contains("left out (of another rate): 'slow'"));
  EXPECT_THAT(read.notes, Contains("left out (it holds text): 'remark'"));
  EXPECT_THAT(read.notes, Contains("left out (it holds complex numbers): 'c'"));
  EXPECT_THAT(read.notes, Contains("left out (it has no values): 'empty'"));
}

TEST(TdmsFile, incrementInAnotherUnit) {
  EXPECT_DOUBLE_EQ(
      tdmsParsed(tdmsOneChannel({property("wf_increment", 0.5), property("wf_xunit_string", std::string("ms"))})).rate,
      2000);
  EXPECT_EQ(
      tdmsParsed(tdmsOneChannel({property("wf_increment", 0.5), property("wf_xunit_string", std::string("Hz"))})).rate,
      0);
  EXPECT_EQ(tdmsParsed(tdmsOneChannel({property("wf_increment", 0.0)})).rate, 0);
}

TEST(TdmsFile, groups) {
  const auto file =
      segment(tdms::first, {object("/'short'/'a'", index(tdms::u8, 1)), object("/'long'/'b'", index(tdms::u8, 2))},
              "\x01\x02\x03");
  const auto longest = tdmsParsed(file);
  EXPECT_EQ(longest.table.columns[0].name, "b");
  EXPECT_THAT(longest.notes, Contains(HasSubstr("the group 'long' is read")));
  EXPECT_THAT(tdmsParsed(file, "short").table.columns[0].values, ElementsAre(1));
  EXPECT_THAT(tdmsParsed(file, "short").notes, IsEmpty());
  EXPECT_THAT(tdmsErrorOf(file, "other"), HasSubstr("Groups of the file: 'long', 'short'"));
}

TEST(TdmsFile, segmentThatWasNotClosed) {
  const std::vector<std::string> a{object("/'g'/'a'", index(tdms::i32, 2)), object("/'g'/'b'", index(tdms::i32, 2))};
  const auto read = tdmsParsed(tdmsTwoChannels() + segment(tdms::first, a, values(TdmsInts{5, 6, 7, 8, 9, 10}), false));
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, 2, 5, 6));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(3, 4, 7, 8));
  EXPECT_THAT(read.notes, ElementsAre("the recording was not closed; it is read as far as it is whole",
                                      "8 bytes that do not fill a whole block are left out"));
  const auto rows =
      tdmsParsed(segment(tdms::first | tdms::interleaved, a, values(TdmsInts{1, 2, 3, 4, 5}) + "x", false));
  EXPECT_THAT(rows.table.columns[0].values, ElementsAre(1, 3));
  EXPECT_THAT(rows.table.columns[1].values, ElementsAre(2, 4));
  // Not even the meta data of the second segment were written.
  const std::string second = segment(tdms::first, a, "", false);
  EXPECT_THAT(tdmsParsed(tdmsTwoChannels() + second.substr(0, second.size() - 9)).table.columns[0].values,
              ElementsAre(1, 2));
}

// A closed segment may end within a chunk, with the same share of each channel.
TEST(TdmsFile, lastChunkIsSmaller) {
  const auto read = tdmsParsed(
      segment(tdms::first, {object("/'g'/'a'", index(tdms::i32, 2)), object("/'g'/'b'", index(tdms::i32, 2))},
              values(TdmsInts{1, 2, 3, 4, 5, 6})));
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(1, 2, 5));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(3, 4, 6));
  EXPECT_THAT(read.notes, IsEmpty());
}

// Two cards of 16 and 32 bits; the volts per bit stand in scale 1, whose input is the card's scaler 0.
TEST(TdmsFile, daqmx) {
  const std::vector<std::string> scale{
      property("NI_Number_Of_Scales", 2U), property("NI_Scale[1]_Scale_Type", std::string("Linear")),
      property("NI_Scale[1]_Linear_Slope", 0.5), property("NI_Scale[1]_Linear_Y_Intercept", 0.0),
      property("NI_Scale[1]_Linear_Input_Source", 0U)};
  const std::vector<std::uint32_t> widths{4, 4};
  const std::vector<std::string> objects{object("/'g'/'a'", tdms::cardIndex(2, {{3, 0, 0, 0}}, widths), scale),
                                         object("/'g'/'b'", tdms::cardIndex(2, {{2, 0, 2, 0}}, widths)),
                                         object("/'g'/'c'", tdms::cardIndex(2, {{5, 1, 0, 0}}, widths))};
  const auto row = [](std::int16_t a, std::uint16_t b) { return bytes(a) + bytes(b); };
  const std::string raw =
      row(-1, 65535) + row(2, 3) + values(TdmsInts{-7, 8}) + row(3, 5) + row(4, 6) + values(TdmsInts{9, 10});
  const auto read = tdmsParsed(segment(tdms::first | tdms::daqmx, objects, raw));
  ASSERT_EQ(read.table.columns.size(), 3u);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(-0.5, 1, 1.5, 2));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(65535, 3, 5, 6));
  EXPECT_THAT(read.table.columns[2].values, ElementsAre(-7, 8, 9, 10));
}

TEST(TdmsFile, daqmxOfSeveralScalersIsNamed) {
  const auto file = segment(tdms::first | tdms::daqmx,
                            {object("/'g'/'a'", tdms::cardIndex(1, {{3, 0, 0, 0}, {3, 0, 2, 1}}, {4}))}, "abcd");
  EXPECT_THAT(tdmsErrorOf(file), HasSubstr("it has several DAQmx scalers"));
}

TEST(TdmsFile, damageIsNamed) {
  const std::string good = tdmsTwoChannels();
  EXPECT_THAT(tdmsErrorOf(""), HasSubstr("is not a TDMS file"));
  EXPECT_THAT(tdmsErrorOf("TDSh" + good.substr(4)), HasSubstr("is the index of a TDMS file"));
  EXPECT_THAT(tdmsErrorOf(good.substr(0, good.size() - 3)), HasSubstr("cut off: 3 bytes"));
  EXPECT_THAT(tdmsErrorOf(good + good.substr(0, 20)), HasSubstr("cut off here"));
  EXPECT_THAT(tdmsErrorOf(good + "TDS?" + good.substr(4)), HasSubstr("no segment begins where one should"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::first, {}, "", true, 5000)), HasSubstr("version 5000"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::first, {object("/'g'/'a'", tdms::asBefore())}, "")), HasSubstr("never was"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::first, {object("g/a", tdms::noValues())}, "")), HasSubstr("not the path"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::rawData, {}, "abcd")), HasSubstr("belong to no channel"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::first, {object("/'g'/'a'", index(11, 1))}, "")), HasSubstr("type 11"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::first, {object("/'g'/'a'", index(tdms::f64, std::uint64_t{1} << 62))}, "")),
              HasSubstr("damaged here"));
  EXPECT_THAT(
      tdmsErrorOf(segment(tdms::first | tdms::interleaved,
                          {object("/'g'/'a'", index(tdms::u8, 1)), object("/'g'/'b'", index(tdms::u8, 2))}, "abc")),
      HasSubstr("different lengths"));
  EXPECT_THAT(tdmsErrorOf(segment(tdms::metaData | tdms::newList, {object("/'g'/'a'", index(tdms::u8, 1))}, "")),
              HasSubstr("it has no values"));
}

// Wherever a file ends, the error says so or what is read is whole.
TEST(TdmsFile, cutAnywhere) {
  const std::string file = tdmsTwoChannels() + tdmsTwoChannels(tdms::rawData);
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_EQ(tdmsErrorOf(file.substr(0, size)) == "no error", size == tdmsTwoChannels().size()) << size;
}

TEST(TdmsFile, fromAFile) {
  const std::string path = testing::TempDir() + "squatTdmsFileTest.tdms";
  std::ofstream(path, std::ios::binary) << tdmsTwoChannels();
  EXPECT_EQ(readTdmsFile(path, "").table.columns.size(), 2u);
  std::remove(path.c_str());
  EXPECT_THROW(readTdmsFile(path, ""), FileError);
}

}  // namespace
}  // namespace squat::loggers
