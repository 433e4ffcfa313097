// A sleeper under the wheel with a void below it: the load that its ballast takes.
// Theory: Timoshenko beam on the same seats (TrackBeam.h), the ballast under the void as springs that carry once their
// gap has closed. Tolerance: as for the deflection of the rail (RailDeflectionTest), 3 % of what the ballast would
// carry without the gap for the same deflection.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "statics/Equilibrium.h"
#include "verification/Seen.h"
#include "verification/TrackBeam.h"

namespace squat::verification {
namespace {

struct Voided {
  double load = 0, expected = 0;  // [N] on the ballast under the void
  double contactForce = 0;        // [N]
  int newtonSteps = 0;
};

// The wheel stands over sleeper -1.
Voided voided(const std::string& gap) {
  const auto description = cases::loadScenario(tests::fixtureCase("smooth-rail"),
                                               {"tiny",
                                                {{"track.length", "9"},
                                                 {"motion.run_up", "0.6"},
                                                 {"mesh.far_size", "100"},
                                                 {"mesh.section_size", "16"},
                                                 {"track.seats", "[{ sleeper = -1, gap = " + gap + " }]"}}});
  const auto model = model::buildModel(description);
  ThreadTeam team(1);
  Monitor quiet;
  const auto e = statics::findEquilibrium(model, elasticity::kernelsFor(""), team, model.startX, 0, {}, quiet);
  Voided found;
  found.contactForce = e.contactForce, found.newtonSteps = e.newtonSteps;
  for (const auto& set : model.forceElements)
    for (std::size_t i = 0; set.kind == forces::Kind::ballast && set.law && i < set.size(); ++i)
      found.load -= set.elasticForce(i, set.elongation(i, e.displacement.data()));
  const auto& rail = model.blocks[model.rail];
  const TrackBeam beam(description, beamSection(rail.section), rail.positions.front(), model.sleeperPositions);
  found.expected = beam.voidedLoad(model.startX, e.contactForce);
  return found;
}

TEST(VoidedSleeper, TakesTheLoadThatABeamLeavesIt) {
  constexpr double ballast = 45e6;  // [N/m]
  double before = 1e9;
  for (const auto& [gap, metres] : {std::pair{"0", 0.0}, {"0.2", 0.2e-3}, {"0.5", 0.5e-3}}) {
    const auto found = voided(gap);
    EXPECT_GT(found.expected, 1e3) << gap;
    EXPECT_LT(found.expected, before) << gap;
    EXPECT_NEAR(found.load, found.expected, 0.03 * (found.expected + ballast * metres)) << gap << " mm";
    seen("load", 100 * (found.load - found.expected) / (found.expected + ballast * metres), "%");
    EXPECT_NEAR(found.contactForce, 9.81 * 8950, 0.1) << gap;
    EXPECT_LE(found.newtonSteps, 15) << gap;
    before = found.expected;
  }
}

TEST(VoidedSleeper, HangsWhereTheVoidIsDeep) {
  const auto found = voided("20");
  EXPECT_EQ(found.load, 0);
  EXPECT_EQ(found.expected, 0);
  EXPECT_NEAR(found.contactForce, 9.81 * 8950, 0.1);
}

}  // namespace
}  // namespace squat::verification
