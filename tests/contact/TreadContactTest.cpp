// Contact of a wheel that is not round, rigid bodies without friction: what the pressure does follows from its energy.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "contact/RollingContact.h"
#include "model/Model.h"

namespace squat::contact {
namespace {

constexpr ContactLaw frictionless{1e14, 0.7e14, 0};

// A cosine dip of 60 mm and 0.6 mm in the tread, which meets the rail at the start, on a mesh that is fine there.
model::Model dipModel() {
  std::string points;
  for (int i = -30; i <= 30; ++i) {
    const double depth = -0.3 * (1 + std::cos(3.14159265358979 * i / 30));
    points += (points.empty() ? "[[" : ", [") + std::to_string(i) + ", " + std::to_string(depth) + "]";
  }
  return model::buildModel(
      cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny",
                                                              {{"wheelset.tread_points", points + "]"},
                                                               {"wheelset.tread_position", "0"},
                                                               {"mesh.contact_size", "2"},
                                                               {"mesh.rolling_size", "4"}}}));
}

class TreadContact : public testing::Test {
 protected:
  TreadContact() : model_(dipModel()), rest_(model_.stateSize, 0.0) {
    for (const auto& [block, nodes, lineOfNode, buffer] :
         {std::tuple{model_.rail, &model_.surfaces.railLine, &railLines_, &railBuffer_},
          std::tuple{model_.rim, &model_.surfaces.treadLine, &rimLines_, &rimBuffer_}}) {
      lineOfNode->assign(static_cast<std::size_t>(model_.blocks[block].nodes), -1);
      int next = 0;
      for (const int node : *nodes) (*lineOfNode)[static_cast<std::size_t>(node)] = next++;
      buffer->assign(static_cast<std::size_t>(next) * 3 * model_.blocks[block].stride, 0.0);
    }
  }

  // The wheel as a rigid body, its axis `sunk` below and `ahead` of where it stands at x, turned as far as it rolled
  // to there and by `turned` more. Displacements stay at rest: the reference of the axis is moved.
  PatchState press(double x, double sunk, double turned = 0, double ahead = 0) {
    WheelRolling wheel;
    wheel.placement = {x + ahead, model_.wheelset.centreHeight - sunk,
                       (x - model_.startX) / model_.surfaces.radius + turned, 0, 0};
    FrictionHistory history;
    history.traction.assign(2 * model_.surfaces.points(), 0.0);
    return rollContact({model_.surfaces, model_.blocks[model_.rail], model_.blocks[model_.rim], frictionless},
                       {wheel, rest_.data(), rest_.data(), 1e-7}, history,
                       {{railBuffer_.data(), railLines_.data()}, {rimBuffer_.data(), rimLines_.data()}});
  }

  model::Model model_;
  AlignedVector rest_;
  std::vector<int> railLines_, rimLines_;
  std::vector<double> railBuffer_, rimBuffer_;
};

// Energy of the pressed contact, W = sum of k A delta^2 / 2. Its derivatives by lowering the axis, by moving it along
// and by turning the wheel are the vertical force, the force along and less the moment. Tolerance 1 % of the largest:
// points that close and open within the difference, and delta's own second order in the tilt, tilt^2 = 0.1 %.
TEST_F(TreadContact, ForcesAndMomentAreTheDerivativesOfTheEnergy) {
  constexpr double difference = 1e-7;  // [m]
  const double radius = model_.surfaces.radius;
  double largestMoment = 0;
  for (const double x : {-0.030, -0.015, 0.012, 0.020}) {
    // So far down that the pressed wheel closes dozens of points: found by lowering it.
    double sunk = 0;
    while (press(x, sunk).vertical < 5e4) sunk += 1e-5;
    const auto state = press(x, sunk);
    const auto slope = [&](auto&& at) {
      return (at(difference).storedEnergy - at(-difference).storedEnergy) / (2 * difference);
    };
    const double down = slope([&](double s) { return press(x, sunk + s); });
    const double along = slope([&](double s) { return press(x, sunk, 0, s); });
    const double turning = slope([&](double s) { return press(x, sunk, s / radius); });
    EXPECT_NEAR(state.vertical, down, 0.01 * down) << x;
    EXPECT_NEAR(state.longitudinal, along, 0.01 * down) << x;
    EXPECT_NEAR(state.rotationMoment, -turning * radius, 0.01 * down * 0.04) << x;
    largestMoment = std::max(largestMoment, std::abs(state.rotationMoment));
  }
  // On the slope of the dip the force has a lever: up to 0.03 of the radius.
  EXPECT_GT(largestMoment, 5e4 * 0.005);
}

// On plane rail a frictionless wheel is pushed straight up, however its tread leans: the resultant along the rail is
// that of a patch that is not quite even, some 1e-3 of the load, where a normal along the radius would push with the
// sine of the angle of contact, 0.02 to 0.04.
TEST_F(TreadContact, PlaneRailPushesUpwards) {
  for (const double x : {-0.025, -0.015, 0.015, 0.025}) {
    double sunk = 0;
    while (press(x, sunk).vertical < 5e4) sunk += 1e-5;
    const auto state = press(x, sunk);
    EXPECT_LT(std::abs(state.longitudinal), 3e-3 * state.vertical) << x;
  }
}

// A rigid wheel sinks into its own dip until it touches: d(a) - x^2 / 2R, largest where the tangent is level.
TEST_F(TreadContact, TheGapHasTheDeviation) {
  const double radius = model_.surfaces.radius;
  double expected = -1;
  for (double x = -0.06; x < 0.06; x += 1e-5) {
    const double d = std::abs(x) < 0.03 ? -0.3e-3 * (1 + std::cos(3.14159265358979 * x / 0.03)) : 0.0;
    expected = std::max(expected, d - x * x / (2 * radius));
  }
  double sunk = 0;
  while (press(0, sunk).points == 0) sunk += 1e-6;
  // Contact points stand 1.2 mm apart: at 0.02 mm they miss x^2 / 2R = 1 um here; steps of 1 um.
  EXPECT_NEAR(sunk, -expected, 4e-6);
}

}  // namespace
}  // namespace squat::contact
