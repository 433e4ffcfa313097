#include "studio/profile/ProfileModel.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "case/Resolve.h"
#include "scenario/DefectSurface.h"

namespace squat::studio {
namespace {

constexpr double around = 0.04;           // [m] shown beyond the defect
constexpr double smoothHalfLength = 0.1;  // [m] shown of a smooth rail
constexpr double minimumTilt = 1e-7;      // [m] a tenth of the micrometre that heights are read to

bool sampled(const cases::Defect& defect) {
  // Several lines side by side are shown along the middle, not edited point by point.
  return defect.shape == cases::DefectShape::profile && defect.lines.empty() && defect.points.size() >= 2;
}

// The points as they are shown, where the deepest lies and what levelling removes.
ProfileView frameOf(const cases::Defect& defect) {
  ProfileView view;
  if (!sampled(defect)) return view;
  auto& points = view.handles = defect.points;
  for (auto& point : points) point.height *= shownScale(defect);
  const auto &first = points.front(), &last = points.back();
  if (defect.level && std::max(std::abs(first.height), std::abs(last.height)) > minimumTilt)
    view.removed = {first, last};
  const double slope = defect.level ? (last.height - first.height) / (last.position - first.position) : 0;
  view.shift = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
                 return a.height - slope * a.position < b.height - slope * b.position;
               })->position;
  return view;
}

// The defect stays at its place, which is that of its lowest point, although a flat floor is as low elsewhere. Below
// the twelve digits that tables and exports show, so that users read the depth; fifty times the rounding of a number,
// so that the point remains the lowest when heights are scaled and levelled.
constexpr double hairLower = 1e-14;

bool isLowest(const cases::ProfilePoint& point, const std::vector<cases::ProfilePoint>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& each) { return &each == &point || each.height > point.height; });
}

}  // namespace

ProfileView profileView(const cases::CaseDescription& description) {
  ProfileView view = frameOf(description.defect);
  double slope = 0, start = 0;  // of the line that levelling removes
  if (!view.removed.empty()) {
    const auto &first = view.removed.front(), &last = view.removed.back();
    slope = (last.height - first.height) / (last.position - first.position);
    start = first.height - slope * first.position;
  }
  const auto surface = cases::surfaceOf(description);  // as it is run: with the height scale
  const bool none = !(surface.last() > surface.first());
  const double from = none ? -smoothHalfLength : surface.first() - around;
  const double to = none ? smoothHalfLength : surface.last() + around;
  const double step = std::max(1e-4, (to - from) / 1500);
  const double y = description.motion.lateralOffset;  // where the wheel runs
  const auto line = [&](double own) { return start + slope * own; };
  for (double x = from; x <= to; x += step)
    view.surface.push_back({x + view.shift, surface.height(x, y) + line(x + view.shift)});
  const double radius = std::max(description.wheelset.radius, 0.1);
  for (const auto& point : cases::rigidWheelPath(surface, radius, from, to, std::max(step, 5e-4), y))
    view.wheelPath.push_back({point.position + view.shift, point.height + line(point.position + view.shift)});
  view.sleeperWidth = description.sleeper.width;
  const double spacing = description.track.sleeperSpacing;
  if (spacing > 0.05) {
    const double nearest = -description.track.defectFromSleeper;
    for (double x = nearest - spacing * std::ceil((nearest - from) / spacing + 1); x <= to + spacing; x += spacing)
      if (x + view.sleeperWidth / 2 >= from && x - view.sleeperWidth / 2 <= to) view.sleepers.push_back(x + view.shift);
  }
  return view;
}

double shownScale(const cases::Defect& defect) { return sampled(defect) ? defect.heightScale : 1; }

cases::ProfilePoint pointOfCase(const cases::Defect& defect, cases::ProfilePoint seen, double before) {
  constexpr double highest = 0.05;  // [m] that a case takes
  const double scale = shownScale(defect);
  seen.height = scale > 0 ? std::clamp(seen.height / scale, -highest, highest) : before;
  return seen;
}

QString profileNotes(const cases::Defect& defect) {
  const ProfileView view = frameOf(defect);
  QStringList notes;
  if (const double scale = shownScale(defect); scale != 1)
    notes << QObject::tr("Heights include defect.height_scale = %1.").arg(scale);
  if (!view.removed.empty())
    notes << QObject::tr("Levelling removes the dotted line: %1 µm at the first point, %2 µm at the last.")
                 .arg(view.removed.front().height * 1e6, 0, 'f', 1)
                 .arg(view.removed.back().height * 1e6, 0, 'f', 1);
  if (view.shift != 0)
    notes << QObject::tr("Results count from the deepest point, here at %1 mm.").arg(view.shift * 1e3, 0, 'f', 1);
  return notes.join(' ');
}

cases::CaseDescription asPoints(const cases::CaseDescription& description) {
  if (sampled(description.defect)) return description;
  cases::CaseDescription result = description;
  const auto surface = cases::surfaceOf(description);
  std::vector<cases::ProfilePoint> points;
  if (surface.last() > surface.first()) {
    constexpr int maximum = 199;
    const double length = surface.last() - surface.first();
    const int count = std::clamp(static_cast<int>(std::ceil(length / 1e-3)), 8, maximum);
    const double y = surface.deepestLateral();
    for (int i = 0; i <= count; ++i) {
      const double x = surface.first() + length * i / count;
      points.push_back({x, surface.height(x, y)});
    }
    points.front().height = points.back().height = 0;
    auto& middle = *std::min_element(points.begin() + 1, points.end() - 1, [](const auto& a, const auto& b) {
      return std::abs(a.position) < std::abs(b.position);
    });
    middle = {0, surface.height(0, y)};
    if (!isLowest(middle, points)) middle.height *= 1 + hairLower;
  } else {
    points = {{-0.03, 0}, {-0.01, 0}, {0, -1e-5}, {0.01, 0}, {0.03, 0}};
  }
  result.defect.shape = cases::DefectShape::profile;
  result.defect.points = points;
  result.defect.lines.clear();
  result.defect.file.clear();
  result.defect.heightScale = 1;
  result.defect.from = result.defect.to = 0;
  result.defect.filter = cases::ProfileFilter::none;
  result.defect.level = true;
  return result;
}

std::vector<cases::ProfilePoint> movedPoint(std::vector<cases::ProfilePoint> points, std::size_t index,
                                            cases::ProfilePoint to) {
  if (index >= points.size()) return points;
  if (index > 0) to.position = std::max(to.position, points[index - 1].position + minimumGap);
  if (index + 1 < points.size()) to.position = std::min(to.position, points[index + 1].position - minimumGap);
  points[index] = to;
  return points;
}

std::vector<cases::ProfilePoint> withPoint(std::vector<cases::ProfilePoint> points, cases::ProfilePoint added) {
  const auto at = std::lower_bound(points.begin(), points.end(), added,
                                   [](const auto& a, const auto& b) { return a.position < b.position; });
  const bool tooNear = (at != points.end() && at->position - added.position < minimumGap) ||
                       (at != points.begin() && added.position - std::prev(at)->position < minimumGap);
  if (!tooNear) points.insert(at, added);
  return points;
}

std::vector<cases::ProfilePoint> withoutPoint(std::vector<cases::ProfilePoint> points, std::size_t index) {
  if (index < points.size() && points.size() > 2) points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
  return points;
}

double heightOn(const std::vector<cases::ProfilePoint>& points, double position) {
  const auto behind = std::lower_bound(points.begin(), points.end(), position,
                                       [](const auto& point, double at) { return point.position < at; });
  if (behind == points.begin()) return points.empty() ? 0 : points.front().height;
  if (behind == points.end()) return points.back().height;
  const auto& before = *std::prev(behind);
  const double share = (position - before.position) / (behind->position - before.position);
  return before.height + share * (behind->height - before.height);
}

std::optional<std::size_t> pointAfter(const std::vector<cases::ProfilePoint>& before,
                                      const std::vector<cases::ProfilePoint>& after, std::size_t index) {
  const auto same = [](const auto& a, const auto& b) { return a.position == b.position && a.height == b.height; };
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t head = 0, tail = 0;  // points at both ends that are the same
  while (head < shorter && same(before[head], after[head])) ++head;
  while (tail < shorter - head && same(before[before.size() - 1 - tail], after[after.size() - 1 - tail])) ++tail;
  const std::size_t gone = before.size() - head - tail, come = after.size() - head - tail;
  if (index >= before.size() || gone > 1 || come > 1) return std::nullopt;
  if (index < head) return index;
  if (index >= head + gone) return index + come - gone;
  return come == 1 ? std::optional(index) : std::nullopt;
}

double snapped(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

}  // namespace squat::studio
