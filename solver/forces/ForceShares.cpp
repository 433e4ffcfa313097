#include "forces/ForceShares.h"

#include <algorithm>
#include <unordered_map>

namespace squat::forces {

namespace {

// Elements in one list, with the first element that each of them hangs together with.
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

Chain chainOf(const std::vector<ForceElements>& sets) {
  Chain chain;
  std::unordered_map<std::size_t, std::size_t> firstAt;  // force slot: first element that pushes there
  for (const auto& set : sets)
    for (std::size_t i = 0; i < set.size(); ++i) {
      const std::size_t element = chain.parent.size();
      chain.parent.push_back(element);
      for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t)
        chain.join(element, firstAt.try_emplace(set.forceSlot[t], element).first->second);
    }
  return chain;
}

void append(ForceShare& share, const ForceElements& set, std::size_t i, bool isNewSet) {
  if (isNewSet) share.runs.push_back({share.elements.size(), share.elements.size(), set.law});
  share.elements.add(set.terms(i), set.stiffness[i], set.damping[i]);
  for (std::size_t t = set.start[i]; t < set.start[i + 1]; ++t) share.elements.forceSlot.push_back(set.forceSlot[t]);
  ++share.runs.back().last;
}

struct Response {
  double force, damping;  // elastic force [N], active dashpot [N s/m]
};

template <typename Law>
void addRun(const ForceShare& share, const ForceShare::Run& run, const double* displacement, const double* velocity,
            double* forces, double* dissipation, const Law& law) {
  const auto& e = share.elements;
  for (std::size_t i = run.first; i < run.last; ++i) {
    double q = 0, rate = 0;
    for (std::size_t t = e.start[i]; t < e.start[i + 1]; ++t) {
      q += e.weight[t] * displacement[e.unknown[t]];
      rate += e.weight[t] * velocity[e.unknown[t]];
    }
    const Response response = law(i, q);
    const double force = response.force + response.damping * rate;
    dissipation[share.group[i]] += response.damping * rate * rate;
    for (std::size_t t = e.start[i]; t < e.start[i + 1]; ++t) forces[e.forceSlot[t]] -= e.weight[t] * force;
  }
}

}  // namespace

SharedForces shareForces(const std::vector<ForceElements>& sets, int shares,
                         const std::function<int(std::size_t unknown)>& ownerOf) {
  Chain chain = chainOf(sets);
  SharedForces result{std::vector<ForceShare>(static_cast<std::size_t>(shares)), 0};
  std::vector<int> owner(chain.parent.size(), 0);
  std::vector<std::size_t> group(chain.parent.size(), 0);
  std::size_t element = 0;
  for (const auto& set : sets) {
    std::vector<char> hasRun(result.shares.size(), 0);
    for (std::size_t i = 0; i < set.size(); ++i, ++element) {
      const std::size_t head = chain.head(element);
      if (head == element) {
        if (set.start[i] < set.start[i + 1]) owner[element] = ownerOf(set.unknown[set.start[i]]);
        group[element] = result.groups++;
        result.shares[static_cast<std::size_t>(owner[element])].groups.push_back(group[element]);
      }
      const auto to = static_cast<std::size_t>(owner[head]);
      append(result.shares[to], set, i, !std::exchange(hasRun[to], 1));
      result.shares[to].group.push_back(group[head]);
    }
  }
  return result;
}

void addForces(const ForceShare& share, const double* displacement, const double* velocity, double* forces,
               double* dissipation) {
  for (const auto group : share.groups) dissipation[group] = 0;
  const auto& e = share.elements;
  for (const auto& run : share.runs) {
    if (run.law)
      addRun(share, run, displacement, velocity, forces, dissipation, [&](std::size_t i, double q) {
        return Response{e.stiffness[i] * run.law->force(q), run.law->transmits(q) ? e.damping[i] : 0};
      });
    else
      addRun(share, run, displacement, velocity, forces, dissipation, [&](std::size_t i, double q) {
        return Response{e.stiffness[i] * q, e.damping[i]};
      });
  }
}

}  // namespace squat::forces
