// Equilibrium of a wheel that is not round: how far it comes down on its flat.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "statics/Equilibrium.h"
#include "statics/SteadyRollingStart.h"

namespace squat::statics {
namespace {

// A chord of 60 mm cut off the tread, in points 1 mm apart: 60^2 / (8 x 460) = 0.978 mm.
std::string chordFlat() {
  constexpr double radius = 460, half = 30;
  std::string points;
  for (int i = -40; i <= 40; ++i) {
    const double chord = std::sqrt(radius * radius - half * half) / std::cos(i / radius) - radius;
    const double deviation = std::abs(i) < half ? std::min(0.0, chord) : 0.0;
    points += (points.empty() ? "[[" : ", [") + std::to_string(i) + ", " + std::to_string(deviation) + "]";
  }
  return points + "]";
}

struct Stand {
  model::Model model;
  Equilibrium equilibrium;
};

// At x, turned as far as the wheel has rolled.
Stand standAt(double x, const std::string& mesh = "tiny") {
  Stand s;
  s.model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {mesh,
                                                                                {{"wheelset.tread_points", chordFlat()},
                                                                                 {"motion.run_up", "0.2"},
                                                                                 {"mesh.contact_size", "2.5"},
                                                                                 {"mesh.rolling_size", "5"}}}));
  ThreadTeam team(1);
  Monitor quiet;
  s.equilibrium = findEquilibrium(s.model, elasticity::kernelsFor(""), team, x,
                                  (x - s.model.startX) / s.model.surfaces.radius, {}, quiet);
  return s;
}

// Rigid: pivoting about the flat's edge, R (1 - cos(half - |x| / R)); 0.98 mm on the flat itself. Tolerance 15 um, a
// contact point every 1.2 mm and the corner's rounding between points. The load is carried whatever the wheel stands
// on.
TEST(TreadEquilibrium, TheWheelComesDownOnItsFlat) {
  const double radius = 0.46, half = std::asin(0.030 / radius);
  for (const double x : {0.0, 0.012}) {
    const auto s = standAt(x);
    const auto& d = s.model.scenario;
    const double weight = d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
    EXPECT_NEAR(s.equilibrium.contactForce, weight, 1e-6 * weight) << x;
    EXPECT_NEAR(s.equilibrium.rigidHeight, -radius * (1 - std::cos(half - x / radius)), 15e-6) << x;
    EXPECT_LT(s.equilibrium.residual, 1e-7) << x;
    // Elastic on top: some 0.1 mm as of a round wheel (Hertz: 0.0955 mm for 87.8 kN), less where flat meets plane.
    EXPECT_GT(s.equilibrium.approach, 0.01e-3) << x;
    EXPECT_LT(s.equilibrium.approach, 0.20e-3) << x;
  }
}

// Away from the flat the wheel is the round one.
TEST(TreadEquilibrium, OffTheFlatTheWheelIsRound) {
  const auto flat = standAt(-0.15);
  EXPECT_NEAR(flat.equilibrium.rigidHeight, 0, 2e-6);  // a contact point within 1.2 mm: x^2 / 2R below 1.6 um
  const auto round = [&] {
    const auto model = model::buildModel(
        cases::loadScenario(tests::fixtureCase("smooth-rail"),
                            {"tiny",
                             {{"motion.run_up", "0.2"},
                              {"mesh.contact_size", "2.5"},
                              {"mesh.rolling_size", "5"},
                              {"mesh.zone_before", std::to_string(1e3 * flat.model.scenario.tread.dipBefore())},
                              {"mesh.zone_behind", std::to_string(1e3 * flat.model.scenario.tread.dipBehind())}}}));
    ThreadTeam team(1);
    Monitor quiet;
    return findEquilibrium(model, elasticity::kernelsFor(""), team, -0.15,
                           (-0.15 - model.startX) / model.surfaces.radius, {}, quiet);
  }();
  // The same mesh and load: equal to what the equilibrium is solved to, 1e-7 of the load, and the first touch of 2 um.
  EXPECT_NEAR(flat.equilibrium.peakPressure, round.peakPressure, 1e-4 * round.peakPressure);
  EXPECT_NEAR(flat.equilibrium.approach, round.approach, 2e-6);
}

// An eccentric tread rolls quietly from the start: the wheel rises with it, e sin(angle) at the speed R w.
TEST(TreadEquilibrium, TheStartRisesWithAnEccentricTread) {
  constexpr double eccentricity = 0.5, radius = 460;  // [mm]
  std::string points;
  constexpr int count = 720;
  for (int i = 0; i < count; ++i)
    points += (points.empty() ? "[[" : ", [") + std::to_string(2 * std::acos(-1.0) * radius * i / count) + ", " +
              std::to_string(-eccentricity * std::cos(2 * std::acos(-1.0) * i / count)) + "]";
  const auto startOf = [](const std::vector<std::pair<std::string, std::string>>& values) {
    const auto model = model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", values}));
    ThreadTeam team(1);
    Monitor quiet;
    const auto start = prepareSteadyRollingStart(model, elasticity::kernelsFor(""), team, quiet);
    model::TurnedStations turned;
    model::turnStations(model.blocks[model.body], 0, turned);
    return std::pair{model::ringMean(model, model.centre, turned, start.velocity.data()).z, model.startX};
  };
  const auto [round, x] = startOf({});
  const auto [eccentric, same] = startOf({{"wheelset.tread_points", points + "]"}});
  const double angle = x / 0.46, speed = 30;  // deepest point at x = 0
  const double expected = speed * eccentricity * 1e-3 / 0.46 * std::sin(angle);
  EXPECT_GT(std::abs(expected), 0.005);
  // 720 points a turn, 25 from the deepest: the monotone cubic's slope errs by 1 / (4 25^2) there, the difference of
  // the path over 10 mm less; 1 % for how the rail's deflection differs.
  EXPECT_NEAR(eccentric - round, expected, 0.02 * std::abs(expected));
}

}  // namespace
}  // namespace squat::statics
