// What the user has seen decides, whatever the signal says.
#include <gmock/gmock.h>

#include "TemporaryFolder.h"
#include "core/DurableFile.h"
#include "detection/Detect.h"
#include "detection/ExampleSource.h"
#include "detection/Passes.h"

namespace squat::detection {
namespace {

Example exampleOf(Kind kind, double energy) {
  Example example;
  example.kind = kind, example.vehicle = "a", example.speed = 30, example.energy.fill(energy);
  if (kind == Kind::squat) example.length = 0.02, example.depth = 0.05e-3;
  return example;
}

Judge lightSquatOrLoudWeld() {
  JudgementOptions options;
  options.commonSpread = 0.05, options.sizeSpread = 0.05;
  return {{exampleOf(Kind::squat, 1), exampleOf(Kind::weld, 100)}, options};
}

Event eventAt(double position, double energy) {
  Event event;
  event.channel = "left", event.position = event.travelled = position, event.time = position / 30;
  event.features.speed = 30, event.features.reach = 0.5;
  event.features.energy.fill(energy + 0.01), event.features.noise.fill(0.01), event.features.freedom.fill(20);
  return event;
}

// Light squat, weld, noise.
RecordDetection detection() {
  RecordDetection found;
  found.channels.push_back({"left", {eventAt(10, 1), eventAt(20, 100), eventAt(30, 0)}, {}, 0});
  return found;
}

Label labelAt(double position, Kind kind) {
  Label label;
  label.position = position, label.kind = kind;
  return label;
}

TEST(Labels, DecideKindAndSeverity) {
  Monitor unwatched;
  auto found = detection();
  ASSERT_TRUE(judgeCandidates(found, lightSquatOrLoudWeld(), {}, unwatched));
  ASSERT_EQ(found.channels[0].events.size(), 2U) << "the third is noise";
  EXPECT_EQ(found.channels[0].events[0].judgement.severity, Severity::light);
  EXPECT_EQ(found.channels[0].events[1].kind, Kind::weld);

  found = detection();
  auto severe = labelAt(10.2, Kind::squat), sized = labelAt(20.1, Kind::squat);
  severe.severity = Severity::severe;
  sized.length = 0.05, sized.depth = 0.1e-3;
  EXPECT_EQ(attachLabels(found, {severe, sized, labelAt(30.3, Kind::joint)}), std::vector<bool>(3, true));
  ASSERT_TRUE(judgeCandidates(found, lightSquatOrLoudWeld(), {}, unwatched));
  const auto& events = found.channels[0].events;
  ASSERT_EQ(events.size(), 3U) << "what was seen is not noise";
  EXPECT_EQ(events[0].kind, Kind::squat);
  EXPECT_EQ(events[0].judgement.severity, Severity::severe);
  EXPECT_EQ(events[1].kind, Kind::squat);
  EXPECT_EQ(events[1].judgement.severity, Severity::moderate) << "50 mm, 0.1 mm";
  EXPECT_EQ(events[2].kind, Kind::joint);
  for (const auto& event : events) {
    EXPECT_EQ(event.sureness, 1);
    EXPECT_EQ(event.reason, "as labelled");
  }
}

TEST(Labels, BelongToTheNearestEventOfTheirChannel) {
  auto found = detection();
  auto elsewhere = labelAt(10, Kind::joint);
  elsewhere.channel = "right";
  EXPECT_EQ(attachLabels(found, {labelAt(10.6, Kind::joint), elsewhere, labelAt(19.6, Kind::joint)}),
            (std::vector<bool>{false, false, true}))
      << "beyond half a metre; of another channel; 0.4 m away";
  const auto examples = labelledExamples(found, 5);
  ASSERT_EQ(examples.size(), 1U);
  EXPECT_EQ(examples[0].kind, Kind::joint);
  EXPECT_EQ(examples[0].weight, 5);
  EXPECT_NEAR(examples[0].energy[0], 100, 1e-9) << "of the event at 20 m, freed of its noise";
}

// One of two equal events is labelled a joint: the other, a weld until then, becomes one. The squat stays.
TEST(Labels, SayWhatTheyChange) {
  std::vector<RecordDetection> records(1);
  records[0].channels.push_back({"left", {eventAt(10, 1), eventAt(20, 100), eventAt(25, 100)}, {}, 0});
  attachLabels(records[0], {labelAt(20, Kind::joint)});
  ExampleSource source;
  source.judgement.commonSpread = 0.05;
  source.examples = {exampleOf(Kind::squat, 1), exampleOf(Kind::weld, 100)};
  for (auto& example : labelledExamples(records[0], 5)) source.examples.push_back(example), ++source.fromLabels;
  Monitor unwatched;
  const auto report = judged(std::move(records), source, {}, unwatched);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->records[0].channels[0].events[2].kind, Kind::joint);
  EXPECT_THAT(report->notes, ::testing::ElementsAre("of the 2 events without a label, labels changed the kind of 1 and"
                                                    " the severity of 0"));
}

// What a label taught on one record is kept, and judges the next of the same train: a joint there too. An event that
// is labelled once more is not learned twice.
TEST(Labels, TeachTheNextRecord) {
  const tests::TemporaryFolder folder;
  writeDurably(folder / "labels.csv", std::string_view("position [m],kind\n20,joint\n"));
  writeDurably(folder / "examples.csv", examplesText({exampleOf(Kind::squat, 1), exampleOf(Kind::weld, 100)}));
  SourceOptions options;
  options.examplesFile = folder / "examples.csv", options.labelsFile = folder / "labels.csv";
  options.learnedFile = folder / "learned.csv";
  Monitor unwatched;
  for (int call = 0; call < 2; ++call) {
    std::vector<RecordDetection> first{detection()};
    const auto source = exampleSource(options, first, unwatched);
    ASSERT_TRUE(source);
    keepLearned(*source, options.learnedFile);
    const auto learned = readExamples(options.learnedFile);
    ASSERT_EQ(learned.size(), 1U) << "call " << call;
    EXPECT_EQ(learned[0].kind, Kind::joint);
  }
  options.labelsFile.clear();
  std::vector<RecordDetection> next(1);
  next[0].channels.push_back({"left", {eventAt(10, 100), eventAt(20, 100)}, {}, 0});
  auto source = exampleSource(options, next, unwatched);
  ASSERT_TRUE(source);
  EXPECT_THAT(source->words, ::testing::HasSubstr("1 learned earlier"));
  EXPECT_EQ(source->fromLabels, 1U);
  source->sizes = {}, source->judgement.commonSpread = 0.05;
  const auto report = judged(std::move(next), *source, {}, unwatched);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->records[0].channels[0].events[1].kind, Kind::joint) << "a weld by the examples alone";
  EXPECT_THAT(report->notes, ::testing::ElementsAre(::testing::HasSubstr("labels changed the kind of 2")));
}

// The counter of a second pass stands 3.7 m ahead: the labels are in the chainage of the first.
TEST(Labels, BelongToTheSameEventsOfAPassWithAnotherCounter) {
  std::vector<RecordDetection> passes{detection(), detection()};
  for (auto& event : passes[1].channels[0].events) event.position += 3.7;
  const auto shifts = shiftsOntoFirst(passes);
  ASSERT_EQ(shifts.size(), 2U);
  EXPECT_EQ(shifts[0], 0);
  EXPECT_NEAR(shifts[1], -3.7, 1e-9);
  EXPECT_TRUE(attachLabels(passes[1], {labelAt(20.1, Kind::joint)}, shifts[1])[0]);
  EXPECT_TRUE(passes[1].channels[0].events[1].label);
  // Where the shift was found from what is elsewhere in each pass, the labels show it.
  EXPECT_TRUE(attachLabels(passes[0], {labelAt(20.1, Kind::joint)}, -3.7)[0]);
  EXPECT_TRUE(passes[0].channels[0].events[1].label);
}

}  // namespace
}  // namespace squat::detection
