// solver/growth/SurfaceSeries.h - the running surface at each stage, read back from a file of growth.
#pragma once

#include <string>
#include <vector>

#include "results/ArrayTree.h"

namespace squat::growth {

inline constexpr const char* growthSchema = "squat-growth";

struct SurfaceSeries {
  std::vector<double> x, y, tonnage;       // [m], [m], [kg]
  std::vector<std::vector<float>> height;  // [m] of each stage, ordered [x][y]
};

// STEM-growth.h5, which may be untrusted. Throws FileError.
SurfaceSeries readSurfaceSeries(const std::string& path);
SurfaceSeries surfaceSeriesFrom(const results::ArrayTree& tree, const std::string& path);

}  // namespace squat::growth
