// solver/scenario/Vehicle.h - half wheelset, primary suspension, bogie.
#pragma once

#include "scenario/Material.h"

namespace squat::scenario {

// Lateral positions are distances from the wheel plane (the contact point), outwards positive.
struct Wheelset {
  Material material;
  double radius = 0, rimWidth = 0, rimInnerRadius = 0;    // [m]
  double cone = 0;                                        // [-] slope of the tread, its radius falls outwards
  double webThickness = 0, hubRadius = 0, hubWidth = 0;   // [m]
  double webHubThickness = 0;                             // [m] of the web at the hub; 0: as at the rim
  double webOffset = 0;                                   // [m] middle of the web at the hub from that at the rim
  double seatRadius = 0, axleRadius = 0, boreRadius = 0;  // [m] wheel seat, axle body, bore
  double shoulderRadius = 0, shoulderEnd = 0;             // [m] step outside the hub, its outer end
  double journalRadius = 0, journalEnd = 0;               // [m]
  double bearingCentre = 0, bearingWidth = 0;             // [m]
  double axleBoxMass = 0;                                 // [kg] box and bearing
  double bearingStiffness = 0, bearingDamping = 0;  // [N/m], [N s/m] radial, journal to box; stiffness 0: rigid, the
                                                    // box is spread over the bearing seat
  double dampingRatio = 0;       // [-] of critical, of every flexible mode of the half wheelset below dampingLimit
  double dampingLimit = 0;       // [Hz]
  double totalMass = 0;          // [kg] half wheelset; what its parts do not weigh sits on the axle. 0: what they weigh
  int brakeDiscs = 0;            // of the half axle
  double brakeDiscMass = 0;      // [kg] of each
  double brakeDiscPosition = 0;  // [m] of the disc nearest to the wheel, from the wheel plane towards the track centre
  double trackCentre = 0;        // [m] from the wheel plane to the symmetry plane, positive
};

struct Suspension {
  double sprungMass = 0, stiffness = 0, damping = 0;          // [kg], [N/m], [N s/m] vertical
  double longitudinalStiffness = 0, longitudinalDamping = 0;  // guidance: carries the traction to the sprung mass
  double lateralStiffness = 0, lateralDamping = 0;            // of a whole model
};

// Where the bogie's other wheelset runs, seen from the one that rolls over the defect.
enum class SecondPlace { behind, ahead };

struct Bogie {
  double wheelbase = 0;  // [m] between the wheelsets; 0: a single wheelset
  SecondPlace second = SecondPlace::behind;
  double pitchRadius = 0;  // [m] radius of gyration of the sprung mass of both about its lateral axis
  bool hasSecond() const { return wheelbase > 0; }
  // [m] x of the second wheelset from the first.
  double offset() const { return second == SecondPlace::behind ? -wheelbase : wheelbase; }
};

}  // namespace squat::scenario
