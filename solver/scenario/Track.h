// solver/scenario/Track.h - rail, pads, sleepers and ballast.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "scenario/Irregularity.h"
#include "scenario/Material.h"

namespace squat::scenario {

enum class RailEnds { free, clamped, absorbing };
enum class RailSection { rail54E1, rail60E1 };  // geometry/RailSection.h has their dimensions
enum class Hardening { isotropic, kinematic, chaboche };

// dX = 2/3 modulus d eps_p - recovery X dp (plasticity/SurfaceLayer.h).
struct Backstress {
  double modulus = 0, recovery = 0;  // [Pa], [-]
};

// A rail seat that differs from the others; what is left out is as at every seat.
struct Seat {
  int sleeper = 0;  // counted from the one nearest to the defect, positive in rolling direction
  std::optional<double> padStiffness, padDamping;          // vertical, [N/m], [N s/m]
  std::optional<double> ballastStiffness, ballastDamping;  // vertical, per half sleeper
  std::optional<double> gap;                               // [m] between the sleeper and its ballast
};

struct Track {
  double length = 0;             // [m] of rail
  double sleeperSpacing = 0;     // [m]
  double defectFromSleeper = 0;  // [m] the paper's L: deepest point relative to the nearest sleeper centre
  RailEnds railEnds = RailEnds::free;
  std::vector<Seat> seats;  // those that differ
};

struct Rail {
  RailSection section = RailSection::rail54E1;
  Material material;
  double lossFactor = 0;   // [-] frequency domain only: stiffness times 1 + i lossFactor
  double inclination = 0;  // [-] slope of the foot: the head leans towards the track centre
  double yieldStress = 0, tangentModulus = 0, plasticDepth = 0;  // [Pa], [Pa], [m]
  Hardening hardening = Hardening::isotropic;
  // Of back-stresses that recover; the yield stress grows by isotropicSaturation (1 - exp(-isotropicRate p)).
  std::array<Backstress, 3> backstresses{};
  double recoveryExponent = 0;                        // [-] 0: Armstrong and Frederick
  double isotropicSaturation = 0, isotropicRate = 0;  // [Pa], [-]
  bool plastic = false;
  // [m] along x: only there it may yield, below where wheels touch about plasticMiddle of the crown; both zero:
  // wherever the wheel can roll. Not an input: growth sets it.
  double plasticFrom = 0, plasticTo = 0, plasticMiddle = 0;
  Irregularity irregularity;
};

// Complex stiffness of a whole pad, as measured. Frequency domain only.
struct DynamicStiffness {
  double frequency = 0;                    // [Hz]
  std::complex<double> vertical, lateral;  // [N/m]; lateral zero where it was not measured
};

// Spring and damper per rail seat (pad) or per half sleeper (ballast), spread over the footprint.
struct Support {
  double stiffness = 0, damping = 0;                          // vertical, [N/m], [N s/m]
  double longitudinalStiffness = 0, longitudinalDamping = 0;  // along the rail
  double lateralStiffness = 0, lateralDamping = 0;
  double lossFactor = 0;  // [-] frequency domain only, in place of the damping: stiffness times 1 + i lossFactor
};
struct ForcePoint {
  double compression = 0, force = 0;  // [m], [N]
};
struct Pad : Support {
  double length = 0, width = 0;   // [m] footprint along and across the rail
  std::vector<ForcePoint> curve;  // vertical, both ascending; empty: linear
  double preload = 0;             // [N] clamping force of the fastening: where on the curve the unloaded track stands
  std::string dynamicFile;        // of measured stiffness, as the case names it
  std::string dynamicValues;      // the same as text (case/DynamicPads.h)
  std::vector<DynamicStiffness> dynamic;  // the same, resolved; ascending; empty: stiffness and loss factor or damping
};

struct Sleeper {
  Material material;
  double lossFactor = 0;                         // [-] frequency domain only
  bool fixed = false;                            // does not move: pads stand on the ground
  double halfLength = 0, width = 0, height = 0;  // [m] height under the rail
  double middleHeight = 0;      // [m] in the middle of the track, on the same base; 0: as under the rail
  double middleHalfLength = 0;  // [m] from the track centre to where the middle's height ends
};

}  // namespace squat::scenario
