// Surface, snapshots and contact patches of a result: what pictures are made of.
#include <pybind11/stl.h>

#include "python/Arrays.h"
#include "python/Results.h"

namespace squat::python {

namespace py = pybind11;

namespace {

using results::RunResult;

py::dict surfaceOf(const py::object& self) {
  const auto& surface = self.cast<const RunResult&>().surface;
  py::dict all;
  all["points"] = viewOfRows(surface.points, 3, self), all["quads"] = viewOfRows(surface.quads, 4, self);
  all["part"] = view(surface.part, self), all["part_names"] = surface.partNames;
  all["springs"] = viewOfRows(surface.springs, 6, self);
  return all;
}

py::list snapshotsOf(const py::object& self) {
  py::list all;
  for (const auto& snapshot : self.cast<const RunResult&>().snapshots) {
    py::dict one;
    one["name"] = snapshot.name, one["time"] = snapshot.time, one["position"] = snapshot.position;
    one["wheel_travel"] = snapshot.wheelTravel, one["wheel_rotation"] = snapshot.wheelRotation;
    one["displacement"] = viewOfRows(snapshot.displacement, 3, self);
    one["von_mises"] = view(snapshot.vonMises, self);
    one["plastic_strain"] = view(snapshot.plasticStrain, self);
    all.append(one);
  }
  return all;
}

// Into `one`, one contact; the names of the right one's arrays end in `side`.
void addContact(py::dict& one, const results::PatchSnapshot& patch, const std::string& side, const py::object& self) {
  const auto set = [&](const char* name, const auto& values) { one[py::str(name + side)] = view(values, self); };
  set("x", patch.x), set("y", patch.y), set("pressure", patch.pressure);
  set("traction_x", patch.tractionX), set("traction_y", patch.tractionY);
  set("slipping", patch.slipping), set("area", patch.area);
}

py::list patchesOf(const py::object& self) {
  py::list all;
  for (const auto& patch : self.cast<const RunResult&>().patches) {
    py::dict one;
    one["name"] = patch.name, one["time"] = patch.time, one["position"] = patch.position;
    addContact(one, patch, "", self);
    if (patch.right) addContact(one, *patch.right, "_right", self);
    all.append(one);
  }
  return all;
}

py::dict permanentOf(const py::object& self) {
  const auto& change = self.cast<const RunResult&>().permanent;
  const auto depths = change.depth.size();
  py::dict all;
  if (change.empty()) return all;
  all["position"] = view(change.position, self), all["lateral"] = view(change.lateral, self);
  all["depth"] = view(change.depth, self);
  all["height"] = viewOfRows(change.height, change.lateral.size(), self);
  all["equivalent_strain"] = viewOfRows(change.equivalentStrain, depths, self);
  all["stress_along"] = viewOfRows(change.stressAlong, depths, self);
  all["stress_across"] = viewOfRows(change.stressAcross, depths, self);
  all["stress_vertical"] = viewOfRows(change.stressVertical, depths, self);
  all["von_mises"] = viewOfRows(change.vonMises, depths, self);
  return all;
}

}  // namespace

void addFields(ResultClass& type) {
  type.def_property_readonly(
      "surface", &surfaceOf,
      R"(Outer surface at the start: a dict of points (p, 3) [m], quads (q, 4) of point indices, part (q) as
index into part_names, and springs (s, 6), line segments [m].)");
  type.def_property_readonly(
      "snapshots", &snapshotsOf,
      R"(Fields on the surface points at several instants: a list of dicts with name, time [s], position [m],
wheel_travel [m], wheel_rotation [rad], displacement (p, 3) [m], von_mises (p) [Pa], plastic_strain
(p) or (0).)");
  type.def_property_readonly(
      "patches", &patchesOf,
      R"(The contact patch at several instants: a list of dicts with name, time [s], position [m], and arrays
(c) of x, y [m], pressure, traction_x, traction_y [Pa], slipping (1 slips, 0 sticks), area [m2]. Of a
whole model also those of the right contact, x_right, y_right and so on, counted from its own rail's axis
outwards.)");
  type.def_property_readonly(
      "permanent", &permanentOf,
      R"(What plastic flow leaves in the unloaded rail: a dict of position (x), lateral (y), depth (z) [m],
height (x, y) [m], equivalent_strain (x, z) [1], stress_along, stress_across, stress_vertical,
von_mises (x, z) [Pa]; empty where the rail is elastic.)");
}

}  // namespace squat::python
