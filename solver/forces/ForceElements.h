// solver/forces/ForceElements.h - springs and dashpots between points of solids, auxiliary degrees of freedom and the
// ground: rail pads, ballast, rail ends, axle bearing, primary suspension.
//
// An element acts on its elongation q = sum of weight * unknown; force on each unknown: -weight (k f(q) + c q'), f(q) =
// q or the elastic law of its set. The elastic part acts on the displacement u + beta v (the same
// stiffness-proportional damping as in the solids), the dashpot on v. Whoever walks the elements, statics, stable step,
// time loop, energy balance and harmonic solver, asks the same functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forces/ElasticLaw.h"

namespace squat::forces {

enum class Kind { railPad, ballast, railEnd, axleBearing, primarySuspension, other };

struct ForceElements {
  Kind kind = Kind::other;
  std::string name;
  std::vector<std::size_t> start{0};  // elements + 1
  std::vector<std::size_t> unknown;   // state index of each term
  std::vector<double> weight;
  std::vector<double> stiffness, damping;  // per element [N/m], [N s/m]; with a law, `stiffness` multiplies it
  std::optional<ElasticLaw> law;           // of all elements of the set; none: linear
  std::vector<std::size_t> forceSlot;      // of each term: where the time loop collects its force

  std::size_t size() const { return stiffness.size(); }
  void add(const std::vector<std::pair<std::size_t, double>>& terms, double k, double c);
  std::vector<std::pair<std::size_t, double>> terms(std::size_t element) const;

  double elongation(std::size_t element, const double* displacement) const {
    double q = 0;
    for (std::size_t t = start[element]; t < start[element + 1]; ++t) q += weight[t] * displacement[unknown[t]];
    return q;
  }
  double elasticForce(std::size_t element, double q) const { return stiffness[element] * (law ? law->force(q) : q); }
  double tangent(std::size_t element, double q) const { return stiffness[element] * (law ? law->tangent(q) : 1); }
  double stiffestTangent(std::size_t element) const { return stiffness[element] * (law ? law->stiffestTangent() : 1); }
  double activeDamping(std::size_t element, double q) const { return !law || law->transmits(q) ? damping[element] : 0; }
  double storedEnergy(std::size_t element, double q) const {
    return stiffness[element] * (law ? law->storedEnergy(q) : 0.5 * q * q);
  }
};

// A linear set: result += K u (state layout, no dashpots), and its diagonal.
void addStiffness(const ForceElements& linear, const double* u, double* result);
void addDiagonal(const ForceElements& linear, double* diagonal);

// Elastic energy [J] of a whole set.
double storedEnergy(const ForceElements& set, const double* displacement);

}  // namespace squat::forces
