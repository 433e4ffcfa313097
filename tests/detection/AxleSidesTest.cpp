// On which rail the defect is that both axle boxes of a wheelset feel.
#include "detection/AxleSides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "case/ShippedCases.h"
#include "detection/Examples.h"
#include "detection/Sides.h"

namespace squat::detection {
namespace {

constexpr double meanRatio = 1, ratioSpread = 0.4;  // of log10 of the ratio of energies

// Twelve ratios on both sides of the mean each.
std::vector<Example> knownExamples() {
  std::vector<Example> examples;
  for (const char* vehicle : {"one", "two", "three"})
    for (int i = 0; i < 8; ++i) {
      Example example;
      example.vehicle = vehicle;
      example.arrival = {1, std::pow(10, -(meanRatio + (i % 2 ? ratioSpread : -ratioSpread)))};
      examples.push_back(example);
    }
  return examples;
}

// Energies whose ratio has this logarithm to the base of ten.
FirstArrival arrivalOf(double ratio, double noise = 0) {
  return {{1 + noise, std::pow(10, -ratio) + noise}, {noise, noise}};
}

// Two normal densities of one spread with means m and -m: the logarithm of the odds at r is 2 m r / S^2. S^2: 24 values
// of +-0.4 around their mean have a variance of 0.16 * 24/23; beside it stands 0.1^2 twice, to which each energy is
// known at best (AxleSides.cpp).
TEST(AxleSides, OddsAreThoseOfTwoNormalDensities) {
  const AxleSides sides(knownExamples());
  const double variance = ratioSpread * ratioSpread * 24 / 23 + 2 * 0.1 * 0.1;
  for (const double ratio : {0.05, 0.1, 0.2}) {
    const auto judged = sides.judge(arrivalOf(ratio), Kind::squat);
    const double expected = 2 * meanRatio * ratio / variance;
    // Ratios beyond four spreads, 6e-5 of their density, are not integrated over.
    EXPECT_NEAR(std::log(judged.probability[0] / judged.probability[1]), expected, 0.01 * expected) << ratio;
  }
}

TEST(AxleSides, ExchangedSidesGiveTheOtherSide) {
  const AxleSides sides(knownExamples());
  auto arrival = arrivalOf(1, 0.02);
  const auto left = sides.judge(arrival, Kind::squat);
  std::swap(arrival.energy[0], arrival.energy[1]);
  const auto right = sides.judge(arrival, Kind::squat);
  EXPECT_EQ(left.side(), RailSide::left);
  EXPECT_EQ(right.side(), RailSide::right);
  EXPECT_DOUBLE_EQ(left.sureness(), right.sureness());
  EXPECT_DOUBLE_EQ(left.probability[2], right.probability[2]);
}

// Alike energies are those of two defects, one on each rail: a single one leaves a tenth of the energy to the other
// box.
TEST(AxleSides, AlikeEnergiesComeFromBothRails) {
  const auto judged = AxleSides(knownExamples()).judge(arrivalOf(0), Kind::joint);
  EXPECT_EQ(judged.side(), RailSide::both);
  EXPECT_GT(judged.sureness(), 0.9);
}

// Where the noise has a hundred times the energy of the signal, neither side is known better than the other.
TEST(AxleSides, NoiseTellsNoSide) {
  const auto judged = AxleSides(knownExamples()).judge(arrivalOf(1, 100), Kind::squat);
  EXPECT_NEAR(judged.probability[0], judged.probability[1], 0.1);
}

// The struck box feels the more, the surer its side is: noise as loud as all that the other box shows never speaks for
// that one.
TEST(AxleSides, AreTheSurerTheLouderTheOnlyBoxIs) {
  const AxleSides sides(knownExamples());
  double before = 0.9;
  for (const double energy : {10.0, 30.0, 100.0, 1000.0, 1e5}) {
    const auto judged = sides.judge({{energy, 1}, {1, 1}}, Kind::squat);
    EXPECT_EQ(judged.side(), RailSide::left) << energy;
    EXPECT_GE(judged.sureness(), before) << energy;
    before = judged.sureness();
  }
}

TEST(AxleSides, AreNotKnownByFewExamples) {
  auto examples = knownExamples();
  examples.resize(16);  // of two vehicles
  EXPECT_FALSE(AxleSides(examples).isKnown());
  examples = knownExamples();
  for (auto& example : examples) example.arrival.reset();
  EXPECT_FALSE(AxleSides(examples).isKnown());
}

// Of the shipped examples, vehicle by vehicle, by those of the others; each as it is, and in noise that has a thirtieth
// of the energy of the struck box. One in twenty may be taken for another side: ratios are not quite normal.
TEST(AxleSides, OfVehiclesThatTheyHaveNotSeenAreRight) {
  auto all = readExamples((cases::resourcesFolder() / "detection/examples.csv").string());
  std::erase_if(all, [](const Example& example) { return !example.arrival; });
  std::set<std::string> vehicles;
  for (const auto& example : all) vehicles.insert(example.vehicle);
  ASSERT_GE(vehicles.size(), 8U);
  for (const double share : {0.0, 1.0 / 30}) {
    std::size_t right = 0;
    for (const auto& vehicle : vehicles) {
      auto others = all;
      std::erase_if(others, [&](const Example& example) { return example.vehicle == vehicle; });
      const AxleSides sides(others);
      for (const auto& example : all) {
        if (example.vehicle != vehicle) continue;
        const auto& [own, other] = *example.arrival;
        const double noise = share * own;
        right += sides.judge({{own + noise, other + noise}, {noise, noise}}, example.kind).side() == RailSide::left;
      }
    }
    EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(all.size())) << share;
  }
}

Event eventWith(double position, double score, double ratio) {
  Event event;
  event.position = event.travelled = position, event.score = score;
  event.kind = Kind::squat;
  event.arrival = arrivalOf(ratio);
  return event;
}

RecordDetection twoChannels(std::vector<Event> left, std::vector<Event> right) {
  RecordDetection detection;
  detection.channels.resize(2);
  detection.channels[0].events = std::move(left), detection.channels[1].events = std::move(right);
  detection.axles = {{0, 1}};
  return detection;
}

// A squat on the left at 10 m, felt on the right; one on the right at 20 m; one on each rail at 30 m; one on the left
// at 40 m that the right channel does not show. The ratio is that of the own box to the other one.
TEST(Sides, CrosstalkIsNoEventOfItsOwn) {
  auto found = twoChannels({eventWith(10, 50, 1), eventWith(20.1, 20, -1), eventWith(30, 50, 0), eventWith(40, 50, 1)},
                           {eventWith(10.1, 20, -1), eventWith(20, 50, 1), eventWith(30, 50, 0)});
  judgeSides(found, AxleSides(knownExamples()));
  const auto placesOf = [&](std::size_t channel) {
    std::vector<std::pair<double, RailSide>> places;
    for (const auto& event : found.channels[channel].events) places.emplace_back(event.position, event.side->side());
    return places;
  };
  using Places = std::vector<std::pair<double, RailSide>>;
  EXPECT_EQ(placesOf(0), (Places{{10, RailSide::left}, {30, RailSide::both}, {40, RailSide::left}}));
  EXPECT_EQ(placesOf(1), (Places{{20, RailSide::right}, {30, RailSide::both}}));
}

// A squat on the left at 10 m and another on the right at 10.2 m, each of which moves its own box first.
TEST(Sides, TwoDefectsNearEachOtherAreBothListed) {
  auto found = twoChannels({eventWith(10, 50, 1)}, {eventWith(10.2, 80, 1)});
  judgeSides(found, AxleSides(knownExamples()));
  EXPECT_EQ(found.channels[0].events.size(), 1U);
  EXPECT_EQ(found.channels[1].events.size(), 1U);
}

// The closest are one: not the first on the left, 0.2 m away, but the second, 0.1 m away.
TEST(Sides, TheClosestEventsArePaired) {
  auto found = twoChannels({eventWith(10, 50, 1), eventWith(10.3, 50, 1)}, {eventWith(10.2, 20, -1)});
  judgeSides(found, AxleSides(knownExamples()));
  EXPECT_EQ(found.channels[0].events.size(), 2U);
  EXPECT_TRUE(found.channels[1].events.empty());
}

// A user who has seen something on one channel speaks for both; two labels are two defects.
TEST(Sides, LabelledEventsStay) {
  auto found =
      twoChannels({eventWith(10, 50, 1), eventWith(20, 50, 1)}, {eventWith(10.1, 20, -1), eventWith(20.1, 20, -1)});
  found.channels[1].events[0].label = found.channels[0].events[1].label = found.channels[1].events[1].label = Label{};
  judgeSides(found, AxleSides(knownExamples()));
  ASSERT_EQ(found.channels[0].events.size(), 1U);
  EXPECT_EQ(found.channels[0].events[0].position, 20);
  EXPECT_EQ(found.channels[1].events.size(), 2U);
}

TEST(Sides, ChannelsWithoutAxlesStayAsTheyAre) {
  auto found = twoChannels({eventWith(10, 50, 1)}, {eventWith(10.1, 20, -1)});
  found.axles.clear();
  judgeSides(found, AxleSides(knownExamples()));
  EXPECT_EQ(found.channels[1].events.size(), 1U);
  EXPECT_FALSE(found.channels[0].events[0].side);
}

}  // namespace
}  // namespace squat::detection
