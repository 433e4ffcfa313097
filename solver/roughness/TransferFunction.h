// solver/roughness/TransferFunction.h - what an axle box answers to a moving roughness, in the frequency domain.
//
// A wheel whose contact moves up by a_wheel F, a rail that goes down by a_rail F and a contact spring that gives way by
// a_contact F share the height r of the roughness that passes between them:
//   F = r / (a_wheel + a_rail + a_contact),   acceleration of the box = -(2 pi f)^2 a_box F.
//   a_wheel, a_box   receptances of the half wheelset from contact to contact and to box: its rigid motion, its natural
//                    modes (model/WheelsetModes.h) and the primary suspension with the sprung mass at the box
//   a_rail           receptance of the track (receptance/Receptance.h), over a sleeper and at midspan
//   a_contact        2/3 of approach over load of Hertz's contact at the static load
// Where the axle bends (some 60 Hz) the wheel tilts, and its tread moves sideways over the rail. Lateral creep resists:
//   Q = -G a b C22 v_y / v of Kalker's linear theory, v_y between tread and rail, which gives way by its lateral
// receptance a_y. With Q on the wheel alone, a_wheel and a_box are smaller by a_zy^2 and a_zy a_by over
//   a_yy + a_y + a_shear + v / (2 pi i f G a b C22),
// a_shear of the contact by Mindlin.
// Cross terms of the rail, spin and tractions near saturation, where creep resists less, are left out.
// Linear, no rotation of the wheel, no moving load: what changes as the wheel passes sleepers is in the spread between
// over a sleeper and midspan. Loss of contact and strong non-linearity are outside.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::roughness {

struct TransferOptions {
  double lowest = 20, highest = 2500;  // [Hz]
  double padSpread = 0.2;              // share by which pads may be stiffer or softer; 0: not looked at
  int threads = 0;                     // 0: all cores
};

// One of the systems that bound what is known: its response, and in words what it is.
struct TransferVariant {
  std::string name;
  std::vector<double> power;  // |box acceleration / height|^2 [1/s4] at each frequency
};

struct TransferFunction {
  std::vector<double> frequency;               // [Hz] equally spaced
  std::vector<std::complex<double>> response;  // [1/s2] with the mean of the track's two receptances
  std::vector<double> power;                   // [1/s4] mean of |response|^2 over a sleeper and at midspan
  TransferVariant overSleeper, midspan, softPads, stiffPads;
  double load = 0;              // [N] static, of the wheel
  double contactStiffness = 0;  // [N/m]
  double halfPatch = 0;         // [m] half the length of the patch along the rail
  double lateralCreep = 0;      // [N] G a b C22
  double wheelsetMass = 0;      // [kg] half wheelset
  std::vector<std::string> notes;
  bool complete = false;  // false: cancelled
};

TransferFunction transferFunction(const scenario::Scenario& scenario, const TransferOptions& options, Monitor& monitor);

// Receptances of the half wheelset at one frequency [m/N]: contact upwards, and box, for a unit force upwards at the
// contact; of the contact outwards, upwards and of the box for a unit force outwards there.
struct WheelsetReceptance {
  std::complex<double> contact, box;
  std::complex<double> lateral, contactLateral, boxLateral;
};
std::vector<WheelsetReceptance> wheelsetReceptances(const scenario::Scenario& scenario,
                                                    const std::vector<double>& frequency);

}  // namespace squat::roughness
