#include "dynamics/ContactInertia.h"

#include <algorithm>

#include "elasticity/SelectiveMassScaling.h"
#include "model/ContactPenalty.h"

namespace squat::dynamics {

namespace {

constexpr int unit = elasticity::stationUnit;

std::size_t indexOf(const elasticity::SweptBlock& block, int node, int station) {
  constexpr int chunk = elasticity::SweptBlock::chunk;
  return (static_cast<std::size_t>(station / chunk) * static_cast<std::size_t>(block.nodes) +
          static_cast<std::size_t>(node)) *
             chunk +
         static_cast<std::size_t>(station % chunk);
}

}  // namespace

double stiffestPenalty(const scenario::Scenario& d) {
  return std::max(model::normalPenalty(d), model::tangentialPenalty(d));
}

double eigenvalueOfStiffContact(const scenario::Scenario& d) {
  const double density = std::min(d.rail.material.density, d.wheelset.material.density);
  return 2 * stiffestPenalty(d) / (maximumLayers * density * d.mesh.contactSize);
}

ContactInertia::ContactInertia(const model::Model& model, double penalty, double step, double beta)
    : massPerArea_(0.25 * (step * step + 2 * beta * step) * 2 * penalty) {
  for (const auto& [index, b] : {std::pair{0, model.rail}, std::pair{1, model.rim}}) {
    Side& side = sides_[index];
    const auto& block = model.blocks[b];
    side.block = &block, side.mass = &model.mass[b];
    side.units = block.intervals / unit;
    side.clusterOf.assign(static_cast<std::size_t>(block.nodes), -1), side.rankOf = side.clusterOf;
    const auto& clusters = block.inertia.clusters;
    for (std::size_t k = 0; k < clusters.size(); ++k)
      for (int member = clusters[k].first; member < clusters[k].end; ++member) {
        side.clusterOf[block.order.members[member]] = static_cast<int>(k);
        side.rankOf[block.order.members[member]] = member - clusters[k].first;
      }
    side.slotOf.assign(clusters.size() * static_cast<std::size_t>(side.units), -1);
    side.nextOf.assign(side.slotOf.size(), 0);
  }
}

double ContactInertia::addedInertia() const {
  double sum = 0;
  for (const auto& share : closed_.rim) {
    const double radius = sides_[1].block->section.nodes[share.node][0];
    sum += radius * radius * share.area;
  }
  return massPerArea_ * sum;
}

double ContactInertia::addedAngularVelocity(const double* velocity, double cosine, double sine) const {
  const auto& block = *sides_[1].block;
  double sum = 0;
  for (const auto& share : closed_.rim)
    sum += block.section.nodes[share.node][0] * share.area *
           (cosine * velocity[block.index(share.node, 0, share.station)] -
            sine * velocity[block.index(share.node, 1, share.station)]);
  return massPerArea_ * sum;
}

void ContactInertia::apply(int index, double* inverse) {
  Side& side = sides_[static_cast<std::size_t>(index)];
  const auto& shares = index == 0 ? closed_.rail : closed_.rim;
  const auto& block = *side.block;
  side.added = 0;
  const auto bare = [&](int node, int station) {
    return (*side.mass)[static_cast<std::size_t>(node) * block.stride + static_cast<std::size_t>(station)];
  };
  for (const auto at : side.single) {
    const int node = static_cast<int>(at / block.stride), station = static_cast<int>(at % block.stride);
    inverse[indexOf(block, node, station)] = 1 / bare(node, station);
  }
  side.single.clear(), side.next.clear();
  for (const auto& share : shares) {
    side.added += massPerArea_ * share.area;
    const int cluster = side.clusterOf[share.node];
    const auto group = stationGroup(block, share.station);
    if (cluster < 0 || group.count == 1) {
      double& now = inverse[indexOf(block, share.node, share.station)];
      now = 1 / (1 / now + massPerArea_ * share.area);
      side.single.push_back(static_cast<std::size_t>(share.node) * block.stride + share.station);
      continue;
    }
    const int key = cluster * side.units + group.first / unit;
    int& at = side.nextOf[key];
    if (at == 0) side.next.push_back({key, group.count, {}}), at = static_cast<int>(side.next.size());
    side.next[at - 1].areas[side.rankOf[share.node] * group.count + share.station - group.first] += share.area;
  }
  applyBlocks(side, inverse);
}

// Blocks that the patch has left get their bare masses back, those that it touches anew or otherwise are weighed.
void ContactInertia::applyBlocks(Side& side, double* inverse) {
  for (auto& touched : side.slots) {
    if (!touched.used || side.nextOf[touched.key] != 0) continue;
    touched.areas = {};
    weigh(side, touched, inverse);
    touched.used = false, side.slotOf[touched.key] = -1;
  }
  for (const auto& [key, stations, areas] : side.next) {
    side.nextOf[key] = 0;
    int& slot = side.slotOf[key];
    if (slot >= 0 && side.slots[slot].areas == areas) continue;
    if (slot < 0) {
      const auto free =
          std::find_if(side.slots.begin(), side.slots.end(), [](const auto& touched) { return !touched.used; });
      slot = static_cast<int>(free - side.slots.begin());
      if (free == side.slots.end()) side.slots.emplace_back(), side.filters.emplace_back();
    }
    auto& touched = side.slots[slot];
    touched.key = key, touched.stations = stations, touched.areas = areas, touched.used = true;
    weigh(side, touched, inverse);
    side.filters[slot] = {touched.values.data(), touched.singleValues.data()};
  }
}

void ContactInertia::weigh(Side& side, Touched& touched, double* inverse) const {
  const auto& block = *side.block;
  const auto& cluster = block.inertia.clusters[touched.key / side.units];
  const int first = touched.key % side.units * unit, stations = touched.stations;
  const std::vector<int> nodes(block.order.members.begin() + cluster.first, block.order.members.begin() + cluster.end);
  std::vector<double> mass;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int s = 0; s < stations; ++s) {
      const double bare = (*side.mass)[static_cast<std::size_t>(nodes[i]) * block.stride + first + s];
      mass.push_back(bare + massPerArea_ * touched.areas[i * stations + s]);
      inverse[indexOf(block, nodes[i], first + s)] = 1 / mass.back();
    }
  elasticity::blockFilter(block, nodes, stations, mass, touched.values);
  touched.singleValues.assign(touched.values.begin(), touched.values.end());
}

}  // namespace squat::dynamics
