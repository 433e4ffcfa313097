#include "growth/SurfaceSeries.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "results/Hdf5.h"

namespace squat::growth {

SurfaceSeries surfaceSeriesFrom(const results::ArrayTree& tree, const std::string& path) {
  if (results::textAttribute(tree.attributes, "schema") != growthSchema)
    throw FileError(path, "/@schema", "is not a growth of this program", "Name a file of squat grow");
  const auto values = [&](const char* name) -> const std::vector<double>& {
    return results::valuesOf<double>(tree, name, path);
  };
  SurfaceSeries series{values("/surface/x"), values("/surface/y"), values("/stages/tonnage"), {}};
  const auto& heights = results::valuesOf<float>(tree, "/surface/height", path);
  const std::size_t each = series.x.size() * series.y.size();
  if (series.x.size() < 2 || series.y.size() < 2 || series.tonnage.empty() ||
      heights.size() != each * series.tonnage.size())
    throw FileError(path, "/surface/height", "has a wrong size");
  const auto isNumber = [](double value) { return std::isfinite(value); };
  for (const auto* own : {&series.x, &series.y, &series.tonnage})
    if (!std::all_of(own->begin(), own->end(), isNumber) || !std::is_sorted(own->begin(), own->end()))
      throw FileError(path, "/surface", "holds positions or tonnages that do not ascend");
  if (!std::all_of(heights.begin(), heights.end(), isNumber))
    throw FileError(path, "/surface/height", "holds values that are no numbers");
  for (std::size_t i = 0; i < series.tonnage.size(); ++i)
    series.height.emplace_back(heights.begin() + static_cast<std::ptrdiff_t>(i * each),
                               heights.begin() + static_cast<std::ptrdiff_t>((i + 1) * each));
  return series;
}

SurfaceSeries readSurfaceSeries(const std::string& path) { return surfaceSeriesFrom(results::readHdf5(path), path); }

}  // namespace squat::growth
