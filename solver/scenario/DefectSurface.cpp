#include "scenario/DefectSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/ElementaryFunctions.h"
#include "scenario/MeasuredProfile.h"

namespace squat::scenario {

namespace {

constexpr double pi = std::numbers::pi;

DefectShape shapeOf(const Defect& defect) { return defect.shape; }

// Half a cosine from height a at s = 0 to b at s = length.
HeightAndSlope halfCosine(double s, double length, double a, double b) {
  const double angle = pi * s / length;
  return {a + (b - a) * 0.5 * (1 - elementary::cos(angle)), (b - a) * 0.5 * pi / length * elementary::sin(angle)};
}

HeightAndSlope cut(const Defect& defect, double x) {
  const double half = 0.5 * defect.length, ramp = std::min(defect.ramp, half);
  const double fromEnd = half - std::abs(x);
  if (fromEnd <= 0 && !(fromEnd == 0 && x < 0)) return {};
  const double grade = defect.depth / ramp;
  if (fromEnd < ramp) return {-grade * fromEnd, x < 0 ? -grade : grade};
  return {-defect.depth, x >= 0 && fromEnd == ramp ? grade : 0};
}

HeightAndSlope cosine(double length, double depth, double x) {
  if (std::abs(x) >= 0.5 * length) return {};
  const double k = 2 * pi / length;
  return {-0.5 * depth * (1 + elementary::cos(k * x)), 0.5 * depth * k * elementary::sin(k * x)};
}

HeightAndSlope wShape(const Defect& defect, double x) {
  const double quarter = 0.25 * defect.length, s = x + quarter;
  if (s <= 0 || s >= defect.length) return {};
  const double bottom = -defect.depth, middle = -defect.depth * (1 - defect.middleHeight);
  const double corners[5] = {0, bottom, middle, bottom, 0};
  const int part = std::min(3, static_cast<int>(s / quarter));
  return halfCosine(s - part * quarter, quarter, corners[part], corners[part + 1]);
}

HeightAndSlope dipWithWave(const Defect& defect, double x) {
  const double s = x - 0.5 * defect.length;
  if (s <= 0) return cosine(defect.length, defect.depth, x);
  if (s >= defect.waveCount * defect.waveLength) return {};
  const double k = 2 * pi / defect.waveLength;
  return {-0.5 * defect.waveDepth * (1 - elementary::cos(k * s)), -0.5 * defect.waveDepth * k * elementary::sin(k * s)};
}

}  // namespace

DefectSurface::DefectSurface(const Defect& defect) : defect_(defect) {
  defect_.points.clear(), defect_.lines.clear();
  switch (shapeOf(defect)) {
    case DefectShape::none:
      return;
    case DefectShape::cut:
    case DefectShape::cosine:
      first_ = -0.5 * defect.length;
      last_ = 0.5 * defect.length;
      break;
    case DefectShape::wshape:
      first_ = -0.25 * defect.length;
      last_ = 0.75 * defect.length;
      break;
    case DefectShape::dipWithWave:
      first_ = -0.5 * defect.length;
      last_ = 0.5 * defect.length + (defect.waveDepth > 0 ? defect.waveCount * defect.waveLength : 0);
      break;
    case DefectShape::profile:
      if (defect.lines.empty())
        curves_.emplace_back(countedPoints(defect.points, defect), defect.heightScale, defect.level);
      for (const auto& line : defect.lines) {
        curves_.emplace_back(countedPoints(line.points, defect), defect.heightScale, defect.level);
        lateral_.push_back(line.lateral + defect.lateralCentre);
      }
      takeLines();
      break;
  }
  measure();
}

void DefectSurface::takeLines() {
  for (std::size_t i = 1; i < curves_.size(); ++i)
    if (curves_[i].deepest().height < curves_[deepestCurve_].deepest().height) deepestCurve_ = i;
  const double origin = curves_[deepestCurve_].deepest().position;
  bool any = false;
  for (auto& curve : curves_) {
    curve.finish(origin);
    if (curve.empty()) continue;
    first_ = any ? std::min(first_, curve.first()) : curve.first();
    last_ = any ? std::max(last_, curve.last()) : curve.last();
    any = true;
  }
  if (!any) curves_.clear(), lateral_.clear(), deepestCurve_ = 0;
}

// Positions between which slopes and edges are looked for: 4000 steps of an analytic shape, four in every interval of a
// profile, within which it is monotone.
std::vector<double> DefectSurface::marks(const ProfileCurve* curve) const {
  std::vector<double> marks;
  constexpr int steps = 4000, parts = 4;
  if (!curve) {
    for (int i = 0; i <= steps; ++i) marks.push_back(first_ + (last_ - first_) * i / steps);
    return marks;
  }
  const auto points = curve->points();
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (int k = 0; k < parts; ++k)
      marks.push_back(points[i].position + (points[i + 1].position - points[i].position) * k / parts);
  if (!points.empty()) marks.push_back(points.back().position);
  return marks;
}

// Where the line, monotone between x and y, crosses a height that lies between those of its ends.
double DefectSurface::crossing(const ProfileCurve* curve, double x, double y, double height) const {
  constexpr int halvings = 40;
  const bool falls = along(curve, x).height >= height;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (x + y);
    ((along(curve, middle).height >= height) == falls ? x : y) = middle;
  }
  return 0.5 * (x + y);
}

void DefectSurface::measure() {
  if (first_ == last_) return;
  const ProfileCurve* deepest = deepestCurve();
  deepestLateral_ = lateral_.empty() ? defect_.lateralCentre : lateral_[deepestCurve_];
  depth_ = std::max(0.0, -along(deepest, 0).height);
  const double shallow = -0.05 * depth_;
  double from = first_, to = last_;  // edges of the dip around x = 0
  double before = first_;            // the mark ahead
  bool wasBelow = false;
  for (const double x : marks(deepest)) {
    const auto here = along(deepest, x);
    steepest_ = std::max(steepest_, std::abs(here.slope));
    const bool isBelow = here.height < shallow;
    if (x <= 0 && !isBelow) from = x;
    if (x <= 0 && isBelow && !wasBelow) from = crossing(deepest, before, x, shallow);
    if (x >= 0 && !isBelow) to = std::min(to, wasBelow ? crossing(deepest, before, x, shallow) : x);
    before = x, wasBelow = isBelow;
  }
  for (const auto& curve : curves_)
    for (const double x : marks(&curve)) steepest_ = std::max(steepest_, std::abs(curve.at(x).slope));
  dipLength_ = depth_ > 0 ? to - from : 0;
  for (const auto& curve : curves_) {
    const auto points = curve.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i + 1].position > from && points[i].position < to)
        spacing_ = std::max(spacing_, points[i + 1].position - points[i].position);
  }
}

namespace {

HeightAndSlope analytic(const Defect& defect, double x) {
  switch (shapeOf(defect)) {
    case DefectShape::cut:
      return cut(defect, x);
    case DefectShape::cosine:
      return cosine(defect.length, defect.depth, x);
    case DefectShape::wshape:
      return wShape(defect, x);
    case DefectShape::dipWithWave:
      return dipWithWave(defect, x);
    default:
      return {};
  }
}

}  // namespace

HeightAndSlope DefectSurface::along(const ProfileCurve* curve, double x) const {
  if (curve) return curve->at(x);
  return analytic(defect_, x);
}

double DefectSurface::across(double y) const {
  if (defect_.lateral == LateralShape::uniform) return 1;
  const double share = (y - defect_.lateralCentre) / defect_.halfWidth;
  return std::abs(share) < 1 ? 1 - share * share : 0;
}

double DefectSurface::height(double x, double y) const {
  if (!(x > first_ && x < last_)) return 0;
  if (lateral_.empty()) return along(deepestCurve(), x).height * across(y);
  std::vector<double> heights;
  for (const auto& curve : curves_) heights.push_back(curve.at(x).height);
  return monotoneBetween(lateral_, heights, y);
}

double DefectSurface::slope(double x, double y) const {
  if (lateral_.empty()) return along(deepestCurve(), x).slope * across(y);
  constexpr double step = 1e-6;  // [m]; between lines the slope is one of interpolated heights
  return (height(x + step, y) - height(x - step, y)) / (2 * step);
}

std::vector<ProfilePoint> DefectSurface::samples() const {
  std::vector<ProfilePoint> points;
  if (const auto* curve = deepestCurve()) points = curve->points();
  if (!points.empty() || first_ == last_) return points;
  const int count = std::max(2, static_cast<int>(std::ceil((last_ - first_) / 0.001)));
  for (int i = 0; i <= count; ++i) {
    const double x = first_ + (last_ - first_) * i / count;
    points.push_back({x, height(x, deepestLateral_)});
  }
  return points;
}

double defectHeight(const Defect& defect, double x, double y) { return DefectSurface(defect).height(x, y); }

std::vector<double> defectHeights(const Defect& defect, double margin, double step) {
  const DefectSurface surface(defect);
  std::vector<double> heights;
  for (double x = surface.first() - margin; x <= surface.last() + margin; x += step)
    heights.push_back(surface.height(x));
  return heights;
}

std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, double radius, double from, double to,
                                         double step, double y) {
  std::vector<ProfilePoint> path;
  if (!(step > 0) || !(to >= from)) return path;
  double lowest = 0, highest = 0;
  for (const auto& point : surface.samples()) {
    lowest = std::min(lowest, point.height);
    highest = std::max(highest, point.height);
  }
  // Beyond this distance the wheel stands higher above its lowest point than all heights differ.
  const double drop = std::min(radius, highest - lowest);
  const double reach = std::sqrt(drop * (2 * radius - drop));
  constexpr double fine = 0.0002;  // [m]
  const int half = static_cast<int>(std::ceil(reach / fine));
  const auto count = static_cast<long>(std::floor((to - from) / step + 1e-9));
  for (long i = 0; i <= count; ++i) {
    const double x = from + static_cast<double>(i) * step;
    double height = surface.height(x, y);
    for (int k = -half; k <= half; ++k) {
      const double s = std::clamp(k * fine, -radius, radius);
      height = std::max(height, surface.height(x + s, y) - (radius - std::sqrt(radius * radius - s * s)));
    }
    path.push_back({x, height});
  }
  return path;
}

}  // namespace squat::scenario
