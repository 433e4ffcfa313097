// What the judgement says where it does not know.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "case/ShippedCases.h"
#include "detection/Examples.h"

namespace squat::detection {
namespace {

using OfVehicles = std::map<std::string, std::vector<Example>>;

const OfVehicles& ofVehicles() {
  static const auto all = [] {
    OfVehicles grouped;
    for (auto& example : readExamples((cases::resourcesFolder() / "detection/examples.csv").string()))
      grouped[example.vehicle].push_back(example);
    return grouped;
  }();
  return all;
}

// Judged by all other vehicles; energies times the factor.
std::vector<Judgement> judgedByOthers(const std::string& vehicle, double factor) {
  std::vector<Example> rest;
  for (const auto& [other, examples] : ofVehicles())
    if (other != vehicle) rest.insert(rest.end(), examples.begin(), examples.end());
  std::vector<EventFeatures> events;
  for (const auto& example : ofVehicles().at(vehicle)) {
    auto& event = events.emplace_back();
    event.speed = example.speed;
    event.freedom.fill(20);
    for (std::size_t b = 0; b < bandCount; ++b) event.energy[b] = factor * example.energy[b];
  }
  return Judge(rest, {}, SizeModel(rest)).judge(events);
}

std::vector<std::string> someVehicles(std::size_t count) {
  std::vector<std::string> names;
  std::size_t i = 0;
  for (const auto& [name, examples] : ofVehicles())
    if (i++ % 9 == 0 && examples.size() > 12 && names.size() < count) names.push_back(name);
  return names;
}

// Of vehicles drawn from the same ranges one in 500 is doubted as much as believed, one in ten more than a little.
TEST(JudgeDoubt, VehiclesThatItHasNotSeenAreAxleBoxes) {
  int believed = 0, count = 0;
  for (const auto& vehicle : someVehicles(6)) believed += judgedByOthers(vehicle, 1).front().axleBox > 0.8, ++count;
  EXPECT_EQ(count, 6);
  EXPECT_GE(believed, 5);
}

// Accelerations in g that were taken for m/s2 have a ninety-sixth of the energy. Light squats of a soft wheelset make
// as little: a few events may still be called squats, none of them surely, where three quarters of them are.
TEST(JudgeDoubt, AWrongUnitIsNoSquatSurely) {
  std::size_t squats = 0, all = 0;
  for (const auto& vehicle : someVehicles(3))
    for (const auto& judgement : judgedByOthers(vehicle, 1 / (9.80665 * 9.80665))) {
      squats += judgement.kind == Kind::squat, ++all;
      EXPECT_TRUE(judgement.kind != Kind::squat || judgement.sureness < 0.9) << judgement.sureness;
    }
  EXPECT_LE(3 * squats, all) << squats << " of " << all;
}

// All in the lowest and the highest band and nothing between them: no irregularity of a rail does that.
TEST(JudgeDoubt, WhatNothingKnownMakesIsOther) {
  std::vector<Example> all;
  for (const auto& [vehicle, examples] : ofVehicles()) all.insert(all.end(), examples.begin(), examples.end());
  EventFeatures event;
  event.speed = 30;
  event.freedom.fill(20), event.noise.fill(0.01), event.energy.fill(0.02);
  event.energy.front() = event.energy.back() = 300;
  const auto judged = Judge(all, {}, SizeModel(all)).judge({event});
  EXPECT_EQ(judged[0].kind, Kind::other);
}

// An event of which only the bands up to 900 Hz are seen.
TEST(JudgeDoubt, WithoutShortWavesNoKindIsSurerThanThreeQuarters) {
  const auto vehicle = someVehicles(1).front();
  std::vector<Example> all;
  for (const auto& [name, examples] : ofVehicles()) all.insert(all.end(), examples.begin(), examples.end());
  std::vector<EventFeatures> events;
  for (const auto& example : ofVehicles().at(vehicle)) {
    auto& event = events.emplace_back();
    event.speed = example.speed, event.energy = example.energy;
    event.freedom = {20, 20, 20, 20, 0, 0};
    event.energy[4] = event.energy[5] = 0;
  }
  for (const auto& judgement : Judge(all, {}, SizeModel(all)).judge(events))
    EXPECT_TRUE(judgement.kind == Kind::other || judgement.sureness <= 0.75) << judgement.sureness;
}

// The three add up, and the likeliest is the one that is named.
TEST(JudgeDoubt, EachSeverityHasAProbability) {
  for (const auto& judgement : judgedByOthers(someVehicles(1).front(), 1)) {
    EXPECT_NEAR(judgement.severities[0] + judgement.severities[1] + judgement.severities[2], 1, 1e-9);
    EXPECT_EQ(judgement.severities[static_cast<std::size_t>(judgement.severity)],
              *std::max_element(judgement.severities.begin(), judgement.severities.end()));
  }
}

}  // namespace
}  // namespace squat::detection
