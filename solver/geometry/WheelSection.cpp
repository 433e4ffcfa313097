#include "geometry/WheelSection.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace squat::geometry {

namespace {

std::vector<double> scaled(const std::vector<double>& fractions, double from, double to) {
  std::vector<double> values;
  for (const double s : fractions) values.push_back(from + s * (to - from));
  return values;
}

// Grid lines through all marks, with steps of at most `largest`.
std::vector<double> gridLines(std::vector<double> marks, double largest) {
  std::sort(marks.begin(), marks.end());
  std::vector<double> lines{marks.front()};
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const double from = lines.back(), length = marks[i] - from;
    if (length < 1e-6) continue;
    const int count = std::max(1, static_cast<int>(std::ceil(length / largest - 1e-6)));
    for (int k = 1; k <= count; ++k) lines.push_back(from + length * k / count);
  }
  return lines;
}

struct Rectangle {
  double inner, outer, from, to;  // radius, y
};

// A conical or tapered web: lines of the grid between both faces of the web run straight from the rim to the hub, those
// within the hub's width make room for them.
double shiftedForWeb(const scenario::Wheelset& w, double radius, double y) {
  const double hub = w.hubWidth / 2, web = w.webThickness / 2;
  const double atHub = w.webHubThickness > 0 ? w.webHubThickness / 2 : web;
  if (radius > w.rimInnerRadius - 1e-9 || (w.webOffset == 0 && atHub == web)) return y;
  if (radius < w.hubRadius + 1e-9) {
    if (std::abs(y) >= hub) return y;
    if (y > web) return hub - (hub - y) * (hub - w.webOffset - atHub) / (hub - web);
    if (y < -web) return -hub + (hub + y) * (hub + w.webOffset - atHub) / (hub - web);
    return w.webOffset + y * atHub / web;
  }
  const double share = (w.rimInnerRadius - radius) / (w.rimInnerRadius - w.hubRadius);
  return share * w.webOffset + y * (1 + share * (atHub / web - 1));
}

}  // namespace

SectionMesh rimSectionMesh(const scenario::Wheelset& wheelset, const WheelSectionSizes& sizes) {
  const double growth = sizes.growth, h = sizes.contactSize, half = wheelset.rimWidth / 2;
  const int columns = std::max(2, static_cast<int>(std::lround(sizes.bandHalfWidth / h)));
  const double bandEdge = sizes.bandHalfWidth;
  std::vector<double> side;
  for (int i = 0; i <= columns; ++i) side.push_back(bandEdge * i / columns);
  const double rest = half - bandEdge, first = growth * h;
  const int outer = intervalsFor(rest, first, growth * 1.15, 1.5 * sizes.sectionSize);
  for (const double y : scaled(gradedSpacing(outer, first / rest), bandEdge, half))
    if (y > bandEdge + 1e-9) side.push_back(y);
  std::vector<double> y;
  for (auto it = side.rbegin(); it != side.rend(); ++it) y.push_back(-*it);
  y.insert(y.end(), side.begin() + 1, side.end());

  const int rows = intervalsFor(sizes.rimDepth, h, growth, sizes.sectionSize);
  auto depth = gradedSpacing(rows, h / sizes.rimDepth);
  std::reverse(depth.begin(), depth.end());

  SectionMesh mesh;
  const int n = static_cast<int>(y.size());
  // Conical at the tread, cylindrical where the rim meets the wheel body.
  for (const double s : depth)
    for (const double at : y)
      mesh.nodes.push_back({wheelset.radius - s * sizes.rimDepth - (1 - s) * sizes.treadSlope * at, at});
  for (int j = 0; j + 1 < static_cast<int>(depth.size()); ++j)
    for (int i = 0; i + 1 < n; ++i)
      mesh.quads.push_back({j * n + i, (j + 1) * n + i, (j + 1) * n + i + 1, j * n + i + 1});
  return mesh;
}

SectionMesh wheelBodySectionMesh(const scenario::Wheelset& w, const WheelSectionSizes& sizes) {
  const double rimOuter = w.radius - sizes.rimDepth, half = w.rimWidth / 2, hub = w.hubWidth / 2,
               web = w.webThickness / 2;
  const std::vector<Rectangle> solids{{w.boreRadius, w.axleRadius, -w.trackCentre, -hub},    // axle body
                                      {w.boreRadius, w.seatRadius, -hub, hub},               // wheel seat
                                      {w.seatRadius, w.hubRadius, -hub, hub},                // hub
                                      {w.hubRadius, w.rimInnerRadius, -web, web},            // web
                                      {w.rimInnerRadius, rimOuter, -half, half},             // inner rim
                                      {w.boreRadius, w.shoulderRadius, hub, w.shoulderEnd},  // shoulder outside the hub
                                      {w.boreRadius, w.journalRadius, w.shoulderEnd, w.journalEnd}};
  std::vector<double> radii, lateral;
  for (const auto& s : solids) {
    radii.push_back(s.inner), radii.push_back(s.outer);
    lateral.push_back(s.from), lateral.push_back(s.to);
  }
  lateral.push_back(w.bearingCentre - w.bearingWidth / 2), lateral.push_back(w.bearingCentre + w.bearingWidth / 2);
  lateral.push_back(0.0);
  const double largest = 2.5 * sizes.sectionSize;
  const auto r = gridLines(radii, largest);
  const auto y = gridLines(lateral, largest);
  const auto inside = [&](double radius, double at) {
    return std::any_of(solids.begin(), solids.end(), [&](const Rectangle& s) {
      return radius > s.inner && radius < s.outer && at > s.from && at < s.to;
    });
  };
  SectionMesh mesh;
  std::map<std::pair<int, int>, int> ids;
  const auto node = [&](int i, int j) {
    const auto [entry, fresh] = ids.try_emplace({i, j}, static_cast<int>(mesh.nodes.size()));
    if (fresh) mesh.nodes.push_back({r[i], shiftedForWeb(w, r[i], y[j])});
    return entry->second;
  };
  for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j)
    for (int i = 0; i + 1 < static_cast<int>(r.size()); ++i)
      if (inside(0.5 * (r[i] + r[i + 1]), 0.5 * (y[j] + y[j + 1]))) {
        const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
        mesh.quads.push_back({a, b, c, d});
      }
  return mesh;
}

}  // namespace squat::geometry
