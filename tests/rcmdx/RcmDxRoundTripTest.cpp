// From a recording to its events and back: what the search finds stands in the written file with its exact time, and
// with the place that the recording itself gives for it.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "detection/Detect.h"
#include "detection/RcmDxEvents.h"
#include "rcmdx/PlainHdf5.h"
#include "rcmdx/Recording.h"
#include "rcmdx/SampleRecording.h"
#include "rcmdx/TrackPositions.h"
#include "readers/TemporaryFile.h"

namespace squat::detection {
namespace {

using tests::PlainHdf5;
using tests::SampleRecording;

TEST(RcmDxRoundTrip, EventsHaveTheirTimesAndPlaces) {
  const tests::TemporaryFile file("", ".rcmdx");
  SampleRecording().write(file.path());
  const auto stream = records::openRecord(file.path());
  Monitor monitor;
  DetectionReport report;
  report.records.push_back(findCandidates(*stream, {}, monitor));
  for (const auto& event : report.records[0].channels[0].events) report.events.push_back({event, {0}, 0});
  ASSERT_GE(report.events.size(), 3u);
  report.events[1].event.kind = Kind::squat;

  const auto folder = std::filesystem::path(file.path()).parent_path().string();
  const auto paths = writeRcmDxEvents(report, {}, folder);
  ASSERT_EQ(paths.size(), 1u);
  PlainHdf5 written(paths[0], PlainHdf5::Open::read);
  const auto recording = rcmdx::readRcmDx(paths[0]);
  ASSERT_EQ(recording.sessions.size(), 1u);
  const auto& session = recording.sessions[0];
  const auto times = written.valuesOf<std::int64_t>(session.path + "/EVENTS/timestamp", H5T_NATIVE_INT64);
  ASSERT_EQ(times.size(), report.events.size());
  const auto track = rcmdx::readPositions(paths[0], *session.position);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double seconds = report.events[i].event.time;
    EXPECT_EQ(times[i], SampleRecording::start + std::llround(1e9 * seconds));
    // The train runs down the line at 30 m/s from kilometre 102.5; the file holds micrometres at least.
    EXPECT_NEAR(track.place(i).lineOffset, 102500 - 30 * seconds, 1e-3) << i;
    EXPECT_EQ(track.place(i).line, 710);
  }
  EXPECT_TRUE(written.kindOf(session.path + "/EVENTS") != "nothing");
  std::filesystem::remove(paths[0]);
}

TEST(RcmDxRoundTrip, OtherRecordsHaveNoSuchFile) {
  const tests::TemporaryFile file("time [s],aba [m/s2]\n0,1\n0.0001,2\n");
  DetectionReport report;
  report.records.emplace_back().layout.path = file.path();
  EXPECT_TRUE(writeRcmDxEvents(report, {}, ".").empty());
}

}  // namespace
}  // namespace squat::detection
