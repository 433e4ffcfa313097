// Candidates that another process has found come back to the bit, or not at all.
#include "detection/CandidateFile.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::detection {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

RecordDetection sample() {
  RecordDetection found;
  found.layout.path = "ride.csv", found.layout.rate = 25000, found.layout.falling = true, found.layout.samples = 7;
  found.layout.channels = {{"left", "m/s2"}};
  found.layout.notes = found.notes = {"a note"};
  found.faults.push_back({records::FaultKind::unit, 3, 9, 0.1, 1.0 / 3.0, -1, "text", "advice"});
  found.duration = 2.5, found.length = 75;
  Event event;
  event.channel = "left", event.unit = "m/s2", event.time = 1.0 / 7.0, event.position = 12345.678;
  event.latitude = std::numeric_limits<double>::quiet_NaN(), event.longitude = 6.5;
  event.score = 99, event.peak = 1e-300;
  event.features.speed = 30, event.features.energy[5] = 0.1, event.features.freedom[0] = 4;
  event.features.wavelength = 0.029;
  event.arrival = FirstArrival{{1.0 / 3.0, 2}, {0.1, 0}}, event.otherPeak = 0.25;
  event.passage = {0.25, 4e-5, {1, -2.5, 1.0 / 3.0}, "left", "m/s2"};
  auto alone = event;
  alone.arrival.reset();
  found.channels.push_back({"left", {event, alone}, {{12345, 1, 2}}, 0});
  found.axles = {{0, 1}};
  return found;
}

class CandidateFileTest : public ::testing::Test {
 protected:
  CandidateFileTest() { std::ofstream(record_) << "time [s],aba [m/s2]\n0,1\n0.1,2\n"; }
  CandidateKey key() const { return candidateKey(record_, read_, options_); }
  const TemporaryFolder folder_;
  std::string record_ = folder_ / "ride.csv";
  records::RecordOptions read_;
  DetectOptions options_;
};

TEST_F(CandidateFileTest, EveryNumberComesBack) {
  EXPECT_FALSE(readCandidates(folder_.path(), key()));
  writeCandidates(folder_.path(), key(), sample());
  const auto read = readCandidates(folder_.path(), key());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->layout.path, "ride.csv");
  EXPECT_EQ(read->layout.rate, 25000);
  EXPECT_TRUE(read->layout.falling);
  EXPECT_EQ(read->layout.samples, 7U);
  EXPECT_EQ(read->layout.channels.at(0).unit, "m/s2");
  EXPECT_EQ(read->notes, std::vector<std::string>{"a note"});
  ASSERT_EQ(read->faults.size(), 1U);
  EXPECT_EQ(read->faults[0].kind, records::FaultKind::unit);
  EXPECT_EQ(read->faults[0].channel, -1);
  EXPECT_EQ(read->faults[0].position, 1.0 / 3.0);
  EXPECT_EQ(read->length, 75);
  ASSERT_EQ(read->channels.at(0).events.size(), 2U);
  ASSERT_TRUE(read->channels[0].events[0].arrival);
  EXPECT_EQ(read->channels[0].events[0].arrival->energy[0], 1.0 / 3.0);
  EXPECT_EQ(read->channels[0].events[0].arrival->noise[0], 0.1);
  EXPECT_EQ(read->channels[0].events[0].otherPeak, 0.25);
  EXPECT_FALSE(read->channels[0].events[1].arrival);
  ASSERT_EQ(read->axles.size(), 1U);
  EXPECT_EQ(read->axles[0].right, 1U);
  const auto& event = read->channels[0].events[0];
  EXPECT_EQ(event.time, 1.0 / 7.0);
  EXPECT_TRUE(std::isnan(event.latitude));
  EXPECT_EQ(event.peak, 1e-300);
  EXPECT_EQ(event.features.energy, sample().channels[0].events[0].features.energy);
  EXPECT_EQ(event.features.wavelength, 0.029);
  EXPECT_EQ(event.passage.values, (std::vector<double>{1, -2.5, 1.0 / 3.0}));
  EXPECT_EQ(event.passage.step, 4e-5);
  EXPECT_EQ(read->channels[0].pieces.at(0).peak, 2);
}

TEST_F(CandidateFileTest, OtherSettingsAreRefusedByName) {
  writeCandidates(folder_.path(), key(), sample());
  options_.threshold = 20;
  try {
    readCandidates(folder_.path(), key());
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("threshold 14"));
    EXPECT_THAT(error.what(), HasSubstr("threshold 20"));
  }
}

TEST_F(CandidateFileTest, ARecordThatHasChangedIsNotKnown) {
  writeCandidates(folder_.path(), key(), sample());
  std::ofstream(record_) << "time [s],aba [m/s2]\n0,1\n0.1,3\n";  // as long as before
  EXPECT_FALSE(readCandidates(folder_.path(), key()));
  EXPECT_THROW(candidateKey(folder_ / "none.csv", read_, options_), FileError);
}

TEST_F(CandidateFileTest, DamageAnywhereIsFound) {
  writeCandidates(folder_.path(), key(), sample());
  const auto path = candidateFile(folder_.path(), record_);
  const auto whole = readWholeFile(path, 100000);
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    auto damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
    writeDurably(path, damaged);
    EXPECT_THROW(readCandidates(folder_.path(), key()), FileError) << at;
    writeDurably(path, whole.substr(0, at));
    EXPECT_THROW(readCandidates(folder_.path(), key()), FileError) << at;
  }
}

}  // namespace
}  // namespace squat::detection
