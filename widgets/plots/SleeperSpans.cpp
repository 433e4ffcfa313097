#include "plots/SleeperSpans.h"

#include <algorithm>

namespace squat::plots {

std::vector<Span> sleeperSpans(const results::SurfaceMesh& surface) {
  std::vector<Span> quads;
  for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
    const std::size_t part = surface.part[quad];
    if (part >= surface.partNames.size() || surface.partNames[part] != "sleepers") continue;
    Span span{1e30, -1e30};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::size_t point = 3 * static_cast<std::size_t>(surface.quads[4 * quad + corner]);
      if (point >= surface.points.size()) continue;
      const double x = static_cast<double>(surface.points[point]);
      span = {std::min(span.from, x), std::max(span.to, x)};
    }
    if (span.from <= span.to) quads.push_back(span);
  }
  std::sort(quads.begin(), quads.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
  std::vector<Span> merged;
  for (const Span& span : quads) {
    constexpr double touching = 1e-4;  // [m]
    if (!merged.empty() && span.from <= merged.back().to + touching)
      merged.back().to = std::max(merged.back().to, span.to);
    else
      merged.push_back(span);
  }
  return merged;
}

}  // namespace squat::plots
