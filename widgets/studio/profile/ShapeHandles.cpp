#include "studio/profile/ShapeHandles.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "case/Applicability.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "scenario/DefectSurface.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {
namespace {

constexpr const char *depthKey = "defect.depth", *lengthKey = "defect.length";

bool isAnalytic(const cases::CaseDescription& description) {
  return description.defect.shape != cases::DefectShape::none &&
         description.defect.shape != cases::DefectShape::profile;
}

std::optional<cases::CaseDescription> withValue(cases::CaseDescription description, const std::string& key,
                                                double value) {
  const auto* parameter = cases::findParameter(key);
  value = std::clamp(value, parameter->minimum, parameter->maximum);
  if (cases::trySetValue(description, *parameter, QString::number(value, 'g', 4).toStdString())) return std::nullopt;
  return description;
}

// [m per unit of the key] How far a place moves with a key, from a change of the key by a tenth.
double rateOf(const cases::CaseDescription& description, const std::string& key,
              const std::function<double(const scenario::DefectSurface&)>& place) {
  const double value = cases::numberInUnit(description, *cases::findParameter(key));
  const double other = value > 0 ? 1.1 * value : 0.01;
  const auto changed = withValue(description, key, other);
  if (!changed) return 0;
  const double by = cases::numberInUnit(*changed, *cases::findParameter(key)) - value;
  return by == 0 ? 0 : (place(cases::surfaceOf(*changed)) - place(cases::surfaceOf(description))) / by;
}

bool hasKey(const cases::CaseDescription& description, const char* key) {
  const auto* parameter = cases::findParameter(key);
  return parameter && cases::applies(description, *parameter);
}

// Of a flat floor its middle.
double deepestPosition(const scenario::DefectSurface& surface, double y) {
  constexpr int steps = 400;
  constexpr double same = 1e-9;  // [m]
  double deepest = surface.first();
  for (int i = 0; i <= steps; ++i) {
    const double x = surface.first() + (surface.last() - surface.first()) * i / steps;
    const double lower = surface.height(deepest, y) - surface.height(x, y);
    if (lower > same || (lower > -same && std::abs(x) < std::abs(deepest))) deepest = x;
  }
  return deepest;
}

}  // namespace

std::optional<ShapeHandle> handleOnCurve(const cases::CaseDescription& description, double position) {
  if (!isAnalytic(description) || !hasKey(description, depthKey)) return std::nullopt;
  const auto surface = cases::surfaceOf(description);
  const double y = description.motion.lateralOffset;
  const double rate = rateOf(description, depthKey, [&](const auto& each) { return each.height(position, y); });
  constexpr double slight = 1e-4;  // [m/mm]: a tenth of the depth's own rate
  if (std::abs(rate) < slight) return std::nullopt;
  return ShapeHandle{depthKey, {position, surface.height(position, y)}, true, rate};
}

std::vector<ShapeHandle> shapeHandles(const cases::CaseDescription& description) {
  std::vector<ShapeHandle> handles;
  if (!isAnalytic(description)) return handles;
  const auto surface = cases::surfaceOf(description);
  const double y = description.motion.lateralOffset;
  if (auto deepest = handleOnCurve(description, deepestPosition(surface, y))) handles.push_back(*deepest);
  if (!hasKey(description, lengthKey)) return handles;
  const auto first = [](const auto& of) { return of.first(); };
  const auto last = [](const auto& of) { return of.last(); };
  for (const auto& end : {std::function<double(const scenario::DefectSurface&)>(first),
                          std::function<double(const scenario::DefectSurface&)>(last)})
    if (const double rate = rateOf(description, lengthKey, end); rate != 0)
      handles.push_back({lengthKey, {end(surface), surface.height(end(surface), y)}, false, rate});
  return handles;
}

cases::CaseDescription pulled(const cases::CaseDescription& description, const ShapeHandle& handle,
                              const cases::ProfilePoint& to) {
  const double value = cases::numberInUnit(description, *cases::findParameter(handle.key));
  const double way = handle.isVertical ? to.height - handle.at.height : to.position - handle.at.position;
  return withValue(description, handle.key, value + way / handle.rate).value_or(description);
}

std::vector<cases::ProfilePoint> pulledPoints(std::vector<cases::ProfilePoint> points, std::size_t index,
                                              const cases::ProfilePoint& to, double radius) {
  if (index >= points.size()) return points;
  const cases::ProfilePoint from = points[index];
  points = movedPoint(std::move(points), index, to);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double distance = std::abs(points[i].position - from.position);
    if (i == index || distance >= radius) continue;
    const double share = std::cos(std::numbers::pi / 2 * distance / radius);
    points[i].height += (to.height - from.height) * share * share;
  }
  return points;
}

}  // namespace squat::studio
