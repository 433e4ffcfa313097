// A right brick whose one node is moved along an edge turns over exactly when the node passes its neighbour: the
// Jacobian at that corner is the product of the three edges, of which one has the length h - displacement.
#include "model/InvertedElement.h"

#include <gmock/gmock.h>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::model {
namespace {

using ::testing::HasSubstr;

const Model& tinyModel() {
  static const Model model = [] {
    cases::CaseOverrides overrides;
    overrides.preset = "tiny";
    return buildModel(cases::loadScenario(tests::fixtureCase("light-defect"), overrides));
  }();
  return model;
}

std::string judged(int block, int component, double share) {
  const auto& model = tinyModel();
  const auto& b = model.blocks[block];
  const int node = b.section.quads[b.section.quads.size() / 2][0], station = b.intervals / 2;
  double interval = b.positions[station + 1] - b.positions[station];
  if (b.kind == elasticity::SweepKind::aroundAxis) interval *= b.section.nodes[node][0];
  AlignedVector u(model.stateSize, 0.0);
  u[b.index(node, component, station)] = share * interval;
  ThreadTeam team(2);
  auto location = invertedElement(model, u);
  EXPECT_EQ(invertedElement(model, u, &team), location) << "two threads find another element than one";
  return location;
}

TEST(InvertedElement, ABrickTurnsOverWhenANodePassesItsNeighbour) {
  const int rail = tinyModel().rail;
  EXPECT_EQ(judged(rail, 0, 0.999), "");
  EXPECT_THAT(judged(rail, 0, 1.001), HasSubstr("rail"));
  EXPECT_EQ(judged(rail, 0, -0.999), "");
  EXPECT_THAT(judged(rail, 0, -1.001), HasSubstr("rail"));
}

// Around the axis the edges are chords, which lean by half the sector's angle: the point of turning shifts by up to
// angle / 2 times the ratio of the edges, 0.23 for the coarsest sectors of the body.
TEST(InvertedElement, SectorsOfTheWheelAreJudgedAlike) {
  for (const int block : {tinyModel().rim, tinyModel().body}) {
    EXPECT_EQ(judged(block, 0, 0.5), "");
    EXPECT_NE(judged(block, 0, 1.5), "");
  }
}

TEST(InvertedElement, RigidMotionAndHealthyStrainAreNoMatter) {
  const auto& model = tinyModel();
  const auto& rail = model.blocks[model.rail];
  AlignedVector u(model.stateSize, 0.0);
  for (int n = 0; n < rail.nodes; ++n)
    for (int s = 0; s <= rail.intervals; ++s) {
      u[rail.index(n, 0, s)] = 0.1 - 0.01 * rail.positions[s];  // 1 % of compression
      u[rail.index(n, 2, s)] = -0.5;
    }
  EXPECT_EQ(invertedElement(model, u), "");
}

}  // namespace
}  // namespace squat::model
