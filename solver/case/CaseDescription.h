// solver/case/CaseDescription.h - what the user asked for: plain structs, SI units, no behaviour.
// Names, units, defaults, ranges and documentation of every member stand in the parameter table (ParameterTable.h) and
// only there: a default-constructed CaseDescription is all zeros; start from defaultCase().
// Axes of the whole program: x along the track in rolling direction, y lateral (outwards from the track centre),
// z up. The deepest point of the defect is at x = 0; y = 0 and z = 0 are the middle of the rail's running surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace squat::cases {

struct Material {
  double young = 0, poisson = 0, density = 0;  // [Pa], [-], [kg/m3]
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
  int railEnds = 0;              // index of RailEnds
  std::vector<Seat> seats;       // those that differ
};
enum class RailEnds { free, clamped, absorbing };

struct Rail {
  Material material;
  double inclination = 0;  // [-] slope of the foot: the head leans towards the track centre
  double yieldStress = 0, tangentModulus = 0, plasticDepth = 0;  // [Pa], [Pa], [m]
  int hardening = 0;                                             // index of Hardening
  bool plastic = false;
};
enum class Hardening { isotropic, kinematic };

// Spring and damper per rail seat (pad) or per half sleeper (ballast), spread over the footprint.
struct Support {
  double stiffness = 0, damping = 0;                          // vertical, [N/m], [N s/m]
  double longitudinalStiffness = 0, longitudinalDamping = 0;  // along the rail
  double lateralStiffness = 0, lateralDamping = 0;
};
struct ForcePoint {
  double compression = 0, force = 0;  // [m], [N]
};
struct Pad : Support {
  double length = 0, width = 0;   // [m] footprint along and across the rail
  std::vector<ForcePoint> curve;  // vertical, both ascending; empty: linear
  double preload = 0;             // [N] clamping force of the fastening: where on the curve the unloaded track stands
};

struct Sleeper {
  Material material;
  double halfLength = 0, width = 0, height = 0;  // [m]
};

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
  double dampingRatio = 0;  // [-] of critical, of every flexible mode of the half wheelset below dampingLimit
  double dampingLimit = 0;  // [Hz]
  double totalMass = 0;     // [kg] half wheelset; the rest sits as brake discs on the axle
  double trackCentre = 0;   // [m] from the wheel plane to the symmetry plane, positive
};

struct Suspension {
  double sprungMass = 0, stiffness = 0, damping = 0;          // [kg], [N/m], [N s/m] vertical
  double longitudinalStiffness = 0, longitudinalDamping = 0;  // guidance: carries the traction to the sprung mass
};

struct Motion {
  double speed = 0;                // [m/s]
  double angularVelocity = 0;      // [rad/s]; 0: free rolling, speed / radius
  double torque = 0;               // [N m] on the half wheelset
  double tractionCoefficient = 0;  // torque as a share of the wheel load times radius; 0: torque above counts
  double torqueRamp = 0;           // [s]
  double runUp = 0;                // [m] from start to the deepest point of the defect
  double beyond = 0;               // [m] rolled beyond it
  double lateralOffset = 0;        // [m] along the crown from its middle to where the wheel's running circle touches
  double gravity = 0;              // [m/s2]
};

struct Contact {
  double friction = 0;           // Coulomb
  double normalPenalty = 0;      // in units of E / (element size)
  double tangentialPenalty = 0;  // as a share of the normal one
};

struct Damping {
  double fraction = 0;  // of critical at the highest frequency of the mesh, stiffness-proportional
  double beta = 0;      // [s] explicit stiffness-proportional coefficient; 0: from the fraction
};

enum class MeshPreset { tiny, draft, standard, paper };
struct MeshSizes {
  int preset = 0;                 // index of MeshPreset
  double contactSize = 0;         // [m] element size in the contact band at the start and at the defect
  double rollingSize = 0;         // [m] largest length of elements rolled over in between
  double farSize = 0;             // [m] largest length of elements away from the wheel
  double sectionSize = 0;         // [m] largest element size in the sections of rail and rim
  double sectionGrowth = 0;       // [-] largest ratio of neighbouring sizes in the sections
  double bandHalfWidth = 0;       // [m] lateral half width of the contact band with contactSize
  double fineBefore = 0;          // [m] fine zone before the first and after the last point of the defect
  double fineStart = 0;           // [m] fine zone each side of the starting point
  int wheelSectors = 0;           // sectors of the coarse wheel body
  double rimDepth = 0;            // [m] depth of the finely meshed rim
  int precision = 0;              // index of ElementPrecision
  bool coarseWeb = false;         // three columns of the band become one below the upper head
  bool selectiveInertia = false;  // waves as short as the elements are slowed
};

enum class ElementPrecision { single, full };  // "single", "double"

enum class DefectShape { none, cut, cosine, wshape, dipWithWave, profile };
enum class LateralShape { uniform, parabolic };

struct ProfilePoint {
  double position = 0;  // [m] along the track
  double height = 0;    // [m] up positive: a dip is negative
};

// One of several profiles side by side.
struct ProfileLine {
  double lateral = 0;  // [m] on the rail's crown, from its middle outwards
  std::vector<ProfilePoint> points;
};

struct Defect {
  int shape = 0;                     // index of DefectShape
  double length = 0;                 // [m] of the dip
  double depth = 0;                  // [m] positive
  double ramp = 0;                   // [m] of each ramp of the cut
  double waveLength = 0;             // [m] trailing wave
  double waveDepth = 0;              // [m] amplitude of its dips
  double waveCount = 0;              // number of trailing waves
  double middleHeight = 0;           // [-] W shape: height of the middle ridge as a share of the depth
  int lateral = 0;                   // index of LateralShape
  double halfWidth = 0;              // [m] parabolic: half width where the defect fades out
  std::string file;                  // path of the profile as the case names it
  std::vector<ProfilePoint> points;  // the profile as read, shape == profile
  std::vector<ProfileLine> lines;    // several profiles side by side; they count before points
  double lateralCentre = 0;          // [m] sideways shift of the whole defect on the crown
  double heightScale = 0;            // [-] profile: factor on all heights
  bool level = false;                // profile: the line through its first and last point is the undisturbed surface
  bool moveNodes = false;            // surface nodes moved (true) or the profile as a term of the gap function (false)
};

struct Output {
  double rate = 0;          // [Hz]
  double filterCutoff = 0;  // [Hz] low-pass of aba_filtered
  double timeStep = 0;      // [s] wished step; 0: the stable one
  double cwtVoices = 0;     // voices per octave of the scalogram
};

struct CaseDescription {
  std::string title;
  std::string note;
  Track track;
  Rail rail;
  Pad pad;
  Sleeper sleeper;
  Support ballast;
  Wheelset wheelset;
  Suspension suspension;
  Motion motion;
  Contact contact;
  Damping damping;
  MeshSizes mesh;
  Defect defect;
  Output output;
};

}  // namespace squat::cases
