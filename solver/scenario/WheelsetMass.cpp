#include "scenario/WheelsetMass.h"

#include <numbers>

namespace squat::scenario {

WheelsetSolid wheelsetSolid(const Wheelset& w) {
  constexpr double pi = std::numbers::pi;
  WheelsetSolid solid;
  const auto addRing = [&](double outer, double inner, double length) {
    const double squares = outer * outer + inner * inner, area = pi * (outer * outer - inner * inner);
    solid.volume += area * length, solid.squaredRadii += 0.5 * squares * area * length;
  };
  addRing(w.radius, w.rimInnerRadius, w.rimWidth);
  addRing(w.hubRadius, w.boreRadius, w.hubWidth);
  addRing(w.axleRadius, w.boreRadius, w.trackCentre - 0.5 * w.hubWidth);
  addRing(w.shoulderRadius, w.boreRadius, w.shoulderEnd - 0.5 * w.hubWidth);
  addRing(w.journalRadius, w.boreRadius, w.journalEnd - w.shoulderEnd);
  // Thickness of the web linear in the radius: its mean, by Pappus taken at the middle of the annulus plus the taper's
  // share. Its squared radius is that of an even web: a taper shifts it by little.
  const double atHub = w.webHubThickness > 0 ? w.webHubThickness : w.webThickness;
  const double middle = 0.5 * (w.rimInnerRadius + w.hubRadius), depth = w.rimInnerRadius - w.hubRadius;
  const double web = 2 * pi * depth * (middle * 0.5 * (w.webThickness + atHub) + depth * (w.webThickness - atHub) / 12);
  solid.volume += web;
  solid.squaredRadii += 0.5 * (w.rimInnerRadius * w.rimInnerRadius + w.hubRadius * w.hubRadius) * web;
  return solid;
}

double partsMass(const Wheelset& w) {
  return wheelsetSolid(w).volume * w.material.density + w.axleBoxMass + brakeDiscsMass(w);
}

double wheelsetMass(const Wheelset& w) { return w.totalMass > 0 ? w.totalMass : partsMass(w); }

std::vector<double> brakeDiscPositions(const Wheelset& w) {
  std::vector<double> positions;
  for (int i = 0; i < w.brakeDiscs; ++i)
    positions.push_back(w.brakeDiscPosition + i * (w.trackCentre - w.brakeDiscPosition) / (w.brakeDiscs - 0.5));
  return positions;
}

}  // namespace squat::scenario
