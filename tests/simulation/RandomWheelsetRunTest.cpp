// A wheelset of any shape rolls steadily on smooth rail before it comes to the defect: little residual vibration.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "RandomWheelsets.h"
#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "dynamics/StableStep.h"
#include "simulation/RunCase.h"
#include "statements/RunChecks.h"

namespace squat::simulation {
namespace {

// Tangential force half of what the paper's torque asks for: within friction for every wheelset.
tests::KeyValues driven(tests::KeyValues values) {
  const double radius = std::stod(
      std::find_if(values.begin(), values.end(), [](const auto& v) { return v.first == "wheelset.radius"; })->second);
  values.emplace_back("motion.torque", cases::formatDecimal(6225 * radius / 0.46));
  values.emplace_back("motion.beyond", "0.02");
  return values;
}

double stepOf(const cases::CaseDescription& description) {
  ThreadTeam team(2);
  Monitor quiet;
  return dynamics::stableStep(model::buildModel(cases::resolve(description)), elasticity::kernelsFor(""), team, quiet)
      .step;
}

// [Pa] of the axle between the wheels in bending: load of the axle box times its lever.
double axleStress(const tests::KeyValues& values) {
  const auto description = cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", values});
  const auto& w = description.wheelset;
  const double moment = description.suspension.sprungMass * description.motion.gravity * w.bearingCentre;
  const double outer = std::pow(w.axleRadius, 4), inner = std::pow(w.boreRadius, 4);
  return moment * 4 * w.axleRadius / (std::acos(-1.0) * (outer - inner));
}

// Largest vibration before the defect [m/s2]; nothing for a drawing that the mesh refuses or whose thin walls make the
// run take minutes.
std::optional<double> vibrationOf(const tests::KeyValues& values) {
  const auto description = cases::loadCase(tests::fixtureCase("smooth-rail"), {"tiny", driven(values)});
  constexpr double shortest = 0.25e-6;  // [s] a fifth of the default's step
  try {
    if (stepOf(description) < shortest) return std::nullopt;
  } catch (const CaseError&) {
    return std::nullopt;
  }
  RunOptions options;
  options.threads = 2;
  options.wheelsetModes = false;
  Monitor silent;
  return statements::residualVibration(runCase(description, options, silent)).value().largest;
}

// 95 % of the drawings whose axle bends to less than half of the yield strength, as those of real ones do. Slender
// axles tilt the wheel by milliradians; the linear kinematics of the model leave out what that does at speed
// (centrifugal stiffening), and these vibrate or lose the energy balance, which the run then reports.
TEST(RandomWheelsetRun, HasLittleResidualVibrationBeforeTheDefect) {
  constexpr double limit = 5;  // [m/s2]
  tests::RandomWheelsets wheelsets(20261123);
  int loud = 0, loudAndStout = 0, stout = 0, rolled = 0;
  while (rolled < 200) {
    const auto values = wheelsets.next();
    std::optional<double> vibration;
    try {
      vibration = vibrationOf(values);
    } catch (const RunError& error) {
      vibration = 1e3, std::printf("%s\n", error.what());
    }
    if (!vibration) continue;
    ++rolled;
    const double stress = axleStress(values);
    const bool isStout = stress < 160e6;
    const bool isLoud = *vibration > limit;
    stout += isStout, loud += isLoud, loudAndStout += isStout && isLoud;
    if (!isLoud) continue;
    std::string text;
    for (const auto& [key, value] : values) text += " " + key.substr(9) + "=" + value.substr(0, 5);
    std::printf("%3d of %3d: %.2f m/s2, %.0f MPa:%s\n", loud, rolled, *vibration, 1e-6 * stress, text.c_str());
    std::fflush(stdout);
  }
  std::printf("%d of 200 loud; of %d stout ones %d\n", loud, stout, loudAndStout);
  EXPECT_GT(stout, 100);
  EXPECT_LE(loudAndStout, 0.05 * stout);
  EXPECT_LE(loud, 30);  // 29 seen: 15 % with the slender axles, which the model does not cover
}

}  // namespace
}  // namespace squat::simulation
