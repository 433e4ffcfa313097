// solver/results/ResultTree.h - RunResult <-> ArrayTree: the layout of the result file, in one place.
//   /            schema, schema_version, code_version, commit, complete, stop_reason, case_toml, case_hash, isa,
//                threads, stem, title, created, speed; dataset /warnings where there are any
//   /signals     time, position and one dataset a signal
//   /spectra     frequency, psd, psd_wheel; attributes window, from, to
//   /scalogram   frequency, time, position, power [frequency][time], cone_of_influence
//   /features    one number each
//   /energy      time and one dataset a term           /equilibrium /performance   one number each
//   /mesh        one number each; surface/points [n][3], quads [m][4], part, part_names, springs [k][6]
//   /modes       frequency, box_share, wheel_share, contact_share
//   /profile     position, height, wheel_path
//   /plasticity  one number each               /permanent   position, lateral, depth, height [position][lateral],
//                equivalent_strain, stress_along, stress_across, stress_vertical, von_mises [position][depth]
//   /fields/NNN  displacement [n][3], von_mises, plastic_strain; attributes name, time, position, wheel_travel,
//                wheel_rotation                        /patch/NNN x, y, pressure, traction_x, ...
//                and of a whole model x_right, y_right, ...
#pragma once

#include <string>

#include "results/ArrayTree.h"
#include "results/RunResult.h"

namespace squat::results {

inline constexpr const char* kResultSchema = "squat-result";
inline constexpr int kResultVersion = 1;

ArrayTree toTree(const RunResult& result);

// Takes the tree's arrays over. Throws FileError(path, object, ...) for a missing or wrong schema, a newer version
// (with advice), members of wrong type or lengths that do not fit together. Missing groups give empty members.
RunResult fromTree(ArrayTree tree, const std::string& path);

}  // namespace squat::results
