// The list as other programs read it.
#include "detection/DetectionFiles.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "text/Csv.h"

namespace squat::detection {
namespace {

using ::testing::HasSubstr;

DetectionReport reportWith(double latitude) {
  DetectionReport report;
  RecordDetection record;
  record.layout.path = "ride.csv";
  record.channels.push_back({"left", {}, {}, 0});
  report.records.push_back(record);
  CombinedEvent squat{{}, {0}, 0}, weld{{}, {0}, 0};
  squat.event.channel = weld.event.channel = "left";
  squat.event.position = 12345.678, squat.event.time = 10.5, squat.event.peak = 99.96;
  squat.event.kind = Kind::squat, squat.event.sureness = 0.914;
  squat.event.latitude = latitude, squat.event.longitude = 6.5;
  squat.event.features.speed = 30;
  squat.event.judgement = {Kind::squat, 0.914,  0.914,  0, Severity::moderate, 0.7, 0.045, 0.03, 0.06,
                           0.2e-3,      0.1e-3, 0.3e-3, 0};
  weld.event.kind = Kind::weld, weld.event.position = 12400;
  weld.event.latitude = weld.event.longitude = std::numeric_limits<double>::quiet_NaN();
  report.events = {squat, weld};
  return report;
}

TEST(DetectionFiles, TheTableHasNamedColumnsWithUnits) {
  const auto rows = text::csvRecords(detectionCsv(reportWith(53)));
  ASSERT_GE(rows.size(), 3U);
  std::map<std::string, std::string> squat, weld;
  for (std::size_t i = 0; i < rows[0].size(); ++i) squat[rows[0][i]] = rows[1][i], weld[rows[0][i]] = rows[2][i];
  EXPECT_EQ(squat["position [m]"], "12345.678");
  EXPECT_EQ(squat["time [s]"], "10.50000");
  EXPECT_EQ(squat["kind"], "squat");
  EXPECT_EQ(squat["severity"], "moderate");
  EXPECT_EQ(squat["peak [m/s2]"], "100.0");
  EXPECT_EQ(squat["length [mm]"], "45");
  EXPECT_EQ(squat["depth high [mm]"], "0.300");
  EXPECT_EQ(weld["kind"], "weld");
  EXPECT_EQ(weld["severity"], "");
  EXPECT_EQ(weld["depth [mm]"], "");
}

TEST(DetectionFiles, GeoJsonHasAPointForEachEventWithCoordinates) {
  const auto json = nlohmann::json::parse(detectionGeoJson(reportWith(53)));
  EXPECT_EQ(json["type"], "FeatureCollection");
  ASSERT_EQ(json["features"].size(), 1U);
  EXPECT_EQ(json["features"][0]["geometry"]["coordinates"], (nlohmann::json{6.5, 53.0})) << "longitude comes first";
  EXPECT_EQ(json["features"][0]["properties"]["severity"], "moderate");
  EXPECT_EQ(detectionGeoJson(reportWith(std::numeric_limits<double>::quiet_NaN())), "");
}

TEST(DetectionFiles, JsonReadsBack) {
  const auto json = nlohmann::json::parse(detectionJson(reportWith(53)));
  EXPECT_EQ(json["events"].size(), 2U);
  EXPECT_EQ(json["events"][0]["depth_mm"][0], 0.2);
  EXPECT_FALSE(json["events"][1].contains("severity"));
}

// A file name from an old system, in Latin-1: the list is written all the same, and reads back.
TEST(DetectionFiles, NamesNeedNotBeUtf8) {
  auto report = reportWith(53);
  report.records[0].layout.path =
      "gleis-s\xfc"
      "d.csv";
  EXPECT_THAT(nlohmann::json::parse(detectionJson(report))["events"][0]["record"].get<std::string>(),
              HasSubstr("d.csv"));
  EXPECT_EQ(nlohmann::json::parse(detectionGeoJson(report))["features"].size(), 1U);
}

// What `squat estimate passages/*.csv --each` is given: this list's squats, none of an earlier call, no other's file.
TEST(DetectionFiles, PassagesAreThoseOfTheList) {
  const squat::tests::TemporaryFolder folder;
  const auto name = [&](const char* file) { return folder / (std::string("passages/") + file); };
  auto report = reportWith(53);
  report.events[0].event.passage = {10.25, 2e-4, {1.5, -2}, "left", "m/s2"};
  std::filesystem::create_directory(folder / "passages");
  for (const char* file : {"squat-0002.csv", "squat-own.csv", "squat-12.csv"}) std::ofstream(name(file)) << "kept?";
  EXPECT_EQ(writeDetection(report, folder.path()).back(), folder / "passages");
  EXPECT_EQ(readWholeFile(name("squat-0001.csv"), 1000),
            "time [s],speed [m/s],aba [m/s2]\n10.25,30,1.5\n10.2502,30,-2\n");
  EXPECT_FALSE(std::filesystem::exists(name("squat-0002.csv"))) << "a weld now, a squat of an earlier list";
  EXPECT_TRUE(std::filesystem::exists(name("squat-own.csv")));
  EXPECT_TRUE(std::filesystem::exists(name("squat-12.csv")));
  const auto rows = text::csvRecords(readWholeFile(folder / "squats.csv", 10000));
  EXPECT_EQ(rows.at(1).back(), "passages/squat-0001.csv");
  EXPECT_EQ(rows.at(2).back(), "");
  report.events.erase(report.events.begin());
  EXPECT_NE(writeDetection(report, folder.path()).back(), folder / "passages");
  EXPECT_FALSE(std::filesystem::exists(name("squat-0001.csv")));
}

// Saved by a spreadsheet of a country with decimal commas; positions in km, lengths in cm.
TEST(DetectionFiles, LabelsAreReadAsSpreadsheetsSaveThem) {
  const auto path = (std::filesystem::temp_directory_path() / "labels-spreadsheet-test.csv").string();
  std::ofstream(path) << "\xEF\xBB\xBFPosition [km];Kind;Length [cm];Depth [mm]\r\n12,345678;squat;5,0;0,12\r\n\r\n"
                         "12,4;weld;;\r\n";
  const auto labels = readLabels(path);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_NEAR(labels[0].position, 12345.678, 1e-9);
  EXPECT_NEAR(labels[0].length, 0.05, 1e-12);
  EXPECT_NEAR(labels[0].depth, 0.12e-3, 1e-12);
  EXPECT_EQ(labels[1].kind, Kind::weld);
  std::ofstream(path) << "position [s],kind\n12,squat\n";
  EXPECT_THROW(readLabels(path), FileError);
}

// The table corrected by hand serves as labels.
TEST(DetectionFiles, TheTableServesAsLabels) {
  const auto path = (std::filesystem::temp_directory_path() / "labels-test.csv").string();
  auto text = detectionCsv(reportWith(53));
  text.replace(text.rfind(",moderate,") + 1, 8, "severe");
  std::ofstream(path) << text;
  const auto labels = readLabels(path);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_DOUBLE_EQ(labels[0].position, 12345.678);
  EXPECT_FALSE(labels[0].hasSize()) << "the table's sizes are estimates";
  EXPECT_EQ(labels[1].kind, Kind::weld);
  EXPECT_EQ(labels[0].severity, Severity::severe);
  std::ofstream(path) << "position [m],kind,false alarms [1/km]\n12,squat,0\n20,corrugation,\n";
  EXPECT_EQ(readLabels(path).size(), 1U) << "a stretch of corrugation is no event";
  std::ofstream(path) << "position [m],kind,length [mm],depth [mm]\n12,squat,50,0.12\n";
  EXPECT_NEAR(readLabels(path).at(0).length, 0.05, 1e-12) << "measured on site";
  EXPECT_EQ(readLabels(path).at(0).severityBy({}), Severity::moderate);
  std::ofstream(path) << "position [m],kind,severity\n12,squat,heavy\n";
  try {
    readLabels(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 2"));
    EXPECT_THAT(error.what(), HasSubstr("light, moderate, severe"));
  }
  std::ofstream(path) << "position [m],kind\n12,crossing\n";
  try {
    readLabels(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 2"));
    EXPECT_THAT(error.what(), HasSubstr("squat, joint, weld"));
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace squat::detection
