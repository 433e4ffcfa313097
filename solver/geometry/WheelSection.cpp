#include "geometry/WheelSection.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scenario/Vehicle.h"

namespace squat::geometry {

namespace {

std::vector<double> scaled(const std::vector<double>& fractions, double from, double to) {
  std::vector<double> values;
  for (const double s : fractions) values.push_back(from + s * (to - from));
  return values;
}

// Radii and widths that nearly meet would squeeze elements between them, and the flattest element sets the stable step
// of the whole model. Marks closer than this share one line of nodes, and the surface tapers from one to the other. The
// same on every mesh, so that all have one geometry.
constexpr double thinnest = 0.012;  // [m]

// Intervals of a length: none longer than `largest`, but where it is `narrowed` none shorter than the thinnest or half
// of the largest: there is nothing to gain from elements that are finer than elsewhere only where the body is thin.
int intervals(double length, double largest, double narrowed) {
  const int fine = static_cast<int>(std::ceil(length / largest - 1e-6));
  const int coarse = static_cast<int>(narrowed / std::min(thinnest, 0.5 * largest));
  return std::max(1, std::min(fine, coarse));
}

void divide(std::vector<double>& lines, double to, int count) {
  const double from = lines.back();
  for (int k = 1; k <= count; ++k) lines.push_back(from + (to - from) * k / count);
}

void divide(std::vector<double>& lines, double to, double largest) {
  const double length = to - lines.back();
  if (length > 1e-6) divide(lines, to, intervals(length, largest, length));
}

struct Edges {
  double inner, outer;  // y of both faces of the web
};

// Where a web of the given thickness meets a solid from -half to half: a face that comes close to that of the solid
// ends on it.
Edges edgesOn(double half, double middle, double thickness) {
  Edges edges{middle - thickness / 2, middle + thickness / 2};
  if (edges.inner + half < thinnest) edges.inner = -half;
  if (half - edges.outer < thinnest) edges.outer = half;
  return edges;
}

// Parts of the axle along it, from the track centre outwards; the hub with the wheel seat in it.
enum class Part { axle, hub, shoulder, journal };

bool hasShoulder(const scenario::Wheelset& w) { return w.shoulderEnd - w.hubWidth / 2 >= thinnest; }

// A line of nodes along the axle: its radius within each part.
using Line = std::map<Part, double>;

struct AxleLines {
  std::vector<Line> lines;      // from the bore outwards
  std::map<Part, int> surface;  // line that is the surface of each part
};

// A narrow bore makes elements thin around it. What lies within 0.3 of the thinnest radius carries 1 % of the bending
// stiffness, 0.3^4: it is left out there, and its mass counts where the model spreads what the solids do not weigh.
double boreLineRadius(const scenario::Wheelset& w) {
  constexpr double wide = 0.025;  // [m]
  double thin = std::min(w.axleRadius, w.journalRadius);
  if (hasShoulder(w)) thin = std::min(thin, w.shoulderRadius);
  return std::max(w.boreRadius, std::min(wide, 0.3 * thin));
}

// Lines through the surface of every part, one for those that nearly meet, and through the wheel seat where it has
// room: the seat only divides the hub's solid. A line that is no surface in a part keeps the mean of its radii there.
AxleLines axleLines(const scenario::Wheelset& w) {
  std::vector<std::pair<double, Part>> surfaces{
      {w.axleRadius, Part::axle}, {w.hubRadius, Part::hub}, {w.journalRadius, Part::journal}};
  if (hasShoulder(w)) surfaces.push_back({w.shoulderRadius, Part::shoulder});
  std::sort(surfaces.begin(), surfaces.end());
  const bool seatHasRoom = std::all_of(surfaces.begin(), surfaces.end(), [&](const auto& surface) {
    return std::abs(surface.first - w.seatRadius) >= thinnest;
  });
  AxleLines found;
  const auto add = [&](double radius) {
    found.lines.push_back(
        {{Part::axle, radius}, {Part::hub, radius}, {Part::shoulder, radius}, {Part::journal, radius}});
  };
  add(boreLineRadius(w));
  for (std::size_t i = 0; i < surfaces.size();) {
    std::size_t end = i + 1;
    double sum = surfaces[i].first;
    for (; end < surfaces.size() && surfaces[end].first - surfaces[end - 1].first < thinnest; ++end)
      sum += surfaces[end].first;
    if (seatHasRoom && w.seatRadius > found.lines.back()[Part::hub] && w.seatRadius < surfaces[i].first)
      add(w.seatRadius);
    add(sum / static_cast<double>(end - i));
    for (; i < end; ++i) {
      const auto [radius, part] = surfaces[i];
      found.lines.back()[part] = radius;
      found.surface[part] = static_cast<int>(found.lines.size()) - 1;
    }
  }
  return found;
}

// Radius where two parts meet. Surfaces on one line: that of the hub stays, the wider one of two others tapers.
double radiusBetween(const AxleLines& axle, int line, Part left, Part right) {
  const double a = axle.lines[line].at(left), b = axle.lines[line].at(right);
  const bool isLeft = axle.surface.at(left) == line, isRight = axle.surface.at(right) == line;
  if (isLeft != isRight) return isLeft ? a : b;
  return left == Part::hub ? a : right == Part::hub ? b : std::min(a, b);
}

// Inner radius of the rim: the web between hub and rim keeps a length, the rim a thickness.
double rimLineRadius(const scenario::Wheelset& w, double rimOuter) {
  const double room = rimOuter - w.hubRadius;
  const double thickness = std::min(thinnest, room / 2);
  return w.hubRadius + std::clamp(w.rimInnerRadius - w.hubRadius, thickness, room - thickness);
}

// y of the lines across the axle: both ends of every part and the faces of the web, then what keeps its distance: the
// middle of the web, the faces of the rim and the ends of the bearing.
std::vector<double> linesAcross(const scenario::Wheelset& w, const Edges& web, double largest) {
  const double face = w.hubWidth / 2;
  std::vector<double> marks{-w.trackCentre, -face, web.inner, web.outer, face, w.journalEnd};
  if (hasShoulder(w)) marks.push_back(w.shoulderEnd);
  const auto addWithRoom = [&](double y) {
    const bool inWeb = y > web.inner && y < web.outer;
    if (!inWeb && std::none_of(marks.begin(), marks.end(), [&](double at) { return std::abs(at - y) < thinnest; }))
      marks.push_back(y);
  };
  for (const double y :
       {-w.rimWidth / 2, w.rimWidth / 2, w.bearingCentre - w.bearingWidth / 2, w.bearingCentre + w.bearingWidth / 2})
    addWithRoom(y);
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());  // a face of the web on that of the hub
  std::vector<double> lines{marks.front()};
  for (std::size_t i = 1; i < marks.size(); ++i) {
    if (marks[i] <= web.inner || marks[i] > web.outer) {
      divide(lines, marks[i], largest);
      continue;
    }
    const double thickness = web.outer - web.inner, thin = std::min(thickness, w.webThickness);
    const int halves = 2 * intervals(0.5 * std::max(thickness, w.webThickness), largest, 0.5 * thin);
    divide(lines, web.outer, 0.5 * thin < thinnest ? 1 : halves);
  }
  return lines;
}

Part partAt(const scenario::Wheelset& w, double y) {
  const double face = w.hubWidth / 2;
  if (y < face) return y < -face ? Part::axle : Part::hub;
  return hasShoulder(w) && y < w.shoulderEnd ? Part::shoulder : Part::journal;
}

using Points = std::vector<Point2>;

Points onRadius(double radius, const std::vector<double>& y) {
  Points line;
  for (const double at : y) line.push_back({radius, at});
  return line;
}

void addStrip(BlockMesher& mesher, const Points& inner, const Points& outer, double largest) {
  double narrowest = 1e9, sum = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const double gap = outer[i][0] - inner[i][0];
    narrowest = std::min(narrowest, gap), sum += gap;
  }
  mesher.addStrip(inner, outer, intervals(sum / static_cast<double>(inner.size()), largest, narrowest));
}

// Axle with its hub and journal.
void addAxle(BlockMesher& mesher, const scenario::Wheelset& w, const std::vector<double>& y, double largest) {
  const auto axle = axleLines(w);
  std::vector<Part> part;  // between lines j and j + 1
  for (std::size_t j = 0; j + 1 < y.size(); ++j) part.push_back(partAt(w, 0.5 * (y[j] + y[j + 1])));
  const auto point = [&](int line, std::size_t j) {
    const Part left = part[j == 0 ? 0 : j - 1], right = part[std::min(j, part.size() - 1)];
    return Point2{radiusBetween(axle, line, left, right), y[j]};
  };
  for (int line = 0; line + 1 < static_cast<int>(axle.lines.size()); ++line)
    for (std::size_t j = 0; j < part.size(); ++j) {
      if (axle.surface.at(part[j]) <= line) continue;
      Points inner{point(line, j)}, outer{point(line + 1, j)};
      for (; j < part.size() && axle.surface.at(part[j]) > line; ++j)
        inner.push_back(point(line, j + 1)), outer.push_back(point(line + 1, j + 1));
      addStrip(mesher, inner, outer, largest);
    }
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

double seatLineRadius(const scenario::Wheelset& w) {
  const auto axle = axleLines(w);
  const auto distance = [&](const Line& line) { return std::abs(line.at(Part::hub) - w.seatRadius); };
  return (*std::min_element(axle.lines.begin() + 1, axle.lines.begin() + axle.surface.at(Part::hub) + 1,
                            [&](const Line& a, const Line& b) { return distance(a) < distance(b); }))
      .at(Part::hub);
}

SectionMesh wheelBodySectionMesh(const scenario::Wheelset& w, const WheelSectionSizes& sizes) {
  const double rimOuter = w.radius - sizes.rimDepth, rimInner = rimLineRadius(w, rimOuter);
  const double half = w.rimWidth / 2, largest = 2.5 * sizes.sectionSize;
  const Edges atHub = edgesOn(w.hubWidth / 2, w.webOffset, w.webHubThickness > 0 ? w.webHubThickness : w.webThickness);
  const Edges atRim = edgesOn(half, 0, w.webThickness);

  const auto across = linesAcross(w, atHub, largest);
  std::vector<double> foot, top, rim{-half};
  for (const double y : across) {
    if (y < atHub.inner - 1e-9 || y > atHub.outer + 1e-9) continue;
    foot.push_back(y);
    top.push_back(atRim.inner + (y - atHub.inner) * (atRim.outer - atRim.inner) / (atHub.outer - atHub.inner));
  }
  divide(rim, atRim.inner, largest);
  for (const double y : top)
    if (y > rim.back() + 1e-9) rim.push_back(y);
  divide(rim, half, largest);

  BlockMesher mesher(1e-8);
  addAxle(mesher, w, across, largest);
  addStrip(mesher, onRadius(w.hubRadius, foot), onRadius(rimInner, top), largest);
  addStrip(mesher, onRadius(rimInner, rim), onRadius(rimOuter, rim), largest);
  return mesher.take();
}

}  // namespace squat::geometry
