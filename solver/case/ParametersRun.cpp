// Rows of the parameter table: motion, contact, damping, mesh, output. Where the preset draft has a value for a key,
// it is the default and replaces the number in the row (ParameterTable.cpp); the source then says what the paper has.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {

constexpr const char* notStated = "the paper does not say";

// A ramp needs a torque, given as one or as a coefficient.
Parameter withTorque(Parameter row) {
  using Relation = Requirement::Relation;
  row.condition = {{{"motion.torque", Relation::isNot, {"0"}}},
                   {{"motion.traction_coefficient", Relation::isNot, {"0"}}}};
  return row;
}

void addMotion(Rows& rows) {
  rows.push_back(number(
      "motion.speed", speed, 30, {1, 150}, [](Case& c) -> double& { return c.motion.speed; }, "speed of the train",
      section2));
  rows.push_back(number(
      "motion.angular_velocity", angularSpeed, 0, {0, 500}, [](Case& c) -> double& { return c.motion.angularVelocity; },
      "angular velocity of the wheel at the start; 0: free rolling, speed / radius",
      "paper, section 2: 65.2 rad/s, which is free rolling at 30 m/s"));
  rows.push_back(
      appliesIf("motion.traction_coefficient", {"0"},
                number(
                    "motion.torque", torque, 0, {-50000, 50000}, [](Case& c) -> double& { return c.motion.torque; },
                    "driving torque on the half wheelset, about its axis",
                    "assumed: a trailing wheelset; paper, section 2: 12450.49 N m, which exceeds the adhesion limit of "
                    "a half wheelset below "
                    "about 970 kg")));
  rows.push_back(number(
      "motion.traction_coefficient", none, 0, {-1, 1}, [](Case& c) -> double& { return c.motion.tractionCoefficient; },
      "torque divided by wheel load times radius, used in place of motion.torque; 0: motion.torque is used",
      "assumed: the paper states a torque"));
  rows.push_back(withTorque(number(
      "motion.torque_ramp", millisecond, 4, {0, 1000}, [](Case& c) -> double& { return c.motion.torqueRamp; },
      "time over which the torque rises from zero", "assumed: avoids a transient at the start")));
  rows.push_back(number(
      "motion.run_up", metre, 0.3, {0.03, 20}, [](Case& c) -> double& { return c.motion.runUp; },
      "distance from the start to the deepest point of the defect", "paper, section 2: 1 m"));
  rows.push_back(number(
      "motion.beyond", metre, 0.3, {0.02, 20}, [](Case& c) -> double& { return c.motion.beyond; },
      "distance rolled beyond the deepest point; use 0.6 m to judge spectral lines below 300 Hz",
      "assumed: covers the signal that the paper shows"));
  rows.push_back(number(
      "motion.lateral_offset", millimetre, 0, {-10, 10}, [](Case& c) -> double& { return c.motion.lateralOffset; },
      "lateral position of the running circle on the crown, outwards from its middle (hunting); the tread is tangent "
      "there, as a worn one is",
      "assumed: the middle; paper, section 3: the wheel may run beside it"));
  rows.push_back(number(
      "motion.gravity", acceleration, 9.81, {0.1, 100}, [](Case& c) -> double& { return c.motion.gravity; },
      "acceleration of gravity", "standard gravity"));
}

void addContact(Rows& rows) {
  rows.push_back(number(
      "contact.friction", none, 0.3, {0, 1}, [](Case& c) -> double& { return c.contact.friction; },
      "Coulomb friction coefficient between wheel and rail", section2));
  rows.push_back(number(
      "contact.normal_penalty", none, 2.5, {0.1, 50}, [](Case& c) -> double& { return c.contact.normalPenalty; },
      "normal contact stiffness per area, in units of Young's modulus / element size",
      "assumed: a softer contact widens the patch, a stiffer one gives chequered pressures and shorter time steps"));
  rows.push_back(appliesUnless("contact.friction", {"0"},
                               number(
                                   "contact.tangential_penalty", none, 1, {0.01, 10},
                                   [](Case& c) -> double& { return c.contact.tangentialPenalty; },
                                   "ratio of tangential to normal contact stiffness", "assumed")));
  rows.push_back(
      appliesIf("damping.beta", {"0"},
                number(
                    "damping.fraction", none, 0.1, {0, 1}, [](Case& c) -> double& { return c.damping.fraction; },
                    "stiffness-proportional damping as a fraction of critical at the highest frequency of the mesh "
                    "without selective "
                    "mass scaling",
                    "paper, section 2: its coefficient 0.1, read as this fraction (0.1 s would be 314 times critical "
                    "at 1 kHz)")));
  rows.push_back(number(
      "damping.beta", microsecond, 0, {0, 100}, [](Case& c) -> double& { return c.damping.beta; },
      "stiffness-proportional damping coefficient, used in place of damping.fraction; 0: damping.fraction is used",
      "assumed"));
}

void addModel(Rows& rows) {
  rows.push_back(choice(
      "model.extent", {"half", "whole"}, ModelExtent::half, +[](Case& c) -> ModelExtent& { return c.extent; },
      "half: one rail and half the wheelset, with a mirror at the track centre, so that both rails have the defect; "
      "whole: both rails and the whole wheelset, at twice the cost; keys in [right] say what differs on the right side",
      "paper, section 2: half of the track and of the wheelset"));
}

void addMesh(Rows& rows) {
  rows.push_back(choice(
      "mesh.preset", {"tiny", "draft", "standard", "paper"}, MeshPreset::draft,
      +[](Case& c) -> MeshPreset& { return c.mesh.preset; },
      "sets the defaults of the mesh keys and of motion.run_up, motion.beyond and track.length; a key stated in the "
      "case overrides its preset",
      "assumed: results within minutes"));
  rows.push_back(number(
      "mesh.contact_size", millimetre, 2.6, {0.5, 10}, [](Case& c) -> double& { return c.mesh.contactSize; },
      "element size in the contact band, at the start and at the defect", "paper, section 2: 1.3 mm"));
  rows.push_back(number(
      "mesh.rolling_size", millimetre, 5, {0.5, 40}, [](Case& c) -> double& { return c.mesh.rollingSize; },
      "maximum length of the elements rolled over in between", "paper, section 2: 5 mm"));
  rows.push_back(number(
      "mesh.far_size", millimetre, 75, {5, 400}, [](Case& c) -> double& { return c.mesh.farSize; },
      "maximum length of elements far from the wheel", "paper, section 2: 75 mm"));
  rows.push_back(number(
      "mesh.section_growth", none, 1.5, {1.05, 2}, [](Case& c) -> double& { return c.mesh.sectionGrowth; },
      "maximum ratio of neighbouring element sizes in the sections, away from the contact band", notStated));
  rows.push_back(number(
      "mesh.section_size", millimetre, 16, {3, 30}, [](Case& c) -> double& { return c.mesh.sectionSize; },
      "size that elements grow to in the sections of rail and rim; up to twice as large where few rows fill a part",
      notStated));
  rows.push_back(number(
      "mesh.band_half_width", millimetre, 7.8, {2, 25}, [](Case& c) -> double& { return c.mesh.bandHalfWidth; },
      "half width of the contact band meshed with mesh.contact_size", notStated));
  rows.push_back(boolean(
      "mesh.coarse_web", false, [](Case& c) -> bool& { return c.mesh.coarseWeb; },
      "merge three columns of elements of the rail's contact band into one below the upper head and in the web, if "
      "half "
      "the band has a multiple of three",
      notStated));
  rows.push_back(number(
      "mesh.fine_before", millimetre, 20, {0, 500}, [](Case& c) -> double& { return c.mesh.fineBefore; },
      "fine zone before the first and after the last point of the defect", notStated));
  rows.push_back(number(
      "mesh.fine_start", millimetre, 20, {0, 500}, [](Case& c) -> double& { return c.mesh.fineStart; },
      "fine zone on each side of the starting point", notStated));
  rows.push_back(number(
      "mesh.zone_before", millimetre, 0, {0, 2000}, [](Case& c) -> double& { return c.mesh.zoneBefore; },
      "mesh for every defect that begins at most this far before its deepest point, so that their runs share a mesh; "
      "0: for the defect of this case",
      "assumed: no more fine elements than the defect needs"));
  rows.push_back(number(
      "mesh.zone_behind", millimetre, 0, {0, 2000}, [](Case& c) -> double& { return c.mesh.zoneBehind; },
      "mesh for every defect that ends at most this far behind its deepest point; 0: for the defect of this case",
      "assumed: no more fine elements than the defect needs"));
  rows.push_back(wholeNumber(
      "mesh.wheel_sectors", 64, {16, 720}, [](Case& c) -> int& { return c.mesh.wheelSectors; },
      "sectors of the coarse wheel body around the axle", notStated));
  rows.push_back(number(
      "mesh.rim_depth", millimetre, 25, {4, 100}, [](Case& c) -> double& { return c.mesh.rimDepth; },
      "depth of the finely meshed rim", notStated));
  rows.push_back(choice(
      "mesh.precision", {"single", "double"}, ElementPrecision::single,
      +[](Case& c) -> ElementPrecision& { return c.mesh.precision; },
      "precision of the element arithmetic while the wheel rolls; state, time integration and equilibrium are always "
      "double",
      "assumed: single takes up to a quarter less time and changes the axle box acceleration by less than 0.2 %"));
  rows.push_back(boolean(
      "mesh.selective_inertia", true, [](Case& c) -> bool& { return c.mesh.selectiveMassScaling; },
      "selective mass scaling: more inertia for waves as short as the smallest elements, which allows a longer time "
      "step; "
      "rigid motion, longer waves and statics are unchanged",
      "assumed: halves the number of steps and changes the axle box acceleration by less than 0.4 %"));
}

void addOutput(Rows& rows) {
  rows.push_back(number(
      "output.rate", kilohertz, 25, {16, 200}, [](Case& c) -> double& { return c.output.rate; },
      "sampling rate of all signals, which are low-passed at 6 kHz", "paper, section 3: sampling of the measurement"));
  rows.push_back(number(
      "output.filter_cutoff", kilohertz, 2, {0.05, 50}, [](Case& c) -> double& { return c.output.filterCutoff; },
      "cut-off frequency of the filtered acceleration", "paper, section 3"));
  rows.push_back(number(
      "output.time_step", microsecond, 0, {0, 10}, [](Case& c) -> double& { return c.output.timeStep; },
      "requested time step, at most the stable one; 0: the stable one",
      "assumed: the 0.02295 ms printed in the paper cannot be stable with elements of 1.3 mm"));
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
  addModel(rows);
  addMesh(rows);
  addOutput(rows);
  return rows;
}

}  // namespace squat::cases::rows
