// Flats repeat with the wheel's circumference, corrugation is long.
#include "detection/Surroundings.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace squat::detection {
namespace {

Event eventOfStrength(double position, double strength = 1) {
  Event event;
  event.kind = Kind::squat, event.sureness = 0.8;
  event.position = event.travelled = position;
  event.features.energy.fill(strength);
  event.features.reach = 0.5;
  return event;
}

std::vector<Event> inOrder(std::vector<Event> events) {
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.travelled < b.travelled; });
  return events;
}

std::vector<Event> withFlats(double circumference, int count, double scatter) {
  std::vector<Event> events;
  for (int i = 0; i < count; ++i)
    events.push_back(eventOfStrength(10 + circumference * i + (i % 2 ? scatter : -scatter)));
  return events;
}

long flatsIn(const std::vector<Event>& events) {
  return std::count_if(events.begin(), events.end(), [](const Event& event) { return event.kind == Kind::flat; });
}

TEST(Flats, AreFoundWithTheirCircumference) {
  auto events = withFlats(2.89, 12, 0.01);  // wheel of 0.92 m
  events.push_back(eventOfStrength(17.1));
  events = inOrder(events);
  EXPECT_NEAR(markFlats(events, {}), 2.89, 0.02);
  EXPECT_EQ(flatsIn(events), 12);
  EXPECT_THAT(events[0].reason, ::testing::HasSubstr("12 times"));
}

TEST(Flats, AMissedStrikeDoesNotEndThem) {
  auto events = withFlats(2.7, 10, 0.01);
  events.erase(events.begin() + 4);
  EXPECT_NEAR(markFlats(events, {}), 2.7, 0.02);
  EXPECT_EQ(flatsIn(events), 9);
}

TEST(Flats, ASquatUnderOneStaysASquat) {
  auto events = withFlats(2.89, 10, 0.0);
  events[5].features.energy.fill(20);
  markFlats(events, {});
  EXPECT_EQ(events[5].kind, Kind::squat);
  EXPECT_EQ(flatsIn(events), 9);
}

// Four strikes are a flat unless they look like none; three only where they look like one and the wheel is known.
TEST(Flats, AreKnownByTheirLookAsWell) {
  const auto strikes = [](int count, double flat) {
    auto events = withFlats(2.89, count, 0.01);
    for (auto& event : events) event.judgement.flatProbability = flat;
    return events;
  };
  SurroundingsOptions known;
  known.circumference = 2.89;
  auto four = strikes(4, 0.5), unlike = strikes(4, 0.01), three = strikes(3, 0.9), any = strikes(3, 0.5);
  auto unknown = three;
  markFlats(four, known), markFlats(unlike, known), markFlats(three, known), markFlats(any, known);
  EXPECT_EQ(flatsIn(four), 4);
  EXPECT_EQ(flatsIn(unlike), 0);
  EXPECT_EQ(flatsIn(three), 3);
  EXPECT_EQ(flatsIn(any), 0);
  markFlats(unknown, {});
  EXPECT_EQ(flatsIn(unknown), 0);
}

// Twelve squats in 200 m, at places without a pattern.
TEST(Flats, SquatsAtRandomAreNone) {
  std::vector<Event> events;
  for (const double place : {3.1, 21.7, 29.2, 48.9, 55.3, 77.0, 96.4, 111.8, 118.1, 140.6, 171.2, 190.3})
    events.push_back(eventOfStrength(place));
  EXPECT_EQ(markFlats(events, {}), 0);
  EXPECT_EQ(flatsIn(events), 0);
}

TEST(Corrugation, IsWhatIsLoudForLong) {
  std::vector<Event> events{eventOfStrength(1), eventOfStrength(9)};
  events[1].features.reach = 4;
  markCorrugation(events);
  EXPECT_EQ(events[0].kind, Kind::squat);
  EXPECT_EQ(events[1].kind, Kind::corrugation);
  EXPECT_THAT(events[1].reason, ::testing::HasSubstr("4 m"));
}

}  // namespace
}  // namespace squat::detection
