// The coarse fields hold the rigid motions of the vehicle, so they alone find how it stands on a spring.
#include "statics/CoarseSpace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"

namespace squat::statics {
namespace {

// A force F on the sprung mass, held by one spring k to the ground and by the free wheelset below it: the mass moves by
// F / k, the wheelset with it and without strain, the rail not at all. Galerkin's projection is exact for a motion that
// lies in the space; what is left comes of the 1e-10 by which its diagonal is raised.
TEST(CoarseSpace, SpringOnTheSprungMassCarriesTheVehicle) {
  const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}));
  ThreadTeam team(1);
  model::StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 1e8, true);
  CoarseSpace coarse(model, op);
  Monitor quiet;
  ASSERT_TRUE(coarse.assemble(op, quiet));
  const double stiffness = 1e6, force = 5e3;
  op.contactSprings().add({{model.sprungZ, 1.0}}, stiffness, 0);
  coarse.factorise(op.contactSprings());
  AlignedVector r(model.stateSize, 0.0), z(model.stateSize, 0.0);
  r[model.sprungZ] = force;
  coarse.prolong(team, coarse.correctionOf(team, r.data()).y, z.data());
  const double expected = force / stiffness;
  EXPECT_NEAR(z[model.sprungZ], expected, 1e-4 * expected);
  const auto& rim = model.blocks[model.rim];
  for (int s = 0; s < rim.stationCount; ++s) {
    const Eigen::Vector3d up = elasticity::localBasis(rim, rim.positions[s]).transpose() * Eigen::Vector3d::UnitZ();
    for (int n = 0; n < rim.nodes; ++n)
      for (int c = 0; c < 3 && !model.slave[model.rim][n]; ++c) {
        ASSERT_NEAR(z[rim.index(n, c, s)], expected * up[c], 1e-4 * expected);
      }
  }
  const auto& rail = model.blocks[model.rail];
  for (int s = 0; s < rail.stationCount; ++s) ASSERT_NEAR(z[rail.index(0, 2, s)], 0, 1e-4 * expected);
}

// Rail elements longer than the usual distance of the hats: each hat still holds a station, and the correction of any
// load is a number.
TEST(CoarseSpace, HoldsOnElementsLongerThanItsUsualHats) {
  const auto model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"track.length", "10"}}}));
  double longest = 0;
  for (const auto& run : model.blocks[model.rail].stations.runs) longest = std::max(longest, run.length);
  ASSERT_GT(longest, 0.2);
  ThreadTeam team(2);
  model::StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 1e8, true);
  CoarseSpace coarse(model, op);
  Monitor quiet;
  ASSERT_TRUE(coarse.assemble(op, quiet));
  op.contactSprings().add({{model.sprungZ, 1.0}}, 1e6, 0);
  coarse.factorise(op.contactSprings());
  AlignedVector r(model.stateSize, 0.0), z(model.stateSize, 0.0);
  const auto& rail = model.blocks[model.rail];
  for (int s = 0; s < rail.stationCount; ++s) r[rail.index(0, 2, s)] = -1000;
  coarse.prolong(team, coarse.correctionOf(team, r.data()).y, z.data());
  // A kilonewton at each station, some hundred in all, on sleepers with some 10 MN/m of ballast each: down, by
  // millimetres.
  double maximum = 0;
  for (int s = 0; s < rail.stationCount; ++s) {
    const double down = -z[rail.index(0, 2, s)];
    ASSERT_GT(down, 0) << s;
    maximum = std::max(maximum, down);
  }
  EXPECT_LT(maximum, 0.01);
}

// Columns of unknowns that share a colour come from one product. Taken apart wrongly, they would not give the work of
// fields of all unknowns at once, which is computed here on the whole model. Round-off: 1e-9 of the largest work.
TEST(CoarseSpace, ItsMatrixGivesTheWorkOfItsFields) {
  using Keys = std::vector<std::pair<std::string, std::string>>;
  for (const Keys& keys : {Keys{{"mesh.wheel_sectors", "16"}}, Keys{{"track.length", "8"}},
                           Keys{{"mesh.far_size", "200"}, {"track.sleeper_spacing", "0.4"}}}) {
    SCOPED_TRACE(keys[0].first);
    const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", keys}));
    ThreadTeam team(1);
    model::StaticOperator op(model, elasticity::kernelsFor(""), team, 0, 1e8, true);
    CoarseSpace coarse(model, op);
    Monitor quiet;
    ASSERT_TRUE(coarse.assemble(op, quiet));
    std::vector<Eigen::VectorXd> amplitudes;
    std::vector<AlignedVector> fields, forces;
    for (int k = 0; k < 6; ++k) {
      amplitudes.push_back(Eigen::VectorXd::NullaryExpr(
          coarse.size(), [k](Eigen::Index i) { return std::sin(0.7 + static_cast<double>((i + 1) * (2 * k + 3))); }));
      fields.emplace_back(model.stateSize, 0.0), forces.emplace_back(model.stateSize, 0.0);
      coarse.prolong(team, amplitudes.back(), fields.back().data());
      op.apply(fields.back().data(), forces.back().data());
    }
    const Eigen::MatrixXd& stiffness = coarse.stiffness();
    const double largest = amplitudes[0].dot(stiffness * amplitudes[0]);
    for (std::size_t i = 0; i < fields.size(); ++i)
      for (std::size_t j = 0; j < fields.size(); ++j) {
        double work = 0;
        for (std::size_t k = 0; k < model.stateSize; ++k) work += fields[i][k] * forces[j][k];
        ASSERT_NEAR(amplitudes[i].dot(stiffness * amplitudes[j]), work, 1e-9 * largest) << i << ' ' << j;
      }
  }
}

}  // namespace
}  // namespace squat::statics
