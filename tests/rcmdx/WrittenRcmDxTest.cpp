// Written RCM-DX files against the specification: what is mandatory in it, typed by hand from its tables, and looked
// for with HDF5's C interface.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <regex>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "rcmdx/EventsToWrite.h"
#include "rcmdx/PlainHdf5.h"
#include "readers/TemporaryFile.h"

namespace squat::rcmdx {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::PlainHdf5;
using tests::TemporaryFile;

constexpr std::int64_t noon = 1774612800123000000;  // 2026-03-27 12:00:00.123 UTC

Place placeAt(double covered, std::int32_t track, double onTrack) {
  Place place;
  place.covered = covered, place.track = track, place.trackOffset = onTrack;
  place.line = 710, place.lineOffset = 102500 - covered;
  place.direction = 1, place.kilometrage = -1, place.accuracy = 0.5, place.quality = 2;
  return place;
}

EventsToWrite twoSquats() {
  EventsToWrite all;
  all.platform = "DFZ01", all.vehicleNumber = "99 85 9160001-2", all.alias = "2026-03-27 Bern", all.program = "squat";
  all.channels = {{"ABA_LEFT", "m/s2", "MOVE_DIRECTION_VERTICAL_LEFT", "ABA_RIGHT", 1.5},
                  {"ABA_RIGHT", "m/s2", "MOVE_DIRECTION_VERTICAL_RIGHT", "ABA_LEFT", 1.5}};
  all.tracks = {{40, "Gleis 40", "710", 120}, {41, "Gleis 41", "710", 200}};
  all.lines = {{710, "Olten - Bern"}};
  all.kinds = {"squat", "joint"}, all.severities = {"light", "severe"}, all.verdicts = {"confirmed", "rejected"};
  EventToWrite late, early;
  late.time = noon + 5000000001, late.duration = 10000000, late.channel = "ABA_LEFT", late.kind = "squat";
  late.severity = "severe", late.details = "deep, \"fresh\" & <long>", late.peak = 321.5;
  late.parameters = {{"length [mm]", "42"}, {"depth [mm]", "0.31"}, {"sureness", "0.9"}, {"fourth", "left out"}};
  late.place = placeAt(150, 41, 30);
  early.time = noon + 1, early.channel = "ABA_RIGHT", early.kind = "squat", early.severity = "light";
  early.peak = 99, early.place = placeAt(0, 40, 0), early.id = "6ba7b810-9dad-11d1-80b4-00c04fd430c8";
  all.events = {late, early};
  all.start = noon;
  return all;
}

constexpr const char* sessionGroup = "/RCMDX/DFZ01/20260327_120000.123";

struct Mandatory {
  const char* path;  // "S" in front: of the session
  const char* kind;  // of a dataset, with the number of values of twoSquats()
};

// "Optional: no" in the tables of chapters "Root" to "EVENTS", and the optional groups that are written.
const std::vector<Mandatory>& mandatoryObjects() {
  static const std::vector<Mandatory> list{
      {"/RCMDX", "group"},
      {"/RCMDX/FILE", "group"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/type", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/timestamp", "int64[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/service", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/serviceUser", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/host", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG/executable", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/CLEARANCE/clearance", "string[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/CLEARANCE/timestamp", "int64[1]"},
      {"/RCMDX/FILE/DATAPROCESSING/CLEARANCE/user", "string[1]"},
      {"/RCMDX/DFZ01", "group"},
      {"S", "group"},
      {"S/CONFIGURATION", "group"},
      {"S/CONFIGURATION/TOPOLOGY", "group"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/direction", "string[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/id", "int32[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/gtgid", "string[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/length", "string[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/name", "string[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/nrline", "string[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/pointfrom", "int32[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/pointto", "int32[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/switchtype", "int8[2]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACK/tracktype", "int8[2]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/id", "int32[1]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/name", "string[1]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/firststation", "string[1]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/laststation", "string[1]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/fromkilometer", "string[1]"},
      {"S/CONFIGURATION/TOPOLOGY/LINE/tokilometer", "string[1]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/gleisstrangId", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/gleisstrangBez", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/weicheId", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/ablenkRichtung", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/ablenkung", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/betriebspunkt", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/herzStueck", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/minRadius", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/nr", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/zusNr", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/schienenProfil", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/status", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/schwellenArt", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/typenPlanNr", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/typNrZusatz", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/weichenArt", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/weichenTyp", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/weichenForm", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK/weichenZunge", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT/trackid", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT/type", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT/positionstart", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT/positionend", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT/extrainfo", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/trackid", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/lineid", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/x", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/y", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/z", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/radius", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/kilometer", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/position", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/cant", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT/steigung", "float32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY/id", "int32[0]"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY/name", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY/description.ge", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY/description.fr", "string[0]"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY/description.it", "string[0]"},
      {"S/SECTIONS/direction", "string[1]"},
      {"S/SECTIONS/startTimestamp", "uint64[1]"},
      {"S/SECTIONS/endTimestamp", "uint64[1]"},
      {"S/SECTIONS/firstTrackOffset", "float64[1]"},
      {"S/SECTIONS/lastTrackOffset", "float64[1]"},
      {"S/SECTIONS/trackInfoOffset", "float64[1]"},
      {"S/SECTIONS/trackId", "int32[2]"},
      {"S/SECTIONS/trackStartTimestamp", "uint64[2]"},
      {"S/SECTIONS/trackEndTimestamp", "uint64[2]"},
      {"S/SECTIONS/trackKilometrage", "string[2]"},
      {"S/SECTIONS/trackStartCoveredDistance", "float64[2]"},
      {"S/SECTIONS/trackEndCoveredDistance", "float64[2]"},
      {"S/DFZ01.SQUATS", "group"},
      {"S/DFZ01.SQUATS/CONFIGURATION", "group"},
      {"S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/timestamp", "uint64[2]"},
      {"S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/DFZ01.SQUATS.EVENTS.ABA_LEFT/data", "float64[2]"},
      {"S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/DFZ01.SQUATS.EVENTS.ABA_RIGHT/data", "float64[2]"},
      {"S/POSITION", "group"},
      {"S/POSITION/POSITION.SOURCE/timestamp", "uint64[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/covereddistance", "float64[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/direction", "string[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/kilometrage", "string[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/track_id", "int32[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/line_id", "int32[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/trackoffset", "float64[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/lineoffset", "float64[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/positionaccuracy", "float32[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/positionquality", "int32[2]"},
      {"S/EVENTS/systemref", "string[2]"},
      {"S/EVENTS/eventtype", "string[2]"},
      {"S/EVENTS/type", "string[2]"},
      {"S/EVENTS/data", "string[2]"},
      {"S/EVENTS/duration", "int64[2]"},
      {"S/EVENTS/timestamp", "uint64[2]"},
      // As SBB's files name them.
      {"S/EVENTS/events.timestamp", "uint64[2]"},
      {"S/SECTIONS/section.trackId", "int32[2]"},
      {"S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/data.track_id", "int32[2]"},
  };
  return list;
}

struct MandatoryAttribute {
  const char *object, *name, *kind, *value;  // value of a text that is fixed; null: any
};

constexpr const char* leftChannel = "S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/DFZ01.SQUATS.EVENTS.ABA_LEFT";

const std::vector<MandatoryAttribute>& mandatoryAttributes() {
  static const std::vector<MandatoryAttribute> list{
      {"/RCMDX", "Major", "int16", nullptr},
      {"/RCMDX", "Minor", "int16", nullptr},
      {"/RCMDX", "Feature", "int16", nullptr},
      {"/RCMDX/FILE", "Element", "string", "File"},
      {"/RCMDX/FILE", "StructureVersion", "string", nullptr},
      {"/RCMDX/FILE/DATAPROCESSING/PROCESSINGLOG", "Element", "string", "ProcessingLog"},
      {"/RCMDX/FILE/DATAPROCESSING/CLEARANCE", "Element", "string", "Clearance"},
      {"/RCMDX/DFZ01", "Element", "string", "Platform"},
      {"/RCMDX/DFZ01", "VehicleNumber", "string", "99 85 9160001-2"},
      {"S", "Element", "string", "Session"},
      {"S", "StartTime", "uint64", nullptr},
      {"S", "EndTime", "uint64", nullptr},
      {"S", "SessionAlias", "string", "2026-03-27 Bern"},
      {"S/CONFIGURATION/TOPOLOGY", "Element", "string", "Topology"},
      {"S/CONFIGURATION/TOPOLOGY", "DfAVersion", "string", nullptr},
      {"S/CONFIGURATION/TOPOLOGY", "diamond-Source", "string", nullptr},
      {"S/CONFIGURATION/TOPOLOGY/TRACK", "Element", "string", "TopologyTrack"},
      {"S/CONFIGURATION/TOPOLOGY/LINE", "Element", "string", "TopologyLine"},
      {"S/CONFIGURATION/TOPOLOGY/SWITCHTRACK", "Element", "string", "TopologySwitchTrack"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKOBJECT", "Element", "string", "TopologyTrackObject"},
      {"S/CONFIGURATION/TOPOLOGY/TRACKPOINT", "Element", "string", "TopologyTrackPoint"},
      {"S/CONFIGURATION/TOPOLOGY/PROPERTY", "Element", "string", "TopologyProperty"},
      {"S/SECTIONS", "Element", "string", "Sections"},
      {"S/DFZ01.SQUATS", "Element", "string", "System"},
      {"S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS", "Element", "string", "Datasource"},
      {leftChannel, "Element", "string", "Channel"},
      {leftChannel, "TriggerMode", "string", "EVENT"},
      {leftChannel, "CommonTriggerDistance", "float32", nullptr},
      {leftChannel, "CommonTriggerFrequency", "float32", nullptr},
      {leftChannel, "ChannelBasis", "string", "MOVE_DIRECTION_VERTICAL_LEFT"},
      {leftChannel, "MeasurementType", "string", "MEASURED_VALUE"},
      {leftChannel, "Neighbor", "string", "DFZ01.SQUATS.EVENTS.ABA_RIGHT"},
      {leftChannel, "PositionOffset", "float32", nullptr},
      {leftChannel, "Unit", "string", "m/s2"},
      {"S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/DFZ01.SQUATS.EVENTS.ABA_LEFT/data", "Unit", "string", "m/s2"},
      {"S/POSITION", "Element", "string", "System"},
      {"S/POSITION/POSITION.SOURCE", "Element", "string", "Datasource"},
      {"S/EVENTS", "Element", "string", "Events"},
  };
  return list;
}

std::string placed(const std::string& path) { return path[0] == 'S' ? sessionGroup + path.substr(1) : path; }

TEST(WrittenRcmDx, hasWhatTheSpecificationDemands) {
  const TemporaryFile file("", ".rcmdx");
  writeRcmDx(file.path(), twoSquats());
  PlainHdf5 written(file.path(), PlainHdf5::Open::read);
  for (const auto& one : mandatoryObjects()) EXPECT_EQ(written.kindOf(placed(one.path)), one.kind) << one.path;
  for (const auto& one : mandatoryAttributes()) {
    const auto object = placed(one.object);
    ASSERT_EQ(written.kindOfAttribute(object, one.name), one.kind) << object << '@' << one.name;
    if (one.value) {
      EXPECT_EQ(written.textOf(object, one.name), one.value) << object << "@" << one.name;
    }
  }
  EXPECT_EQ(written.numberOf<int>("/RCMDX", "Major", H5T_NATIVE_INT), 2);
  EXPECT_EQ(written.numberOf<int>("/RCMDX", "Minor", H5T_NATIVE_INT), 0);
  EXPECT_EQ(written.numberOf<int>("/RCMDX", "Feature", H5T_NATIVE_INT), 4);
  // "The channel and datasets have no attributes"
  const auto positions = placed("S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA");
  EXPECT_EQ(written.kindOfAttribute(positions, "Element"), "nothing");
}

TEST(WrittenRcmDx, eventsStandInOrderWithTheirTimesPlacesAndChannels) {
  const TemporaryFile file("", ".rcmdx");
  writeRcmDx(file.path(), twoSquats());
  PlainHdf5 written(file.path(), PlainHdf5::Open::read);
  const auto at = [](const std::string& path) { return placed("S/" + path); };
  EXPECT_THAT(written.valuesOf<std::int64_t>(at("EVENTS/timestamp"), H5T_NATIVE_INT64),
              ElementsAre(noon + 1, noon + 5000000001));
  EXPECT_THAT(written.valuesOf<std::int64_t>(at("EVENTS/duration"), H5T_NATIVE_INT64), ElementsAre(0, 10000000));
  EXPECT_THAT(written.textsOf(at("EVENTS/systemref")), ElementsAre("DFZ01.SQUATS", "DFZ01.SQUATS"));
  EXPECT_THAT(written.textsOf(at("EVENTS/channelref")),
              ElementsAre("DFZ01.SQUATS.EVENTS.ABA_RIGHT", "DFZ01.SQUATS.EVENTS.ABA_LEFT"));
  EXPECT_THAT(written.textsOf(at("EVENTS/eventtype")), ElementsAre("Defect", "Defect"));
  const auto left = written.valuesOf<double>(placed(leftChannel) + "/data", H5T_NATIVE_DOUBLE);
  EXPECT_TRUE(std::isnan(left[0]));
  EXPECT_EQ(left[1], 321.5);
  EXPECT_EQ(written.numberOf<std::int64_t>(sessionGroup, "StartTime", H5T_NATIVE_INT64), noon);
  EXPECT_EQ(written.numberOf<std::int64_t>(sessionGroup, "EndTime", H5T_NATIVE_INT64), noon + 5010000001);
  const auto data = at("POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/");
  EXPECT_THAT(written.valuesOf<double>(data + "lineoffset", H5T_NATIVE_DOUBLE),
              ElementsAre(::testing::DoubleNear(102.5, 1e-12), ::testing::DoubleNear(102.35, 1e-12)));
  EXPECT_THAT(written.textsOf(data + "kilometrage"), ElementsAre("DECREASING", "DECREASING"));
  EXPECT_THAT(written.valuesOf<int>(at("SECTIONS/trackId"), H5T_NATIVE_INT), ElementsAre(40, 41));
  EXPECT_THAT(written.valuesOf<double>(at("SECTIONS/trackInfoOffset"), H5T_NATIVE_DOUBLE), ElementsAre(2));
  EXPECT_THAT(written.valuesOf<double>(at("SECTIONS/lastTrackOffset"), H5T_NATIVE_DOUBLE), ElementsAre(200 - 30));
  EXPECT_THAT(written.valuesOf<std::int64_t>(at("SECTIONS/trackStartTimestamp"), H5T_NATIVE_INT64),
              ElementsAre(1, 5000000001));
  // The reader of this program understands it as well.
  const auto recording = readRcmDx(file.path());
  ASSERT_EQ(recording.sessions.size(), 1u);
  const auto track = readPositions(file.path(), *recording.sessions[0].position);
  ASSERT_EQ(track.size(), 2u);
  EXPECT_EQ(track.time[1], noon + 5000000001);
  EXPECT_EQ(track.place(1).track, 41);
  EXPECT_EQ(track.place(1).quality, 2);
}

// The attributes that the schema "Events Defect" requires, and its order of elements.
TEST(WrittenRcmDx, defectsAreTheSchemasXml) {
  const auto all = twoSquats();
  EXPECT_EQ(defectXml(all.events[1], all),
            "<Defect xmlns=\"http://www.sbb.ch/RCMDX/Events/Defect\" Classification=\"light\" DefectName=\"squat\" "
            "Details=\"\" ID=\"6ba7b810-9dad-11d1-80b4-00c04fd430c8\"><PossibleDefectNames>squat</PossibleDefectNames>"
            "<PossibleDefectNames>joint</PossibleDefectNames><PossibleClassifications>light</PossibleClassifications>"
            "<PossibleClassifications>severe</PossibleClassifications><PossibleValidationResults>confirmed"
            "</PossibleValidationResults><PossibleValidationResults>rejected</PossibleValidationResults></Defect>");
  const auto xml = defectXml(all.events[0], all);
  EXPECT_THAT(xml, HasSubstr("Details=\"deep, &quot;fresh&quot; &amp; &lt;long&gt;\""));
  EXPECT_THAT(xml, HasSubstr("Parameter3Name=\"sureness\" Parameter3Value=\"0.9\" ID="));
  EXPECT_THAT(xml, ::testing::Not(HasSubstr("fourth")));
  // The type UUID of the chapter "RCM-DX Data types".
  const std::regex uuid("ID=\"[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{12}\"");
  EXPECT_TRUE(std::regex_search(xml, uuid)) << xml;
  auto other = all.events[0];
  other.time += 1;
  EXPECT_NE(defectXml(other, all), xml);
}

TEST(WrittenRcmDx, withoutEventsOrPlacesEverythingIsThere) {
  const TemporaryFile file("", ".rcmdx"), again("", ".rcmdx");
  auto all = twoSquats();
  all.events.clear();
  writeRcmDx(file.path(), all);
  {
    PlainHdf5 written(file.path(), PlainHdf5::Open::read);
    EXPECT_EQ(written.kindOf(placed("S/EVENTS/timestamp")), "uint64[0]");
    EXPECT_EQ(written.kindOf(placed("S/SECTIONS/direction")), "string[0]");
  }
  all.events.resize(1);
  all.events[0].time = noon, all.events[0].place = {};
  all.events[0].latitude = 46.9, all.events[0].longitude = 7.4;
  writeRcmDx(file.path(), all);
  PlainHdf5 written(file.path(), PlainHdf5::Open::read);
  const auto data = placed("S/POSITION/POSITION.SOURCE/POSITION.SOURCE.DATA/");
  EXPECT_THAT(written.valuesOf<int>(data + "track_id", H5T_NATIVE_INT), ElementsAre(-1));
  EXPECT_THAT(written.valuesOf<int>(data + "positionquality", H5T_NATIVE_INT), ElementsAre(15));
  EXPECT_THAT(written.valuesOf<double>(placed("S/DFZ01.SQUATS/DFZ01.SQUATS.EVENTS/DFZ01.SQUATS.EVENTS.LATITUDE/data"),
                                       H5T_NATIVE_DOUBLE),
              ElementsAre(46.9));
  // "endTimestamp must be greater than startTimestamp"
  EXPECT_THAT(written.valuesOf<std::int64_t>(placed("S/SECTIONS/endTimestamp"), H5T_NATIVE_INT64),
              ElementsAre(noon + 1));
  writeRcmDx(again.path(), all);
  constexpr std::size_t largest = std::size_t{1} << 24;
  EXPECT_EQ(readWholeFile(file.path(), largest), readWholeFile(again.path(), largest)) << "the same each time";
}

TEST(WrittenRcmDx, namesThatCannotBeNamesOfGroups) {
  const TemporaryFile file("", ".rcmdx");
  auto all = twoSquats();
  all.platform = "a/b c", all.channels[0].name = "left [m/s2]", all.channels[1].name = "left (m/s2)";
  all.events[0].channel = "left [m/s2]", all.events[1].channel = "left (m/s2)";
  writeRcmDx(file.path(), all);
  PlainHdf5 written(file.path(), PlainHdf5::Open::read);
  EXPECT_THAT(written.textsOf("/RCMDX/a_b_c/20260327_120000.123/EVENTS/channelref"),
              ElementsAre("a_b_c.SQUATS.EVENTS.left__m_s2__2", "a_b_c.SQUATS.EVENTS.left__m_s2_"));
  all.events[0].channel = "unheard of";
  EXPECT_THROW(writeRcmDx(file.path(), all), CaseError);
  EXPECT_THROW(writeRcmDx("/nowhere/at/all.rcmdx", twoSquats()), FileError);
}

TEST(WrittenRcmDx, sessionsAreNamedByTheirStart) {
  EXPECT_EQ(sessionName(1550013175592999999), "20190212_231255.592");  // the specification's example
  EXPECT_EQ(sessionName(0), "19700101_000000.000");
}

}  // namespace
}  // namespace squat::rcmdx
