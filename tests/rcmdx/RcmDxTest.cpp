// Reading recordings in the layout of the RCM-DX specification.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "rcmdx/RecordColumns.h"
#include "rcmdx/SampleRecording.h"
#include "rcmdx/UnitWords.h"
#include "readers/TemporaryFile.h"

namespace squat::rcmdx {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::PlainHdf5;
using tests::SampleRecording;
using tests::TemporaryFile;

std::string complaintOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

RecordColumns columnsOf(const std::string& path, const RecordChoice& choice = {}) {
  return recordColumns(path, listRcmDx(path), choice);
}

const std::vector<double>& valuesOf(const text::DelimitedTable& table, const std::string& name) {
  for (const auto& column : table.columns)
    if (column.name == name) return column.values;
  static const std::vector<double> none;
  ADD_FAILURE() << "no column " << name;
  return none;
}

TEST(RcmDx, aListingSaysWhatARecordingHolds) {
  for (const bool prefixed : {false, true}) {
    const TemporaryFile file("", ".rcmdx");
    SampleRecording sample;
    sample.prefixed = prefixed;
    sample.write(file.path());
    EXPECT_TRUE(isRcmDx(file.path()));
    const auto recording = readRcmDx(file.path());
    EXPECT_EQ(recording.major, 2);
    EXPECT_EQ(recording.minor, 0);
    EXPECT_EQ(recording.feature, 4);
    ASSERT_EQ(recording.sessions.size(), 1u);
    const auto& session = recording.sessions[0];
    EXPECT_EQ(session.name, "20190322_064459.123");
    EXPECT_EQ(session.platform, "DFZ01");
    EXPECT_EQ(session.vehicleNumber, "99 85 9160001-2");
    EXPECT_EQ(session.start, SampleRecording::start - 5000);
    EXPECT_EQ(session.end, SampleRecording::time(SampleRecording::samples));
    ASSERT_EQ(session.sources.size(), 2u);
    const auto& source = session.sources[0];
    EXPECT_EQ(source.name, "FAST");
    EXPECT_EQ(source.system, "DFZ01.ABA");
    EXPECT_EQ(source.samples, SampleRecording::samples);
    ASSERT_EQ(source.channels.size(), 3u);
    const auto& channel = source.channels[0];
    EXPECT_EQ(channel.name, "ABA_LEFT");
    EXPECT_EQ(channel.unit, "m/s2");
    EXPECT_EQ(channel.basis, "MOVE_DIRECTION_VERTICAL_LEFT");
    EXPECT_EQ(channel.triggerMode, "TIME");
    EXPECT_EQ(channel.frequency, 25000);
    EXPECT_EQ(channel.positionOffset, 1.5);
    ASSERT_TRUE(session.position.has_value());
    EXPECT_EQ(session.position->samples, SampleRecording::samples / 500 + 1);
    EXPECT_FALSE(session.position->kilometrage.empty());
  }
}

TEST(RcmDx, theFastestAccelerationsWithTheirTimesAndPositions) {
  for (const bool prefixed : {false, true}) {
    const TemporaryFile file("", ".rcmdx");
    SampleRecording sample;
    sample.prefixed = prefixed;
    sample.write(file.path());
    const auto columns = columnsOf(file.path());
    EXPECT_EQ(columns.start(), SampleRecording::start);
    EXPECT_EQ(columns.source().name, "FAST");
    EXPECT_THAT(columns.notes(), ::testing::Contains(HasSubstr("passed over")));
    EXPECT_THAT(columns.notes(), ::testing::Contains(HasSubstr("line 710 (Olten - Bern)")));
    EXPECT_THAT(columns.notes(), ::testing::Contains(HasSubstr("1.5 m from the vehicle's zero point")));
    const auto table = columns.read();
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.push_back(column.name + " [" + column.unit + "]");
    ASSERT_THAT(names, ElementsAre("time [s]", "position [m]", "ABA_LEFT [m/s2]", "ABA_RIGHT [m/s2]"));
    ASSERT_EQ(table.rows(), SampleRecording::samples);
    const auto &time = table.columns[0].values, &position = table.columns[1].values;
    for (std::size_t i = 0; i < SampleRecording::samples; i += 17) {
      // To the last bit: 40 us steps of whole nanoseconds.
      ASSERT_EQ(time[i], static_cast<double>(i) * 40000 / 1e9);
      // The line's kilometres fall; a straight line between positions 0.6 m apart. 1e-7 m: of 102 km in a double.
      ASSERT_NEAR(position[i], 102500 - 30 * static_cast<double>(i) / 25000, 1e-7);
      ASSERT_EQ(table.columns[2].values[i], SampleRecording::left(i));
      ASSERT_EQ(table.columns[3].values[i], -SampleRecording::left(i));
    }
  }
}

TEST(RcmDx, distanceCoveredWhereTheLineChanges) {
  const TemporaryFile file("", ".rcmdx");
  SampleRecording sample;
  sample.withLine = false;
  sample.write(file.path());
  const auto columns = columnsOf(file.path());
  EXPECT_THAT(columns.notes(), ::testing::Contains(HasSubstr("lines 710 (Olten - Bern), 711 (Bern - Thun)")));
  const auto table = columns.read();
  EXPECT_NEAR(valuesOf(table, "position")[100001], 30 * 100001 / 25000.0, 1e-9);
  // Where a track ends, the offset is that of the nearer position: 0.3 m away at most.
  const auto onTrack = columnsOf(file.path(), {"", "track offset"}).read();
  const auto& offset = valuesOf(onTrack, "track offset");
  EXPECT_NEAR(offset[90000], 108, 1e-9);
  EXPECT_NEAR(offset[99700], 119.64, 0.31);
  EXPECT_NEAR(offset[99990], 0, 1e-9) << "of the next track";
  EXPECT_NEAR(offset[110000], 12, 1e-9);
  EXPECT_THAT(complaintOf([&] {
                columnsOf(file.path(), {"", "mileage"});
              }),
              ::testing::IsEmpty())
      << "a column of the file may have this name: it is looked for later";
}

TEST(RcmDx, coordinatesOfASlowerSource) {
  const TemporaryFile file("", ".rcmdx");
  SampleRecording sample;
  sample.withCoordinates = true, sample.withPositions = false;
  sample.write(file.path());
  const auto table = columnsOf(file.path()).read();
  const auto &north = valuesOf(table, "latitude"), &east = valuesOf(table, "longitude");
  for (std::size_t i = 0; i < SampleRecording::samples; i += 997) {
    const double run = static_cast<double>(i) / static_cast<double>(SampleRecording::samples);
    ASSERT_NEAR(north[i], 46.9 + 0.001 * run, 1e-12);
    ASSERT_NEAR(east[i], 7.4 - 0.002 * run, 1e-12);
  }
}

TEST(RcmDx, objectsThatAreNamed) {
  const TemporaryFile file("", ".rcmdx");
  const SampleRecording sample;
  sample.write(file.path());
  EXPECT_EQ(columnsOf(file.path(), {sample.session, ""}).source().name, "FAST");
  EXPECT_EQ(columnsOf(file.path(), {"SLOW", ""}).source().name, "SLOW");
  const auto one = columnsOf(file.path(), {"DFZ01.ABA.FAST.ABA_RIGHT", ""});
  ASSERT_EQ(one.source().channels.size(), 1u);
  EXPECT_EQ(one.source().channels[0].name, "ABA_RIGHT");
  const auto path = sample.session + "/DFZ01.ABA/DFZ01.ABA.FAST/DFZ01.ABA.FAST.TEMPERATURE";
  EXPECT_EQ(columnsOf(file.path(), {path + "/data", ""}).source().channels[0].name, "TEMPERATURE");
  EXPECT_THAT(complaintOf([&] {
                columnsOf(file.path(), {"WHEEL", ""});
              }),
              AllOf(HasSubstr("neither a session"), HasSubstr("FAST/ABA_LEFT [m/s2]")));
}

TEST(RcmDx, severalSessionsAreListed) {
  const TemporaryFile file("", ".rcmdx");
  const SampleRecording sample;
  const std::string other = "/RCMDX/DFZ01/20190322_081500.000";
  {
    PlainHdf5 made(file.path(), PlainHdf5::Open::made);
    sample.writeHead(made);
    sample.writeSession(made, sample.session);
    sample.writeSession(made, other);
  }
  EXPECT_THAT(complaintOf([&] { columnsOf(file.path()); }),
              AllOf(HasSubstr("several sessions"), HasSubstr(sample.session), HasSubstr(other)));
  EXPECT_EQ(columnsOf(file.path(), {"20190322_081500.000", ""}).session().path, other);
  EXPECT_EQ(columnsOf(file.path(), {other + "/DFZ01.ABA/DFZ01.ABA.SLOW", ""}).source().path,
            other + "/DFZ01.ABA/DFZ01.ABA.SLOW");
}

TEST(RcmDx, filesThatAreNone) {
  const TemporaryFile text("time,aba\n1,2\n"), other("", ".h5"), damaged("\x89HDF\r\n\x1a\n nothing more", ".rcmdx");
  { PlainHdf5(other.path(), PlainHdf5::Open::made).group("/run"); }
  for (const auto* file : {&text, &other, &damaged}) EXPECT_FALSE(isRcmDx(file->path()));
  EXPECT_FALSE(isRcmDx(other.path() + ".missing"));
  EXPECT_THAT(complaintOf([&] { readRcmDx(other.path()); }), HasSubstr("states no version"));
}

TEST(RcmDx, damagedRecordingsSayWhatIsWrong) {
  const SampleRecording sample;
  const std::string fast = sample.session + "/DFZ01.ABA/DFZ01.ABA.FAST";
  const auto complaintAfter = [&](const SampleRecording& written, const std::function<void(PlainHdf5&)>& damage) {
    const TemporaryFile file("", ".rcmdx");
    {
      PlainHdf5 made(file.path(), PlainHdf5::Open::made);
      written.writeHead(made);
      written.writeSession(made, written.session);
      damage(made);
    }
    return complaintOf([&] { columnsOf(file.path()).read(); });
  };
  EXPECT_THAT(complaintAfter(sample, [&](PlainHdf5& file) { file.remove(sample.session); }), HasSubstr("no session"));
  EXPECT_THAT(complaintAfter(sample,
                             [&](PlainHdf5& file) {
                               file.remove(fast + "/DFZ01.ABA.FAST.ABA_LEFT/data");
                               file.dataset(fast + "/DFZ01.ABA.FAST.ABA_LEFT/data", std::vector<float>(7),
                                            H5T_NATIVE_FLOAT, H5T_IEEE_F32LE);
                             }),
              AllOf(HasSubstr("ABA_LEFT"), HasSubstr("7 values, its times 150000")));
  EXPECT_THAT(complaintAfter(sample,
                             [&](PlainHdf5& file) {
                               const auto times = sample.session + "/POSITION/POSITION.SOURCE/timestamp";
                               std::vector<std::uint64_t> falling(SampleRecording::samples / 500 + 1);
                               for (std::size_t i = 0; i < falling.size(); ++i) falling[i] = 9000 - i;
                               file.remove(times);
                               file.dataset(times, falling, H5T_NATIVE_UINT64, H5T_STD_U64LE);
                             }),
              AllOf(HasSubstr("POSITION.SOURCE/timestamp"), HasSubstr("falls at value 2")));
  auto metres = sample;
  metres.unit = "millimeter";
  EXPECT_THAT(complaintAfter(metres, [&](PlainHdf5& file) { file.remove(groupOf(fast) + "/DFZ01.ABA.SLOW"); }),
              AllOf(HasSubstr("no channel of accelerations"), HasSubstr("ABA_LEFT [mm]")));
}

// Whatever is cut off or overwritten, there is an error of the file or a table: no crash, no other error.
TEST(RcmDx, brokenBytesAreErrorsOfTheFile) {
  const TemporaryFile whole("", ".rcmdx");
  SampleRecording().write(whole.path());
  const auto bytes = readWholeFile(whole.path(), std::size_t{64} << 20);
  std::size_t refused = 0, tried = 0;
  for (std::size_t at = 96; at < bytes.size(); at += bytes.size() / 12, ++tried) {
    std::string broken = at % 2 == 0 ? bytes.substr(0, at) : bytes;
    for (std::size_t i = at; i < std::min(at + 64, broken.size()); ++i) broken[i] = static_cast<char>(0xA5);
    const TemporaryFile file(broken, ".rcmdx");
    refused += complaintOf([&] { columnsOf(file.path()).read(); }).empty() ? 0 : 1;
  }
  EXPECT_GT(tried, 10U);
  EXPECT_GT(refused, 0U);
}

TEST(RcmDx, placesBetweenPositionsAndBeyondThem) {
  PositionTrack track;
  const auto add = [&track](std::int64_t time, double covered, std::int32_t line, double offset) {
    track.time.push_back(time), track.covered.push_back(covered), track.line.push_back(line);
    track.lineOffset.push_back(offset), track.track.push_back(-1), track.trackOffset.push_back(0);
    track.direction.push_back(1), track.kilometrage.push_back(-1), track.accuracy.push_back(1);
    track.quality.push_back(0);
  };
  constexpr std::int64_t s = 1000000000, t0 = 1553237099000000001;
  add(t0, 0, 5, 1000);
  add(t0 + s, 10, 5, 990);
  add(t0 + 2 * s, 11, 6, 300);    // another line within a metre
  add(t0 + 3 * s, 31, 7, 7000);   // another line within 20 m
  add(t0 + 4 * s, 500, 7, 6531);  // positions are lost over 469 m
  PlaceFinder finder(track);
  EXPECT_DOUBLE_EQ(finder.at(t0 + s / 4).covered, 2.5);
  EXPECT_DOUBLE_EQ(finder.at(t0 + s / 4).lineOffset, 997.5);
  EXPECT_EQ(finder.at(t0 + s / 4).kilometrage, -1);
  EXPECT_DOUBLE_EQ(finder.at(t0 - s / 2).covered, -5);
  EXPECT_TRUE(std::isnan(finder.at(t0 - 2 * s).covered));
  EXPECT_EQ(finder.at(t0 - 2 * s).line, -1);
  EXPECT_DOUBLE_EQ(finder.at(t0 + s + s / 4).lineOffset, 990);
  EXPECT_DOUBLE_EQ(finder.at(t0 + 2 * s - s / 4).lineOffset, 300);
  EXPECT_EQ(finder.at(t0 + 2 * s - s / 4).line, 6);
  EXPECT_TRUE(std::isnan(finder.at(t0 + 2 * s + s / 4).lineOffset));
  EXPECT_DOUBLE_EQ(finder.at(t0 + 2 * s + s / 4).covered, 16);
  EXPECT_TRUE(std::isnan(finder.at(t0 + 3 * s + s / 2).covered));
  EXPECT_DOUBLE_EQ(finder.at(t0).covered, 0) << "back to an earlier time";
  EXPECT_DOUBLE_EQ(placesAt(track, {t0 + 4 * s, t0}).front().covered, 500);
}

TEST(RcmDx, unitsInWords) {
  EXPECT_EQ(symbolOf("Metres per second squared"), "m/s2");
  EXPECT_EQ(symbolOf("meterpersecondsquared"), "m/s2");
  EXPECT_EQ(symbolOf("kilometres per hour"), "km/h");
  EXPECT_EQ(symbolOf("m/s^2"), "m/s^2");
  EXPECT_EQ(symbolOf(" g "), "g");
  EXPECT_EQ(symbolOf(""), "");
}

}  // namespace
}  // namespace squat::rcmdx
