// Shares of a step: everything is done once, whatever the cuts, and cuts follow what else a thread has to do.
#include "dynamics/StepShares.h"

#include <gtest/gtest.h>

#include <map>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::dynamics {
namespace {

const model::Model& smoothRail() {
  static const model::Model model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  return model;
}

class Shares : public testing::TestWithParam<std::vector<double>> {};

TEST_P(Shares, AdvanceEachStationOnce) {
  const auto& model = smoothRail();
  const auto shares = shareStep(model, GetParam());
  std::map<int, std::vector<int>> times;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
    times[b].assign(static_cast<std::size_t>(model.blocks[b].intervals), 0);
  for (const auto& own : shares.threads)
    for (const auto* work : {&own.stations, &own.masters})
      for (const auto& segment : *work)
        for (int s = 0; s < segment.count; ++s) ++times[segment.block].at(segment.first + s);
  for (const auto& sleeper : shares.sleepers)
    for (const auto& segment : sleeper.stations)
      for (int s = 0; s < segment.count; ++s) ++times[segment.block].at(segment.first + s);
  for (const auto& [block, stations] : times)
    EXPECT_EQ(stations, std::vector<int>(stations.size(), 1)) << "block " << block;
}

TEST_P(Shares, HoldEachFixedUnknownAndForceElementOnce) {
  const auto& model = smoothRail();
  const auto shares = shareStep(model, GetParam());
  std::map<std::size_t, int> fixed;
  for (const auto& own : shares.threads)
    for (const auto unknown : own.fixed) ++fixed[unknown];
  for (const auto& sleeper : shares.sleepers)
    for (const auto unknown : sleeper.fixed) ++fixed[unknown];
  EXPECT_EQ(fixed.size(), model.fixed.size());
  for (const auto unknown : model.fixed) EXPECT_EQ(fixed[unknown], 1);
  std::size_t elements = 0, asked = 0;
  std::map<std::size_t, int> groups;
  const auto count = [&](const forces::ForceShare& share) {
    elements += share.elements.size();
    for (const auto group : share.groups) ++groups[group];
  };
  count(shares.vehicleForces);
  for (const auto& share : shares.trackForces) count(share);
  for (const auto& set : model.forceElements) asked += set.size();
  EXPECT_EQ(elements, asked);
  EXPECT_EQ(groups.size(), shares.forceGroups);
  for (const auto& [group, times] : groups) EXPECT_EQ(times, 1) << "group " << group;
}

INSTANTIATE_TEST_SUITE_P(Threads, Shares,
                         testing::Values(std::vector<double>{0}, std::vector<double>{0, 0},
                                         std::vector<double>{4000, 0}, std::vector<double>{0, 9000},
                                         std::vector<double>{2500, 0, 0}, std::vector<double>{1e6, 0, 0},
                                         std::vector<double>(8, 0.0)));

double nodesOf(const ThreadShare& own) {
  double nodes = 0;
  for (const auto* work : {&own.stations, &own.masters})
    for (const auto& segment : *work)
      nodes += static_cast<double>(segment.count) * smoothRail().blocks[segment.block].nodes;
  return nodes;
}

// Of further work, half is taken off the thread's stations; pieces are sixteen stations of the rail.
TEST(StepShares, MoreOtherWorkMeansFewerStations) {
  const auto& model = smoothRail();
  const double piece = 16.0 * model.blocks[model.rail].nodes;
  // The first cut lies in the rail already, whose nodes count as one.
  const double some = nodesOf(shareStep(model, {3000, 0}).threads.front()),
               less = nodesOf(shareStep(model, {11000, 0}).threads.front());
  EXPECT_NEAR(some - less, 4000, piece);
}

TEST(StepShares, FarTooMuchOtherWorkMeansNone) {
  EXPECT_TRUE(shareStep(smoothRail(), {1e6, 0}).threads.front().stations.empty());
}

}  // namespace
}  // namespace squat::dynamics
