#include "geometry/RailSection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/ElementaryFunctions.h"

namespace squat::geometry {

namespace {

constexpr double fishing = 2.75;  // slope 1:2.75 of the fishing surfaces

// Head, height, depths, web's thickness and foot's width are the numbers of EN 13674-1 as published, R7 under the head
// as well. Round corners of head and foot are left out; the rest is fitted to the published integrals.
// Web's radius and middle, fillet R20 and edge; foot beyond 1:2.75 with about 1:12. Published and met: area 69.77 cm2
// (69.76), centroid 75.1 mm above the base (75.15), moments 2337.9 and 419.2 cm4 (2337.9 and 418.9).
constexpr RailProfile rail54E1{.crownRadius = 0.300,
                               .crownEnd = 0.010012,
                               .shoulderRadius = 0.080,
                               .shoulderEnd = 0.0248635,
                               .touchEnd = 0.0248,
                               .cornerRadius = 0.013,
                               .sideStartY = 0.035,
                               .sideStartZ = -0.0141,
                               .height = 0.159,
                               .headDepth = 0.0494,
                               .footDepth = 0.0302,
                               .webHalf = 0.008,
                               .webRadius = 0.508,
                               .webMiddle = -0.159 + 0.0699,
                               .headFillet = 0.007,
                               .footFillet = 0.020,
                               .footHalf = 0.070,
                               .footBreak = 0.0477,
                               .footEdge = 0.011};
// Web's radius and middle, foot's fillet and edge (11.5 mm less what its round corners lack), foot beyond 1:2.75 with
// 1:14. Published and met: area 76.70 cm2 (76.70), centroid 80.9 mm above the base (80.88), moments 3038.3 and 512.3
// cm4 (3036.7 and 512.3). Web R120 and fillet R35, as lists of dimensions have them, would give 7.6 % more area.
constexpr RailProfile rail60E1{.crownRadius = 0.300,
                               .crownEnd = 0.010228,
                               .shoulderRadius = 0.080,
                               .shoulderEnd = 0.0260265,
                               .touchEnd = 0.0260,
                               .cornerRadius = 0.013,
                               .sideStartY = 0.036,
                               .sideStartZ = -0.0143,
                               .height = 0.172,
                               .headDepth = 0.051,
                               .footDepth = 0.0315,
                               .webHalf = 0.00825,
                               .webRadius = 0.665,
                               .webMiddle = -0.172 + 0.066,
                               .headFillet = 0.007,
                               .footFillet = 0.0215,
                               .footHalf = 0.075,
                               .footBreak = 0.0508,
                               .footEdge = 0.0113};

using Polyline = std::vector<Point2>;

void addArc(Polyline& line, Point2 centre, double radius, double from, double to, int count = 64) {
  for (int i = line.empty() ? 0 : 1; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    line.push_back({centre[0] + radius * elementary::cos(angle), centre[1] + radius * elementary::sin(angle)});
  }
}

double angleOf(const Point2& centre, const Point2& p) { return elementary::atan2(p[1] - centre[1], p[0] - centre[0]); }

struct HeadArcs {
  Point2 crownCentre, shoulderCentre, cornerCentre;
  Point2 crownStop, shoulderStop;
};

HeadArcs headArcs(const RailProfile& p) {
  HeadArcs arcs;
  arcs.crownCentre = {0, -p.crownRadius};
  const double a1 = elementary::acos(p.crownEnd / p.crownRadius);
  arcs.crownStop = {p.crownRadius * elementary::cos(a1), -p.crownRadius + p.crownRadius * elementary::sin(a1)};
  arcs.shoulderCentre = {arcs.crownStop[0] - p.shoulderRadius * elementary::cos(a1),
                         arcs.crownStop[1] - p.shoulderRadius * elementary::sin(a1)};
  const double a2 = elementary::acos((p.shoulderEnd - arcs.shoulderCentre[0]) / p.shoulderRadius);
  arcs.shoulderStop = {arcs.shoulderCentre[0] + p.shoulderRadius * elementary::cos(a2),
                       arcs.shoulderCentre[1] + p.shoulderRadius * elementary::sin(a2)};
  arcs.cornerCentre = {arcs.shoulderStop[0] - p.cornerRadius * elementary::cos(a2),
                       arcs.shoulderStop[1] - p.cornerRadius * elementary::sin(a2)};
  return arcs;
}

struct Fillet {
  Point2 centre, onLine, onWeb;
};

// Circle of radius r in the void between the web (circle of webRadius about (webHalf + webRadius, webMiddle)) and the
// line z = z0 + slope y; side = -1: the void is below the line, +1: above it.
Fillet filletBetween(const RailProfile& p, double z0, double slope, double side, double r) {
  const Point2 webCentre{p.webHalf + p.webRadius, p.webMiddle};
  const double norm = std::sqrt(1 + slope * slope);
  const auto centreAt = [&](double y) { return Point2{y, z0 + slope * y + side * r * norm}; };
  const auto excess = [&](double y) {
    const auto c = centreAt(y);
    return elementary::hypot(c[0] - webCentre[0], c[1] - webCentre[1]) - (p.webRadius - r);
  };
  double low = p.webHalf, high = p.webHalf + 4 * r;  // excess falls from positive to negative with y
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0 ? low : high) = middle;
  }
  Fillet fillet;
  fillet.centre = centreAt(0.5 * (low + high));
  fillet.onLine = {fillet.centre[0] + side * r * slope / norm, fillet.centre[1] - side * r / norm};
  const double scale = p.webRadius / (p.webRadius - r);
  fillet.onWeb = {webCentre[0] + (fillet.centre[0] - webCentre[0]) * scale,
                  webCentre[1] + (fillet.centre[1] - webCentre[1]) * scale};
  return fillet;
}

// Points at the given arc-length fractions of a polyline.
Polyline sample(const Polyline& line, const std::vector<double>& fractions) {
  std::vector<double> s(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i)
    s[i] = s[i - 1] + elementary::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  Polyline points;
  for (const double fraction : fractions) {
    const double target = fraction * s.back();
    auto next = std::upper_bound(s.begin(), s.end(), target) - s.begin();
    next = std::clamp<std::ptrdiff_t>(next, 1, static_cast<std::ptrdiff_t>(s.size()) - 1);
    const double t = (target - s[next - 1]) / (s[next] - s[next - 1]);
    points.push_back({line[next - 1][0] + t * (line[next][0] - line[next - 1][0]),
                      line[next - 1][1] + t * (line[next][1] - line[next - 1][1])});
  }
  return points;
}

Polyline straight(const Point2& a, const Point2& b, const std::vector<double>& fractions) {
  Polyline points;
  for (const double t : fractions) points.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
  return points;
}

std::vector<double> uniform(int count) {
  std::vector<double> s(count + 1);
  for (int i = 0; i <= count; ++i) s[i] = static_cast<double>(i) / count;
  return s;
}

double lengthOf(const Polyline& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += elementary::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return length;
}

}  // namespace

const RailProfile& railProfile(RailSection section) { return section == RailSection::rail60E1 ? rail60E1 : rail54E1; }

RailOutline railOutline(RailSection section) {
  const RailProfile& p = railProfile(section);
  RailOutline out;
  const HeadArcs arcs = headArcs(p);
  const double quarter = elementary::acos(0.0);
  const Point2 sideStart{p.sideStartY, p.sideStartZ};
  const double cornerFrom = angleOf(arcs.cornerCentre, arcs.shoulderStop);
  const double cornerTo = angleOf(arcs.cornerCentre, sideStart);
  const double cornerMiddle = 0.5 * (cornerFrom + cornerTo);
  addArc(out.crown, arcs.crownCentre, p.crownRadius, quarter, angleOf(arcs.crownCentre, arcs.crownStop));
  addArc(out.crown, arcs.shoulderCentre, p.shoulderRadius, angleOf(arcs.shoulderCentre, arcs.crownStop), cornerFrom);
  addArc(out.crown, arcs.cornerCentre, p.cornerRadius, cornerFrom, cornerMiddle);
  addArc(out.headSide, arcs.cornerCentre, p.cornerRadius, cornerMiddle, cornerTo);
  // Side 1:20 meets the underside z = -headDepth + y / 2.75.
  const double cornerY = (p.sideStartZ + 20 * p.sideStartY + p.headDepth) / (20 + 1 / fishing);
  const Point2 lowerCorner{cornerY, -p.headDepth + cornerY / fishing};
  out.headSide.push_back(lowerCorner);

  const Fillet head = filletBetween(p, -p.headDepth, 1 / fishing, -1, p.headFillet);
  const Fillet foot = filletBetween(p, -p.height + p.footDepth, -1 / fishing, +1, p.footFillet);
  const Point2 webCentre{p.webHalf + p.webRadius, p.webMiddle};
  const double headLine = angleOf(head.centre, head.onLine), headWeb = angleOf(head.centre, head.onWeb);
  // The arc from the underside (pointing up) to the web (pointing inwards, angle near pi) is taken the short way.
  const auto unwrapped = [](double angle) { return angle < 0 ? angle + 2 * std::numbers::pi : angle; };
  const double headMiddle = 0.5 * (unwrapped(headLine) + unwrapped(headWeb));
  addArc(out.underside, head.centre, p.headFillet, headMiddle, unwrapped(headLine));
  out.underside.push_back(lowerCorner);
  addArc(out.web, head.centre, p.headFillet, headMiddle, unwrapped(headWeb));
  addArc(out.web, webCentre, p.webRadius, unwrapped(angleOf(webCentre, head.onWeb)),
         unwrapped(angleOf(webCentre, foot.onWeb)));
  const double footWeb = unwrapped(angleOf(foot.centre, foot.onWeb)),
               footLine = unwrapped(angleOf(foot.centre, foot.onLine));
  const double footMiddle = 0.5 * (footWeb + footLine);
  addArc(out.web, foot.centre, p.footFillet, footWeb, footMiddle);
  addArc(out.footTop, foot.centre, p.footFillet, footMiddle, footLine);
  out.footTop.push_back({p.footBreak, -p.height + p.footDepth - p.footBreak / fishing});
  out.footTop.push_back({p.footHalf, -p.height + p.footEdge});
  return out;
}

double crownHeight(RailSection section, double y) {
  const RailProfile& p = railProfile(section);
  const HeadArcs arcs = headArcs(p);
  const double a = std::abs(y);
  if (a <= p.crownEnd) return -p.crownRadius + std::sqrt(p.crownRadius * p.crownRadius - y * y);
  const double d = std::min(a, p.shoulderEnd) - arcs.shoulderCentre[0];
  const double z = arcs.shoulderCentre[1] + std::sqrt(p.shoulderRadius * p.shoulderRadius - d * d);
  return a <= p.shoulderEnd ? z : z + (a - p.shoulderEnd) * crownSlope(section, p.shoulderEnd);
}

double crownSlope(RailSection section, double y) {
  const RailProfile& p = railProfile(section);
  const HeadArcs arcs = headArcs(p);
  const double a = std::min(std::abs(y), p.shoulderEnd), sign = y < 0 ? -1 : 1;
  if (a <= p.crownEnd) return -sign * a / std::sqrt(p.crownRadius * p.crownRadius - a * a);
  const double d = a - arcs.shoulderCentre[0];
  return -sign * d / std::sqrt(p.shoulderRadius * p.shoulderRadius - d * d);
}

SectionMesh railSectionMesh(RailSection section, const RailSectionSizes& sizes) {
  const RailProfile& p = railProfile(section);
  const RailOutline out = railOutline(section);
  const double h = sizes.contactSize, band = sizes.bandHalfWidth;
  const int columns = std::max(2, static_cast<int>(std::lround(band / h)));  // half the band
  const double growth = sizes.growth;

  // Split the crown at the band edge: the arc-length fraction where y = band.
  const double crownLength = lengthOf(out.crown);
  const double bandFraction = p.crownRadius * elementary::asin(band / p.crownRadius) / crownLength;
  Polyline inner, outer;
  for (const double s : uniform(columns)) inner.push_back(sample(out.crown, {s * bandFraction})[0]);
  inner.front() = {0, 0};
  const double outerLength = crownLength * (1 - bandFraction);
  const int sideColumns = intervalsFor(outerLength, growth * h, growth, sizes.sectionSize);
  for (const double s : gradedSpacing(sideColumns, growth * h / outerLength))
    outer.push_back(sample(out.crown, {bandFraction + (1 - bandFraction) * s})[0]);
  outer.front() = inner.back();

  const Point2 headMiddle = out.web.front(), footMiddle = out.web.back();
  const double headCentre = headMiddle[1] + 0.001, footCentre = footMiddle[1] - 0.002;
  const int headRows = intervalsFor(-headCentre, h, growth, sizes.sectionSize);
  const auto depth = gradedSpacing(headRows, h / -headCentre);
  std::vector<double> upwards(depth.rbegin(), depth.rend());
  for (auto& s : upwards) s = 1 - s;

  // From the first row on that is four times as high as the band's quads are wide: deeper than the patch is long.
  int coarseRows = 0;
  if (sizes.coarseBelow && columns % 3 == 0)
    while (coarseRows + 1 < headRows && (upwards[coarseRows + 2] - upwards[coarseRows + 1]) * -headCentre > 4 * h)
      ++coarseRows;
  const int lowColumns = coarseRows > 0 ? columns / 3 : columns;

  BlockMesher mesher(1e-7);
  // Head, middle part: columns from the axis to the line from the fillet up to the band edge.
  const Polyline axisHead = straight({0, headCentre}, {0, 0}, upwards);
  const Polyline divide = straight(headMiddle, inner.back(), upwards);
  mesher.addBlock(straight({0, headCentre}, headMiddle, uniform(columns)), inner, axisHead, divide, coarseRows);
  // Head, side part.
  std::vector<double> sideRows = uniform(headRows);
  mesher.addBlock(sample(out.underside, uniform(sideColumns)), outer, divide, [&] {
    auto side = sample(out.headSide, sideRows);
    std::reverse(side.begin(), side.end());
    return side;
  }());
  // Web.
  const double webLength = lengthOf(out.web);
  const int webRows = std::max(4, static_cast<int>(std::ceil(webLength / sizes.sectionSize)));
  Polyline webSide = sample(out.web, uniform(webRows));
  std::reverse(webSide.begin(), webSide.end());
  mesher.addBlock(straight({0, footCentre}, footMiddle, uniform(lowColumns)),
                  straight({0, headCentre}, headMiddle, uniform(lowColumns)),
                  straight({0, footCentre}, {0, headCentre}, uniform(webRows)), webSide);
  // Foot.
  const int footRows = std::max(2, static_cast<int>(std::lround(p.footEdge / std::max(0.5 * sizes.sectionSize, h))));
  const int footColumns = std::max(3, static_cast<int>(std::ceil(lengthOf(out.footTop) / (1.2 * sizes.sectionSize))));
  const Point2 baseMiddle{footMiddle[0] + 0.004, -p.height};
  const Polyline footDivide = straight(baseMiddle, footMiddle, uniform(footRows));
  mesher.addBlock(straight({0, -p.height}, baseMiddle, uniform(lowColumns)),
                  straight({0, footCentre}, footMiddle, uniform(lowColumns)),
                  straight({0, -p.height}, {0, footCentre}, uniform(footRows)), footDivide);
  mesher.addBlock(straight(baseMiddle, {p.footHalf, -p.height}, uniform(footColumns)),
                  sample(out.footTop, uniform(footColumns)), footDivide,
                  straight({p.footHalf, -p.height}, {p.footHalf, -p.height + p.footEdge}, uniform(footRows)));
  mesher.mirror();
  return mesher.take();
}

}  // namespace squat::geometry
