// solver/forces/ElasticLaw.h - elastic force against elongation, straight between points.
//
// Elongation q is positive where the two ends move apart, the force positive where it pulls them together. Force and
// stored energy are zero at q = 0, the state in which the model is built: what clamps an element there is left out.
#pragma once

#include <array>
#include <vector>

namespace squat::forces {

class ElasticLaw {
 public:
  // Pairs (compression [m], force [N]), both ascending, straight on beyond the ends; at q = 0 the element carries
  // `preload` [N].
  static ElasticLaw fromCompression(const std::vector<std::array<double, 2>>& points, double preload);
  // Nothing until the element is compressed by `gap` [m], then 1 N/m; an open gap has no damping either.
  static ElasticLaw closingGap(double gap);

  double force(double elongation) const;
  // At a point, that of the side of more compression.
  double tangent(double elongation) const;
  double storedEnergy(double elongation) const;
  double stiffestTangent() const;
  bool transmits(double elongation) const { return !(elongation > slackFrom_); }

 private:
  struct Stretch {
    double from = 0, force = 0, tangent = 0, energy = 0;  // force and energy at `from`
  };
  ElasticLaw() = default;
  const Stretch& at(double elongation) const;
  void integrate();  // energies of all stretches, from forces and tangents

  std::vector<Stretch> stretches_;  // ascending; the first holds below its own start as well
  double slackFrom_ = 0;            // elongation beyond which nothing is transmitted
};

}  // namespace squat::forces
