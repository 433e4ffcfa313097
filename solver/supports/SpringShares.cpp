#include "supports/SpringShares.h"

#include <algorithm>
#include <unordered_map>

namespace squat::supports {

namespace {

// Springs in one list, with the first spring that each of them hangs together with.
struct Chain {
  std::vector<std::size_t> parent;

  std::size_t head(std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::size_t i, std::size_t k) {
    const std::size_t a = head(i), b = head(k);
    parent[std::max(a, b)] = std::min(a, b);
  }
};

}  // namespace

SharedSprings shareSprings(const std::vector<const SpringSet*>& sets, int shares,
                           const std::function<int(std::size_t unknown)>& ownerOf) {
  Chain chain;
  std::unordered_map<std::size_t, std::size_t> firstAt;  // force slot: first spring that pushes there
  for (const auto* set : sets)
    for (std::size_t i = 0; i < set->size(); ++i) {
      const std::size_t spring = chain.parent.size();
      chain.parent.push_back(spring);
      for (std::size_t t = set->start[i]; t < set->start[i + 1]; ++t)
        chain.join(spring, firstAt.try_emplace(set->forceSlot[t], spring).first->second);
    }
  SharedSprings result{std::vector<SpringShare>(static_cast<std::size_t>(shares)), 0};
  std::vector<int> owner(chain.parent.size(), 0);
  std::vector<std::size_t> group(chain.parent.size(), 0);
  std::size_t spring = 0;
  for (const auto* set : sets)
    for (std::size_t i = 0; i < set->size(); ++i, ++spring) {
      const std::size_t head = chain.head(spring);
      if (head == spring) {
        if (set->start[i] < set->start[i + 1]) owner[spring] = ownerOf(set->unknown[set->start[i]]);
        group[spring] = result.groups++;
        result.shares[static_cast<std::size_t>(owner[spring])].groups.push_back(group[spring]);
      }
      auto& share = result.shares[static_cast<std::size_t>(owner[head])];
      std::vector<std::pair<std::size_t, double>> terms;
      for (std::size_t t = set->start[i]; t < set->start[i + 1]; ++t) {
        terms.emplace_back(set->unknown[t], set->weight[t]);
        share.springs.forceSlot.push_back(set->forceSlot[t]);
      }
      share.springs.add(terms, set->stiffness[i], set->damping[i]);
      share.group.push_back(group[head]);
    }
  return result;
}

void addSpringForces(const SpringShare& share, const double* displacement, const double* velocity, double* forces,
                     double* dissipation) {
  for (const auto group : share.groups) dissipation[group] = 0;
  const auto& set = share.springs;
  for (std::size_t i = 0; i < set.size(); ++i) {
    double q = 0, rate = 0;
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) {
      q += set.weight[t] * displacement[set.unknown[t]];
      rate += set.weight[t] * velocity[set.unknown[t]];
    }
    const double force = set.stiffness[i] * q + set.damping[i] * rate;
    dissipation[share.group[i]] += set.damping[i] * rate * rate;
    for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) forces[set.forceSlot[t]] -= set.weight[t] * force;
  }
}

}  // namespace squat::supports
