// Rows of the parameter table: motion, contact, damping, mesh, output. Where the preset draft has a value for a key,
// it is the default and the number in the row is replaced by it (ParameterTable.cpp).
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {

constexpr const char* section2 = "paper, section 2";
constexpr const char* preset = "mesh preset draft";

void addMotion(Rows& rows) {
  rows.push_back(number(
      "motion.speed", speed, 30, {1, 150}, [](Case& c) -> double& { return c.motion.speed; }, "speed of the train",
      section2));
  rows.push_back(number(
      "motion.angular_velocity", angularSpeed, 0, {0, 500}, [](Case& c) -> double& { return c.motion.angularVelocity; },
      "angular velocity of the wheel at the start; 0: it rolls freely, speed / radius",
      "paper, section 2: 65.2 rad/s, which is free rolling at 30 m/s"));
  rows.push_back(number(
      "motion.torque", torque, 12450.49, {-50000, 50000}, [](Case& c) -> double& { return c.motion.torque; },
      "driving torque on the half wheelset, about the rolling axis", section2));
  rows.push_back(number(
      "motion.traction_coefficient", none, 0, {-1, 1}, [](Case& c) -> double& { return c.motion.tractionCoefficient; },
      "torque as a share of wheel load times radius, in place of motion.torque; 0: motion.torque counts",
      "assumed: the paper states the torque"));
  rows.push_back(number(
      "motion.torque_ramp", millisecond, 4, {0, 1000}, [](Case& c) -> double& { return c.motion.torqueRamp; },
      "time in which the torque grows from zero", "assumed: keeps the start quiet"));
  rows.push_back(number(
      "motion.run_up", metre, 0.3, {0.03, 20}, [](Case& c) -> double& { return c.motion.runUp; },
      "rolled from the start to the deepest point of the defect (the paper: 1 m)", preset));
  rows.push_back(number(
      "motion.beyond", metre, 0.3, {0.02, 20}, [](Case& c) -> double& { return c.motion.beyond; },
      "rolled beyond the deepest point; 0.6 m where lines below 300 Hz are judged",
      "assumed: holds the signal that the paper shows"));
  rows.push_back(number(
      "motion.lateral_offset", millimetre, 0, {-10, 10}, [](Case& c) -> double& { return c.motion.lateralOffset; },
      "where on the crown the wheel runs, outwards from its middle (hunting): the running circle stands there and the "
      "tread is tangent, as a worn one is",
      "paper, section 3: the wheel may run beside the middle"));
  rows.push_back(number(
      "motion.gravity", acceleration, 9.81, {0.1, 100}, [](Case& c) -> double& { return c.motion.gravity; },
      "acceleration of gravity", "assumed: standard value"));
}

void addContact(Rows& rows) {
  rows.push_back(number(
      "contact.friction", none, 0.3, {0, 1}, [](Case& c) -> double& { return c.contact.friction; },
      "Coulomb friction coefficient between wheel and rail", section2));
  rows.push_back(number(
      "contact.normal_penalty", none, 2.5, {0.1, 50}, [](Case& c) -> double& { return c.contact.normalPenalty; },
      "normal contact stiffness per area, in units of Young's modulus / element size",
      "assumed: softer widens the patch, stiffer gives chequered pressures and in the end shorter steps"));
  rows.push_back(number(
      "contact.tangential_penalty", none, 1, {0.01, 10}, [](Case& c) -> double& { return c.contact.tangentialPenalty; },
      "tangential contact stiffness as a share of the normal one", "assumed"));
  rows.push_back(number(
      "damping.fraction", none, 0.1, {0, 1}, [](Case& c) -> double& { return c.damping.fraction; },
      "stiffness-proportional damping as a share of critical at the highest frequency of the mesh, short waves with "
      "their "
      "own inertia",
      "paper, section 2: its coefficient 0.1 read as this share (0.1 s would be 314 times critical at 1 kHz)"));
  rows.push_back(number(
      "damping.beta", microsecond, 0, {0, 100}, [](Case& c) -> double& { return c.damping.beta; },
      "stiffness-proportional damping coefficient in place of damping.fraction; 0: from the fraction", "assumed"));
}

void addMesh(Rows& rows) {
  rows.push_back(choice(
      "mesh.preset", {"tiny", "draft", "standard", "paper"}, 1, [](Case& c) -> int& { return c.mesh.preset; },
      "sets the defaults of this table, of motion.run_up, motion.beyond and track.length; a key that the "
      "case states goes before its preset",
      "assumed: answers within minutes"));
  rows.push_back(number(
      "mesh.contact_size", millimetre, 2.6, {0.5, 10}, [](Case& c) -> double& { return c.mesh.contactSize; },
      "element size in the contact band, at the start and at the defect (the paper: 1.3 mm)", preset));
  rows.push_back(number(
      "mesh.rolling_size", millimetre, 5, {0.5, 40}, [](Case& c) -> double& { return c.mesh.rollingSize; },
      "largest length of elements that are rolled over in between (the paper: 5 mm)", preset));
  rows.push_back(number(
      "mesh.far_size", millimetre, 75, {5, 400}, [](Case& c) -> double& { return c.mesh.farSize; },
      "largest length of elements far from the wheel (the paper: 75 mm)", preset));
  rows.push_back(number(
      "mesh.section_growth", none, 1.5, {1.05, 2}, [](Case& c) -> double& { return c.mesh.sectionGrowth; },
      "largest ratio of neighbouring element sizes away from the contact band in the sections", preset));
  rows.push_back(number(
      "mesh.section_size", millimetre, 16, {3, 30}, [](Case& c) -> double& { return c.mesh.sectionSize; },
      "largest element size in the sections of rail and rim", preset));
  rows.push_back(number(
      "mesh.band_half_width", millimetre, 7.8, {2, 25}, [](Case& c) -> double& { return c.mesh.bandHalfWidth; },
      "lateral half width of the contact band that has mesh.contact_size", preset));
  rows.push_back(boolean(
      "mesh.coarse_web", false, [](Case& c) -> bool& { return c.mesh.coarseWeb; },
      "three columns of elements of the rail's contact band become one below the upper head and in the web, where half "
      "the band has a multiple of three",
      preset));
  rows.push_back(number(
      "mesh.fine_before", millimetre, 20, {0, 500}, [](Case& c) -> double& { return c.mesh.fineBefore; },
      "fine zone before the first and behind the last point of the defect", preset));
  rows.push_back(number(
      "mesh.fine_start", millimetre, 20, {0, 500}, [](Case& c) -> double& { return c.mesh.fineStart; },
      "fine zone on each side of the starting point", preset));
  rows.push_back(wholeNumber(
      "mesh.wheel_sectors", 64, {16, 720}, [](Case& c) -> int& { return c.mesh.wheelSectors; },
      "sectors of the coarse wheel body around the axle", preset));
  rows.push_back(number(
      "mesh.rim_depth", millimetre, 25, {4, 100}, [](Case& c) -> double& { return c.mesh.rimDepth; },
      "depth of the finely meshed rim", preset));
  rows.push_back(choice(
      "mesh.precision", {"single", "double"}, 0, [](Case& c) -> int& { return c.mesh.precision; },
      "arithmetic inside the elements while the wheel rolls; state, step and equilibrium are double always",
      "assumed: single takes up to a quarter less time, the axle box acceleration is the same to 0.2 %"));
  rows.push_back(boolean(
      "mesh.selective_inertia", true, [](Case& c) -> bool& { return c.mesh.selectiveInertia; },
      "more inertia for waves as short as the smallest elements, and with it a longer time step; rigid motion, longer "
      "waves and statics are left alone",
      "assumed: twice as many steps without it, the axle box acceleration is the same to 0.4 %"));
}

void addOutput(Rows& rows) {
  rows.push_back(number(
      "output.rate", kilohertz, 25, {16, 200}, [](Case& c) -> double& { return c.output.rate; },
      "samples a second of all signals; they are kept up to 6 kHz", "paper, section 3: sampling of the measurement"));
  rows.push_back(number(
      "output.filter_cutoff", kilohertz, 2, {0.05, 50}, [](Case& c) -> double& { return c.output.filterCutoff; },
      "cut-off of the low-pass of the filtered acceleration", "paper, section 3"));
  rows.push_back(number(
      "output.time_step", microsecond, 0, {0, 10}, [](Case& c) -> double& { return c.output.timeStep; },
      "wished time step, refused above the stable one; 0: the stable one",
      "assumed: the paper's 0.02295 ms cannot be stable with elements of 1.3 mm"));
  rows.push_back(wholeNumber(
      "output.cwt_voices", 16, {4, 64}, [](Case& c) -> double& { return c.output.cwtVoices; },
      "scales per octave of the scalogram", "assumed"));
  rows.push_back(number(
      "output.rail_accelerometer", metre, 0, {-60, 60}, [](Case& c) -> double& { return c.output.railAccelerometer; },
      "location of an accelerometer on the rail foot, along the track from the deepest point of the defect; a second "
      "one is on the nearest sleeper",
      "assumed: at the defect"));
}

}  // namespace

Rows motionRows() {
  Rows rows;
  addMotion(rows);
  addContact(rows);
  return rows;
}

Rows runRows() {
  Rows rows;
  addMesh(rows);
  addOutput(rows);
  return rows;
}

}  // namespace squat::cases::rows
