// The half wheelset as the roughness sees it.
#include <gtest/gtest.h>

#include <cmath>

#include "FixtureCase.h"
#include "case/Resolve.h"
#include "model/WheelsetModes.h"
#include "roughness/TransferFunction.h"
#include "scenario/WheelsetMass.h"

namespace squat::roughness {
namespace {

scenario::Scenario wheelsetOf() { return cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}}); }

// Far below its first mode, a mass on the primary suspension, whose other end the sprung mass holds:
// 1 / (Z - m w^2), Z = 1 / (1 / (k + i w c) - 1 / (M w^2)). What the modes add is their static flexibility, seen below.
TEST(WheelsetReceptance, IsARigidMassOnItsSuspensionAtLowFrequencies) {
  auto scenario = wheelsetOf();
  scenario.suspension.stiffness = 1.5e6, scenario.suspension.damping = 20e3;  // so that it shows
  const double mass = scenario::wheelsetMass(scenario.wheelset);
  double flexibility = 0;
  for (const auto& mode : model::wheelsetModes(scenario, 6000, 6))
    flexibility +=
        std::pow((std::abs(mode.contactAmplitude) + std::abs(mode.boxAmplitude)) / (2 * M_PI * mode.frequency), 2);
  for (const double f : {9.0, 12.0}) {
    const double omega = 2 * M_PI * f;
    const std::complex<double> spring(scenario.suspension.stiffness, omega * scenario.suspension.damping);
    const auto held = 1.0 / (1.0 / spring - 1 / (scenario.suspension.sprungMass * omega * omega));
    const auto expected = 1.0 / (held - mass * omega * omega);
    const auto found = wheelsetReceptances(scenario, {f}).front();
    EXPECT_LT(std::abs(found.contact - expected), 2 * flexibility) << f;
    EXPECT_LT(std::abs(found.box - expected), 2 * flexibility) << f;
    EXPECT_GT(std::abs(expected), 5 * flexibility) << "the mass counts";
  }
}

// At a natural frequency with a damping ratio D a receptance has the peak share^2 / (2 D w^2), beside what the other
// modes and the mass add.
TEST(WheelsetReceptance, HasThePeaksOfItsModes) {
  auto scenario = wheelsetOf();
  scenario.suspension.stiffness = scenario.suspension.damping = 0;
  scenario.wheelset.dampingRatio = 1e-4, scenario.wheelset.dampingLimit = 3000;
  for (const auto& mode : model::wheelsetModes(scenario, 1500, 1)) {
    if (mode.harmonic != 1 || std::abs(mode.boxAmplitude * mode.contactAmplitude) < 1e-5) continue;
    const double omega = 2 * M_PI * mode.frequency, peak = 1 / (2e-4 * omega * omega);
    const auto found = wheelsetReceptances(scenario, {mode.frequency}).front();
    EXPECT_NEAR(std::abs(found.box) / (std::abs(mode.boxAmplitude * mode.contactAmplitude) * peak), 1, 0.1)
        << mode.frequency;
  }
}

// A steady force Q outwards at the tread bends the axle by the moment Q R, constant up to the mirror at the track
// centre: the wheel tilts by Q R L / (E I), its tread moves out by R times that. The seat below the hub is stiffer than
// the axle body, so that L ends between the hub's inner face and its middle. The web is as thick as the hub here: its
// own bending adds little.
TEST(WheelsetReceptance, TreadGivesWayAsTheAxleBends) {
  auto scenario = wheelsetOf();
  auto& w = scenario.wheelset;
  w.webThickness = 0.12, w.webHubThickness = 0, w.webOffset = 0;
  const double inertia = M_PI / 4 * (std::pow(w.axleRadius, 4) - std::pow(w.boreRadius, 4));
  const auto tilted = [&](double length) { return w.radius * w.radius * length / (w.material.young * inertia); };
  const auto found = wheelsetReceptances(scenario, {2.0}).front();
  EXPECT_GT(found.lateral.real(), tilted(w.trackCentre - w.hubWidth / 2));
  EXPECT_LT(found.lateral.real(), 1.2 * tilted(w.trackCentre));
}

}  // namespace
}  // namespace squat::roughness
