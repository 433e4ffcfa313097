#include "forces/ElasticLaw.h"

#include <algorithm>
#include <limits>

namespace squat::forces {

ElasticLaw ElasticLaw::fromCompression(const std::vector<std::array<double, 2>>& points, double preload) {
  ElasticLaw law;
  law.slackFrom_ = std::numeric_limits<double>::infinity();
  // Compression under the preload, on the stretch that reaches it.
  std::size_t k = 0;
  while (k + 2 < points.size() && points[k + 1][1] < preload) ++k;
  const auto slope = [&](std::size_t i) {
    return (points[i + 1][1] - points[i][1]) / (points[i + 1][0] - points[i][0]);
  };
  const double start = points[k][0] + (preload - points[k][1]) / slope(k);
  for (std::size_t i = points.size() - 1; i-- > 0;)
    law.stretches_.push_back({start - points[i + 1][0], preload - points[i + 1][1], slope(i), 0});
  law.integrate();
  return law;
}

ElasticLaw ElasticLaw::closingGap(double gap) {
  ElasticLaw law;
  law.slackFrom_ = -gap;
  law.stretches_ = {{-gap - 1, -1, 1, 0}, {-gap, 0, 0, 0}};
  law.integrate();
  return law;
}

void ElasticLaw::integrate() {
  for (std::size_t i = 1; i < stretches_.size(); ++i) {
    const auto& before = stretches_[i - 1];
    stretches_[i].energy =
        before.energy + 0.5 * (before.force + stretches_[i].force) * (stretches_[i].from - before.from);
  }
  const double atRest = storedEnergy(0);
  for (auto& stretch : stretches_) stretch.energy -= atRest;
}

const ElasticLaw::Stretch& ElasticLaw::at(double elongation) const {
  std::size_t i = stretches_.size() - 1;
  while (i > 0 && elongation <= stretches_[i].from) --i;
  return stretches_[i];
}

double ElasticLaw::force(double elongation) const {
  const auto& s = at(elongation);
  return s.force + s.tangent * (elongation - s.from);
}

double ElasticLaw::tangent(double elongation) const { return at(elongation).tangent; }

double ElasticLaw::storedEnergy(double elongation) const {
  const auto& s = at(elongation);
  const double beyond = elongation - s.from;
  return s.energy + s.force * beyond + 0.5 * s.tangent * beyond * beyond;
}

double ElasticLaw::stiffestTangent() const {
  return std::max_element(stretches_.begin(), stretches_.end(),
                          [](const auto& a, const auto& b) { return a.tangent < b.tangent; })
      ->tangent;
}

}  // namespace squat::forces
