#include <cmath>
#include <numbers>

#include "model/WheelsetModes.h"
#include "roughness/TransferFunction.h"
#include "scenario/Scenario.h"
#include "scenario/WheelsetMass.h"

namespace squat::roughness {

namespace {

using Complex = std::complex<double>;

// Modes far above what is asked for are part of the quasi-static flexibility of rim and web.
constexpr double highestMode = 6000;  // [Hz]
constexpr int harmonicsAround = 6;

// What the box feels of the primary suspension with the sprung mass behind it, as a dynamic stiffness [N/m].
Complex suspensionStiffness(const scenario::Suspension& s, double omega) {
  const Complex spring(s.stiffness, omega * s.damping);
  const double inertia = -omega * omega * s.sprungMass;
  return spring == 0.0 || inertia == 0.0 ? Complex{} : spring * inertia / (spring + inertia);
}

}  // namespace

std::vector<WheelsetReceptance> wheelsetReceptances(const scenario::Scenario& scenario,
                                                    const std::vector<double>& frequency) {
  const auto& w = scenario.wheelset;
  const double mass = scenario::wheelsetMass(w);
  const auto modes = model::wheelsetModes(scenario, highestMode, harmonicsAround);
  std::vector<WheelsetReceptance> result;
  for (const double f : frequency) {
    const double omega = 2 * std::numbers::pi * f;
    const Complex rigid = -1 / (omega * omega * mass);
    Complex contact = rigid, across = rigid, box = rigid;  // contact to contact, to box; box to box
    Complex lateral, tilting, boxTilting;                  // the mirror at the track centre holds the rigid axle
    for (const auto& mode : modes) {
      const double natural = 2 * std::numbers::pi * mode.frequency;
      const double ratio = mode.frequency < w.dampingLimit ? w.dampingRatio : 0;
      const Complex each = 1.0 / Complex(natural * natural - omega * omega, 2 * ratio * natural * omega);
      contact += mode.contactAmplitude * mode.contactAmplitude * each;
      across += mode.contactAmplitude * mode.boxAmplitude * each;
      box += mode.boxAmplitude * mode.boxAmplitude * each;
      lateral += mode.lateralAmplitude * mode.lateralAmplitude * each;
      tilting += mode.lateralAmplitude * mode.contactAmplitude * each;
      boxTilting += mode.lateralAmplitude * mode.boxAmplitude * each;
    }
    const Complex stiffness = suspensionStiffness(scenario.suspension, omega);
    const Complex holds = stiffness / (1.0 + box * stiffness);  // what the suspension takes back of a box that moves
    result.push_back({contact - across * holds * across, across - across * holds * box,
                      lateral - boxTilting * holds * boxTilting, tilting - across * holds * boxTilting,
                      boxTilting - box * holds * boxTilting});
  }
  return result;
}

}  // namespace squat::roughness
