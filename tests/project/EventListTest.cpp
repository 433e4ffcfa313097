// The list of events that a project links to: what a search has written is read, and damage is named.
#include "project/EventList.h"

#include <gmock/gmock.h>

#include <limits>

#include "analysis/Folder.h"
#include "core/Errors.h"
#include "detection/DetectionFiles.h"

namespace squat::project {
namespace {

using ::testing::HasSubstr;
using tests::Folder;

// A squat and a joint of two records, by hand.
detection::DetectionReport madeUp() {
  detection::DetectionReport report;
  report.records.resize(2);
  report.records[0].layout.path = "/rides/day 1.csv", report.records[1].layout.path = "/rides/day 2.csv";
  detection::CombinedEvent squat{{}, {0, 1}, 0}, joint{{}, {1}, 0};
  squat.event.channel = "left", joint.event.channel = "right";
  squat.event.position = 12345.6784, squat.event.time = 10.5;
  squat.event.kind = detection::Kind::squat, squat.event.sureness = 0.914;
  squat.event.peak = 99.96, squat.event.features.speed = 30;
  squat.event.judgement.severity = detection::Severity::moderate;
  auto& judged = squat.event.judgement;
  judged.length = 0.045, judged.lengthLow = 0.03, judged.lengthHigh = 0.06;
  judged.depth = 0.2e-3, judged.depthLow = 0.1e-3, judged.depthHigh = 0.3e-3;
  judged.severities = {0.1, 0.7, 0.2};
  judged.offset = -0.021;
  squat.event.side = detection::SideJudgement{{0.2, 0.7, 0.1}};
  squat.event.passes = 2, squat.event.passesThere = 3;
  joint.event.kind = detection::Kind::joint, joint.event.position = -7, joint.event.reason = "stands beside a weld";
  for (auto* event : {&squat.event, &joint.event})
    event->latitude = event->longitude = std::numeric_limits<double>::quiet_NaN();
  detection::CombinedEvent stretch = joint;
  stretch.event.kind = detection::Kind::corrugation, stretch.event.extent = 64, stretch.event.reason.clear();
  report.events = {squat, joint, stretch};
  return report;
}

FileError refusalOf(const std::string& text) {
  try {
    parseEventList(text, "squats.json");
  } catch (const FileError& error) {
    return error;
  }
  ADD_FAILURE() << "was read: " << text.substr(0, 300);
  return FileError("", "", "");
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(EventList, whatASearchWroteIsRead) {
  const Folder folder;
  detection::writeDetection(madeUp(), folder.path());
  const auto list = readEventList(folder.path("squats.json"));
  EXPECT_EQ(list.records, (std::vector<std::string>{"/rides/day 1.csv", "/rides/day 2.csv"}));
  ASSERT_EQ(list.events.size(), 3U);
  const auto &squat = list.events[0], &joint = list.events[1], &stretch = list.events[2];
  EXPECT_NEAR(squat.position, 12345.678, 1e-9);  // to the millimetre
  EXPECT_NEAR(squat.time, 10.5, 1e-9);
  EXPECT_EQ(squat.record, "/rides/day 1.csv");
  EXPECT_EQ(squat.channel, "left");
  EXPECT_EQ(squat.kind, "squat");
  EXPECT_EQ(squat.severity, "moderate");
  EXPECT_NEAR(squat.sureness, 0.91, 1e-9);
  EXPECT_NEAR(squat.peak, 100, 1e-9);
  EXPECT_NEAR(squat.speed, 30, 1e-9);
  EXPECT_NEAR(squat.length, 0.045, 1e-12);
  EXPECT_NEAR(squat.depth, 0.2e-3, 1e-12);
  EXPECT_NEAR(squat.lengthLow, 0.03, 1e-12);
  EXPECT_NEAR(squat.lengthHigh, 0.06, 1e-12);
  EXPECT_NEAR(squat.depthLow, 0.1e-3, 1e-12);
  EXPECT_NEAR(squat.impact, -0.021, 1e-12);
  EXPECT_NEAR(squat.depthHigh, 0.3e-3, 1e-12);
  EXPECT_NEAR(squat.severities[0], 0.1, 1e-12);
  EXPECT_NEAR(squat.severities[1], 0.7, 1e-12);
  EXPECT_NEAR(squat.severities[2], 0.2, 1e-12);
  EXPECT_EQ(squat.side, "right");
  EXPECT_NEAR(squat.sideSureness, 0.7, 1e-12);
  EXPECT_EQ(joint.side, "");
  EXPECT_EQ(squat.passes, 2);
  EXPECT_EQ(squat.passesThere, 3);
  EXPECT_EQ(joint.record, "/rides/day 2.csv");
  EXPECT_EQ(joint.kind, "joint");
  EXPECT_EQ(joint.severity, "");
  EXPECT_EQ(joint.reason, "stands beside a weld");
  EXPECT_EQ(joint.extent, 0);
  EXPECT_EQ(stretch.extent, 64);
}

TEST(EventList, saysWhatIsWrongAndWhere) {
  const std::string good = detection::detectionJson(madeUp());
  ASSERT_NO_THROW(parseEventList(good, "squats.json"));
  const auto location = [&](const std::string& from, const std::string& to) {
    return refusalOf(with(good, from, to)).location();
  };
  EXPECT_EQ(location("\"squat-detection\"", "\"squat-project\""), "/schema");
  EXPECT_EQ(location("\"schema_version\": 1", "\"schema_version\": 2"), "/schema_version");
  EXPECT_EQ(location("\"position_m\": 1", "\"position_m\": 1e99, \"x\": 1"), "/events/0/position_m");
  EXPECT_EQ(location("\"kind\": \"joint\"", "\"kind\": 1"), "/events/1/kind");
  EXPECT_EQ(location("\"record\": \"/rides/day 1.csv\"", "\"record\": \"/rides\""), "/events/0/record");
  EXPECT_EQ(location("\"passes\": 2", "\"passes\": 2.5"), "/events/0/passes");
  EXPECT_EQ(location("\"length_mm\"", "\"length\""), "/events/0");
  EXPECT_EQ(location("\"depth_mm\": [", "\"depth_mm\": [[],"), "/events/0/depth_mm/0");
  EXPECT_THAT(refusalOf("").location(), HasSubstr("line 1"));
  EXPECT_THAT(refusalOf("[1]").what(), HasSubstr("not a table"));
  EXPECT_THAT(refusalOf("[1e999]").what(), HasSubstr("beyond 1.8e308"));
  EXPECT_THAT(refusalOf(good.substr(0, good.size() / 2)).what(), HasSubstr("cut off"));
  const Folder folder;
  EXPECT_THROW(readEventList(folder.path("squats.json")), FileError);
}

// A changed byte is found, or it has changed a text or a number to another one that a list can have.
TEST(EventList, damageIsNamedOrHarmless) {
  const std::string good = detection::detectionJson(madeUp());
  int refused = 0, read = 0;
  for (std::size_t at = 0; at < good.size(); ++at)
    for (const char byte : {'\0', '"', '9', '\xff'}) {
      std::string damaged = good;
      damaged[at] = byte;
      try {
        parseEventList(damaged, "squats.json");
        ++read;
      } catch (const FileError& error) {
        EXPECT_FALSE(error.location().empty()) << error.what();
        ++refused;
      }
    }
  EXPECT_GT(refused, read);
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace squat::project
