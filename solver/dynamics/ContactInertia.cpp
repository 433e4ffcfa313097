#include "dynamics/ContactInertia.h"

namespace squat::dynamics {

ContactInertia::ContactInertia(const elasticity::SweptBlock& rail, const elasticity::SweptBlock& rim, double penalty,
                               double step, double beta)
    : massPerArea_(0.25 * (step * step + 2 * beta * step) * 2 * penalty) {
  sides_[0].nodes = rail.nodes, sides_[1].nodes = rim.nodes;
  sides_[0].heavyAt.assign(rail.size() / 3, 0), sides_[1].heavyAt.assign(rim.size() / 3, 0);
}

void ContactInertia::apply(double* railInverse, double* rimInverse) {
  added_ = 0;
  applySide(sides_[0], closed_.rail, railInverse);
  applySide(sides_[1], closed_.rim, rimInverse);
}

void ContactInertia::applySide(Side& side, const std::vector<contact::AreaShare>& shares, double* inverse) {
  constexpr int chunk = elasticity::SweptBlock::chunk;
  for (const auto& heavy : side.heavy) inverse[heavy.place] = heavy.bare, side.heavyAt[heavy.place] = 0;
  side.heavy.clear();
  for (const auto& share : shares) {
    const std::size_t place = (static_cast<std::size_t>(share.station / chunk) * side.nodes + share.node) * chunk +
                              static_cast<std::size_t>(share.station % chunk);
    int& at = side.heavyAt[place];
    if (at == 0) side.heavy.push_back({place, inverse[place], 0}), at = static_cast<int>(side.heavy.size());
    side.heavy[at - 1].area += share.area;
  }
  for (const auto& heavy : side.heavy) {
    const double mass = massPerArea_ * heavy.area;
    inverse[heavy.place] = heavy.bare / (1 + heavy.bare * mass);
    added_ += mass;
  }
}

}  // namespace squat::dynamics
