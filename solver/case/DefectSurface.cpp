#include "case/DefectSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace squat::cases {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double runOut = 0.02;  // [m] over which an end that is not at zero runs out

DefectShape shapeOf(const Defect& defect) { return static_cast<DefectShape>(defect.shape); }

struct HeightAndSlope {
  double height = 0, slope = 0;
};

// Half a cosine from height a at s = 0 to b at s = length.
HeightAndSlope halfCosine(double s, double length, double a, double b) {
  const double angle = pi * s / length;
  return {a + (b - a) * 0.5 * (1 - std::cos(angle)), (b - a) * 0.5 * pi / length * std::sin(angle)};
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
  return {-0.5 * depth * (1 + std::cos(k * x)), 0.5 * depth * k * std::sin(k * x)};
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
  return {-0.5 * defect.waveDepth * (1 - std::cos(k * s)), -0.5 * defect.waveDepth * k * std::sin(k * s)};
}

// One-sided slope at an end, three points, kept monotone (as in Fritsch and Butland's code).
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

HeightAndSlope hermite(double s, double h, double a, double b, double slopeA, double slopeB) {
  const double t = s / h, u = 1 - t;
  const double height = u * u * ((1 + 2 * t) * a + t * h * slopeA) + t * t * ((1 + 2 * u) * b - u * h * slopeB);
  const double slope = 6 * t * u * (b - a) / h + u * (1 - 3 * t) * slopeA + t * (1 - 3 * u) * slopeB;
  return {height, slope};
}

}  // namespace

DefectSurface::DefectSurface(const Defect& defect) : defect_(defect) {
  defect_.points.clear();
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
      for (const auto& point : defect.points) nodes_.push_back({point.position, point.height * defect.heightScale, 0});
      takeProfile();
      break;
  }
  measure();
}

void DefectSurface::takeProfile() {
  if (nodes_.size() < 2) {
    nodes_.clear();
    return;
  }
  level();
  const auto deepest =
      std::min_element(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.height < b.height; });
  const double shift = deepest->position;
  for (auto& node : nodes_) node.position -= shift;
  trim();
  findSlopes();
}

void DefectSurface::level() {
  const Node start = nodes_.front(), end = nodes_.back();
  if (defect_.level) {
    const double grade = (end.height - start.height) / (end.position - start.position);
    for (auto& node : nodes_) node.height -= start.height + grade * (node.position - start.position);
    nodes_.front().height = nodes_.back().height = 0;
    return;
  }
  if (start.height != 0) nodes_.insert(nodes_.begin(), {start.position - runOut, 0, 0});
  if (end.height != 0) nodes_.push_back({end.position + runOut, 0, 0});
}

// Flat lead-in and run-out are no part of the defect.
void DefectSurface::trim() {
  const auto rises = [](const Node& node) { return node.height != 0; };
  const auto firstRise = std::find_if(nodes_.begin(), nodes_.end(), rises);
  if (firstRise == nodes_.end()) {
    nodes_.clear();
    return;
  }
  const auto behindLast = std::find_if(nodes_.rbegin(), nodes_.rend(), rises).base();
  if (behindLast != nodes_.end()) nodes_.erase(behindLast + 1, nodes_.end());
  if (firstRise != nodes_.begin()) nodes_.erase(nodes_.begin(), firstRise - 1);
}

void DefectSurface::findSlopes() {
  const std::size_t n = nodes_.size();
  if (n < 2) return;
  first_ = nodes_.front().position;
  last_ = nodes_.back().position;
  const auto width = [&](std::size_t i) { return nodes_[i + 1].position - nodes_[i].position; };
  const auto secant = [&](std::size_t i) { return (nodes_[i + 1].height - nodes_[i].height) / width(i); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = secant(i - 1), behind = secant(i);
    if (before * behind <= 0) continue;  // an extremum of the points is one of the curve
    const double w1 = 2 * width(i) + width(i - 1), w2 = width(i) + 2 * width(i - 1);
    nodes_[i].slope = (w1 + w2) / (w1 / before + w2 / behind);
  }
  // Ends that join the plane rail do so without a kink; endSlope is for levelled data whose end is not at rest.
  if (n > 2 && nodes_.front().height != 0) nodes_.front().slope = endSlope(width(0), width(1), secant(0), secant(1));
  if (n > 2 && nodes_.back().height != 0)
    nodes_.back().slope = endSlope(width(n - 2), width(n - 3), secant(n - 2), secant(n - 3));
}

// Positions between which slopes and edges are looked for: 4000 steps of an analytic shape, four in every interval of a
// profile, within which it is monotone.
std::vector<double> DefectSurface::marks() const {
  std::vector<double> marks;
  constexpr int steps = 4000, parts = 4;
  if (nodes_.empty())
    for (int i = 0; i <= steps; ++i) marks.push_back(first_ + (last_ - first_) * i / steps);
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
    for (int k = 0; k < parts; ++k)
      marks.push_back(nodes_[i].position + (nodes_[i + 1].position - nodes_[i].position) * k / parts);
  if (!nodes_.empty()) marks.push_back(last_);
  return marks;
}

void DefectSurface::measure() {
  if (first_ == last_) return;
  depth_ = std::max(0.0, -alongHeight(0));
  const double shallow = -0.05 * depth_;
  const auto all = marks();
  double from = first_, to = last_;  // edges of the dip around x = 0
  for (const double x : all) {
    steepest_ = std::max(steepest_, std::abs(alongSlope(x)));
    if (alongHeight(x) < shallow) continue;
    if (x <= 0) from = x;
    if (x >= 0) to = std::min(to, x);
  }
  dipLength_ = depth_ > 0 ? to - from : 0;
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
    if (nodes_[i + 1].position > from && nodes_[i].position < to)
      spacing_ = std::max(spacing_, nodes_[i + 1].position - nodes_[i].position);
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

double DefectSurface::alongHeight(double x) const {
  if (!(x > first_ && x < last_)) return 0;
  if (nodes_.empty()) return analytic(defect_, x).height;
  const auto next = std::upper_bound(nodes_.begin(), nodes_.end(), x,
                                     [](double value, const Node& node) { return value < node.position; });
  const Node &b = *next, &a = *(next - 1);
  return hermite(x - a.position, b.position - a.position, a.height, b.height, a.slope, b.slope).height;
}

double DefectSurface::alongSlope(double x) const {
  if (nodes_.empty()) return analytic(defect_, x).slope;
  if (!(x >= first_ && x < last_)) return 0;
  const auto next = std::upper_bound(nodes_.begin(), nodes_.end(), x,
                                     [](double value, const Node& node) { return value < node.position; });
  const Node &b = *next, &a = *(next - 1);
  return hermite(x - a.position, b.position - a.position, a.height, b.height, a.slope, b.slope).slope;
}

double DefectSurface::across(double y) const {
  if (static_cast<LateralShape>(defect_.lateral) == LateralShape::uniform) return 1;
  const double share = y / defect_.halfWidth;
  return std::abs(share) < 1 ? 1 - share * share : 0;
}

double DefectSurface::height(double x, double y) const { return alongHeight(x) * across(y); }
double DefectSurface::slope(double x, double y) const { return alongSlope(x) * across(y); }

std::vector<ProfilePoint> DefectSurface::samples() const {
  std::vector<ProfilePoint> points;
  for (const auto& node : nodes_) points.push_back({node.position, node.height});
  if (!points.empty() || first_ == last_) return points;
  const int count = std::max(2, static_cast<int>(std::ceil((last_ - first_) / 0.001)));
  for (int i = 0; i <= count; ++i) {
    const double x = first_ + (last_ - first_) * i / count;
    points.push_back({x, alongHeight(x)});
  }
  return points;
}

double defectHeight(const Defect& defect, double x, double y) { return DefectSurface(defect).height(x, y); }

std::vector<ProfilePoint> rigidWheelPath(const DefectSurface& surface, double radius, double from, double to,
                                         double step) {
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
    double height = surface.height(x);
    for (int k = -half; k <= half; ++k) {
      const double s = std::clamp(k * fine, -radius, radius);
      height = std::max(height, surface.height(x + s) - (radius - std::sqrt(radius * radius - s * s)));
    }
    path.push_back({x, height});
  }
  return path;
}

}  // namespace squat::cases
