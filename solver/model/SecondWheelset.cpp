#include "model/SecondWheelset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/Hertz.h"
#include "core/ElementaryFunctions.h"
#include "geometry/Stations.h"
#include "model/Model.h"

namespace squat::model {

namespace {

constexpr double highestMode = 5000;  // [Hz] far above what the signals are judged up to
constexpr int lastHarmonicOfWheel = 5;
constexpr double touchedHalfWidth = 0.008;  // [m] across the rail, or a face of it where that is wider

// Wheelset and axle box; what the solids do not weigh sits on the axle. About the track centre, in roll: over one half.
double rollInertia(const scenario::Wheelset& w, const WheelsetShapes& shapes) {
  double sum = 0;
  for (std::size_t n = 0; n < shapes.mass.size(); ++n) {
    const auto& p = shapes.section.nodes[n];
    const double y = p[1] + w.trackCentre;
    sum += shapes.mass[n] * (y * y + 0.5 * p[0] * p[0]);  // z^2 is r^2 / 2 in the mean around the axis
  }
  if (w.bearingStiffness > 0) sum += w.axleBoxMass * std::pow(w.bearingCentre + w.trackCentre, 2);
  return sum;
}

SecondMotions motionsOf(const scenario::Scenario& d, Centre centre) {
  const auto& w = d.wheelset;
  const auto shapes = wheelsetShapes(d, highestMode, lastHarmonicOfWheel, centre);
  SecondMotions motions;
  motions.rigidMass = w.totalMass;
  if (centre == Centre::antisymmetric) {
    motions.rigidMass = rollInertia(w, shapes) / (w.trackCentre * w.trackCentre);
    motions.boxLever = (w.trackCentre + w.bearingCentre) / w.trackCentre;
  }
  for (const auto& found : shapes.modes) {
    constexpr double least = 1e-6;  // [1/sqrt(kg)] torsion and what else has no vertical motion
    if (std::abs(found.mode.contactAmplitude) > least || std::abs(found.mode.boxAmplitude) > least)
      motions.modes.push_back(found.mode);
  }
  return motions;
}

// Second antiderivative of a raised cosine from -1 to 1 with unit integral, (1 + cos(pi t)) / 2.
double spreadPotential(double t) {
  if (t <= -1) return 0;
  if (t >= 1) return t;
  constexpr double pi = std::numbers::pi;
  return 0.25 * (t + 1) * (t + 1) - 0.5 * (1 + elementary::cos(pi * t)) / (pi * pi);
}

}  // namespace

double SecondWheelset::approach(double force) const {
  const double root = elementary::cbrt(force / hertz);
  return root * root;
}

SecondWheelset secondWheelset(const Model& model) {
  const auto& d = model.scenario;
  SecondWheelset second;
  second.offset = d.bogie.offset();
  second.spread = 2 * secondPathSize;
  // Of two materials as of one with Young's modulus in between (contact/Hertz.h).
  const auto compliance = [](const auto& m) { return (1 - m.poisson * m.poisson) / m.young; };
  const double poisson = d.rail.material.poisson;
  const double young = 2 * (1 - poisson * poisson) / (compliance(d.rail.material) + compliance(d.wheelset.material));
  const double load = d.motion.gravity * (d.wheelset.totalMass + d.suspension.sprungMass);
  const auto contact = contact::hertzContact(model.surfaces.radius, model.surfaces.crownRadius, young, poisson, load);
  second.hertz = load / (contact.approach * std::sqrt(contact.approach));
  second.halfLength = contact.halfAxisX;
  return second;
}

std::vector<SecondMotions> secondMotions(const scenario::Scenario& d) {
  std::vector<SecondMotions> kinds{motionsOf(d, Centre::symmetric)};
  if (d.extent == scenario::ModelExtent::whole) kinds.push_back(motionsOf(d, Centre::antisymmetric));
  return kinds;
}

std::vector<double> secondLoads(std::span<const scenario::Scenario* const> sides) {
  const auto& left = *sides.front();
  const auto& w = left.wheelset;
  const double g = left.motion.gravity, lever = (w.trackCentre + w.bearingCentre) / w.trackCentre;
  if (sides.size() == 1) return {g * (w.totalMass + left.suspension.sprungMass)};
  const double onLeft = left.suspension.sprungMass, onRight = sides[1]->suspension.sprungMass;
  const double mean = w.totalMass + 0.5 * (onLeft + onRight), tips = 0.5 * lever * (onLeft - onRight);
  return {g * (mean + tips), g * (mean - tips)};
}

SecondRailSeat::SecondRailSeat(const Model& model) : model_(model), spread_(model.second->spread) {
  const auto& s = model.surfaces;
  const int face = geometry::intervalOf(s.railY, s.touchY).first;
  const double halfWidth = std::max(touchedHalfWidth, s.railY[face + 1] - s.railY[face]);
  double sum = 0;
  for (std::size_t j = 0; j < s.railLine.size(); ++j) {
    const double away = std::abs(s.railY[j] - s.touchY);
    const double width = 0.5 * (s.railY[std::min(j + 1, s.railY.size() - 1)] - s.railY[j == 0 ? 0 : j - 1]);
    const double weight = width * std::max(0.0, 1 - away / halfWidth);
    if (weight > 0) nodes_.push_back({s.railLine[j], weight}), sum += weight;
  }
  for (auto& [node, weight] : nodes_) weight /= sum;
}

// Shares of the stations are those of linear shape functions under the spread: second differences of its potential.
void SecondRailSeat::moveTo(double x) {
  const auto& at = model_.blocks[model_.rail].positions;
  const auto potential = [&](int s) { return spread_ * spreadPotential((at[s] - x) / spread_); };
  first_ = geometry::intervalOf(at, x - spread_).first;
  const int last = geometry::intervalOf(at, x + spread_).first + 1;
  weight_.clear();
  for (int s = first_; s <= last; ++s) {
    const double left = s > 0 ? (potential(s) - potential(s - 1)) / (at[s] - at[s - 1]) : 0;
    const double right =
        s < static_cast<int>(at.size()) - 1 ? (potential(s + 1) - potential(s)) / (at[s + 1] - at[s]) : 1;
    weight_.push_back(right - left);
  }
}

// Along the vertical: b and c of the leaning section.
template <typename Work>
void SecondRailSeat::forEach(const Work& work) const {
  const auto& rail = model_.blocks[model_.rail];
  const double sine = elementary::sin(rail.lean), cosine = elementary::cos(rail.lean);
  for (const auto& [node, share] : nodes_)
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      const int station = first_ + static_cast<int>(i);
      work(node, 1, station, sine * share * weight_[i]);
      work(node, 2, station, cosine * share * weight_[i]);
    }
}

double SecondRailSeat::mean(const double* state) const {
  const auto& rail = model_.blocks[model_.rail];
  double sum = 0;
  forEach([&](int node, int component, int station, double weight) {
    sum += weight * state[rail.index(node, component, station)];
  });
  return sum;
}

void SecondRailSeat::addToForces(double upwards, double* forces) const {
  const auto& rail = model_.blocks[model_.rail];
  const auto& loaded = model_.loaded[model_.rail];
  forEach([&](int node, int component, int station, double weight) {
    const auto line = static_cast<std::size_t>(loaded.lineOfNode[node]) * 3 + component;
    forces[loaded.offset + line * rail.stride + station] += weight * upwards;
  });
}

void SecondRailSeat::addToState(double upwards, double* state) const {
  const auto& rail = model_.blocks[model_.rail];
  forEach([&](int node, int component, int station, double weight) {
    state[rail.index(node, component, station)] += weight * upwards;
  });
}

}  // namespace squat::model
