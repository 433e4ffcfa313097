// Equilibrium of both rails and the whole wheelset: mirror images against the half model, and what statics says of
// loads, supports and a lateral force that differ from side to side.
#include "statics/WholeSystem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "statics/SteadyRollingStart.h"

namespace squat::statics {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

scenario::Scenario wholeScenario(Settings settings) {
  settings.insert(settings.begin(), {"model.extent", "whole"});
  return cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", settings});
}

// Both sides of a whole model, each with its own settings.
struct WholeTrack {
  model::Model left, right;
  std::vector<Equilibrium> found;
  WholeTrack(const Settings& ofLeft, const Settings& ofRight, int threads = 2)
      : left(model::buildModel(wholeScenario(ofLeft))), right(model::buildModel(wholeScenario(ofRight))) {
    ThreadTeam team(threads);
    Monitor quiet;
    WholeSystem system(left, right, elasticity::kernelsFor(""), team, 0);
    found = findEquilibria(system, left.startX, {}, quiet);
  }
};

model::Model halfModel() {
  return model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
}

double largestDifference(const AlignedVector& a, const AlignedVector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double largestOf(const AlignedVector& a) { return largestDifference(a, AlignedVector(a.size(), 0.0)); }

// The half model with its mirror is exact for sides that are alike; both solutions leave a residual of 1e-7 of the
// load, which track and wheelset answer with a displacement of that share.
TEST(WholeSystem, SidesThatAreAlikeStandAsTheHalfModelDoes) {
  const auto half = halfModel();
  ThreadTeam team(2);
  Monitor quiet;
  const auto expected = prepareSteadyRollingStart(half, elasticity::kernelsFor(""), team, quiet);
  const auto side = model::buildModel(wholeScenario({}));
  WholeSystem system(side, side, elasticity::kernelsFor(""), team, 0);
  const auto starts = prepareSteadyRolling(system, quiet);
  ASSERT_EQ(starts.size(), 2u);
  for (const auto& start : starts) {
    const auto& e = start.equilibrium;
    EXPECT_NEAR(e.contactForce, expected.equilibrium.contactForce, 1e-6 * expected.equilibrium.contactForce);
    EXPECT_NEAR(e.approach, expected.equilibrium.approach, 1e-5 * expected.equilibrium.approach);
    EXPECT_LT(largestDifference(e.displacement, expected.equilibrium.displacement),
              1e-5 * largestOf(expected.equilibrium.displacement));
    // Velocities are found to 1e-5 of the unbalanced force.
    EXPECT_LT(largestDifference(start.velocity, expected.velocity), 1e-3 * largestOf(expected.velocity));
  }
  // As many iterations as one half needs, but for those that round-off shifts: the coarse space sees both symmetries.
  EXPECT_LT(starts[0].equilibrium.iterations, 1.5 * expected.equilibrium.iterations);
}

// Loads F on the journals of a wheelset of weight 2 W are carried by N on the treads. About the track centre, at arms
// b of the journals and c + y of the contact: N_left + N_right = F_left + F_right + 2 W, (N_left - N_right) (c + y) =
// (F_left - F_right) b. The contact's place y is that of the pressure's centre on each side; what a rolling wheelset
// and a lateral force add (its height times the roll) is of the order of displacement over arm, 1e-3.
TEST(WholeSystem, WheelsCarryWhatLeversGiveThem) {
  const WholeTrack track({{"suspension.sprung_mass", "9000"}}, {{"suspension.sprung_mass", "6000"}});
  const auto& d = track.left.scenario;
  const auto& w = d.wheelset;
  const double g = d.motion.gravity, heavy = 9000 * g, light = 6000 * g;
  const auto &left = track.found[0], &right = track.found[1];
  const double all = heavy + light + 2 * w.totalMass * g;
  EXPECT_NEAR(left.contactForce + right.contactForce, all, 1e-6 * all);
  const double moment = left.contactForce * (w.trackCentre + left.centreLateral) -
                        right.contactForce * (w.trackCentre + right.centreLateral);
  const double expected = (heavy - light) * (w.trackCentre + w.bearingCentre);
  EXPECT_NEAR(moment, expected, 2e-3 * expected);
}

// A wheelset on cones at 1:40 that stands on the left with more load than on the right is pushed by the difference of
// the lateral forces, which the suspension of both boxes holds: 2 k y.
TEST(WholeSystem, SuspensionHoldsTheWheelsetLaterally) {
  const Settings cones{
      {"rail.inclination", "0.025"}, {"wheelset.cone", "0.025"}, {"suspension.lateral_stiffness", "3"}};
  Settings heavy = cones, light = cones;
  heavy.push_back({"suspension.sprung_mass", "9000"}), light.push_back({"suspension.sprung_mass", "6000"});
  const WholeTrack track(heavy, light);
  const auto outwards = [](const model::Model& model, const Equilibrium& e) {
    return ringLateralMean(model, model.bearing, e.displacement.data());
  };
  const double lateral = 0.5 * (outwards(track.left, track.found[0]) - outwards(track.right, track.found[1]));
  // Positive on the rail is outwards: the wheelset feels the opposite, towards the centre on either side.
  const double push = -(track.found[0].lateralForce - track.found[1].lateralForce);
  EXPECT_GT(std::abs(push), 100);
  EXPECT_NEAR(2 * 3e6 * lateral, push, 1e-3 * std::abs(push));
}

// Softer pads under the right rail alone. Equal loads at equal arms give equal shares, whatever is below; each rail
// then sinks as that of a half model with its pads, but for the sleepers: soft pads spread the load over more of them,
// which tilts those that both rails share. That is a small part of what the pads themselves make.
TEST(WholeSystem, SoftPadsLetOneRailSink) {
  const Settings soft{{"pad.stiffness", "150"}};
  const WholeTrack track({}, soft), stiffPads({}, {}), softPads(soft, soft);
  const auto &left = track.found[0], &right = track.found[1];
  const double load = left.contactForce + right.contactForce;
  EXPECT_NEAR(left.contactForce, 0.5 * load, 2e-3 * load);
  const auto hub = [](const WholeTrack& whole, std::size_t side) {
    const auto& model = side == 0 ? whole.left : whole.right;
    model::TurnedStations turned;
    model::turnStations(model.blocks[model.body], 0, turned);
    return ringMean(model, model.centre, turned, whole.found[side].displacement.data()).z;
  };
  const double stiffest = hub(stiffPads, 0), softest = hub(softPads, 0), made = stiffest - softest;
  ASSERT_GT(made, 0.1e-3);
  EXPECT_NEAR(hub(track, 0), stiffest, 0.1 * made);
  EXPECT_NEAR(hub(track, 1), softest, 0.1 * made);
}

TEST(WholeSystem, SameBitsForAnyNumberOfThreads) {
  const Settings heavy{{"suspension.sprung_mass", "9000"}};
  const WholeTrack one(heavy, {}, 1), three(heavy, {}, 3);
  for (std::size_t side : {0, 1}) EXPECT_EQ(one.found[side].displacement, three.found[side].displacement);
}

}  // namespace
}  // namespace squat::statics
