#include "model/Rings.h"

#include <cmath>

#include "scenario/WheelsetMass.h"

namespace squat::model {

namespace {

std::vector<int> nodesOn(const elasticity::SweptBlock& body, double radius, double from, double to) {
  return geometry::nodesWhere(
      body.section,
      [&](const geometry::Point2& p) {
        return std::abs(p[0] - radius) < 1e-9 && p[1] > from - 1e-9 && p[1] < to + 1e-9;
      },
      1);
}

}  // namespace

Ring seatRing(const elasticity::SweptBlock& body, int block, double radius, double from, double to) {
  Ring ring{block, nodesOn(body, radius, from, to), {}};
  const auto& nodes = ring.nodes;
  ring.weight.assign(nodes.size(), nodes.size() == 1 ? 1.0 : 0.0);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double half = 0.5 * (body.section.nodes[nodes[i + 1]][1] - body.section.nodes[nodes[i]][1]);
    ring.weight[i] += half, ring.weight[i + 1] += half;
  }
  double sum = 0;
  for (const double share : ring.weight) sum += share;
  for (double& share : ring.weight) share /= sum;
  return ring;
}

Ring sectionRing(const elasticity::SweptBlock& body, int block, double radius, double y) {
  const auto all = nodesOn(body, radius, -1e9, 1e9);
  const auto at = [&](std::size_t i) { return body.section.nodes[all[i]][1]; };
  std::size_t i = 0;
  while (i + 2 < all.size() && at(i + 1) <= y + 1e-9) ++i;
  const double share = (y - at(i)) / (at(i + 1) - at(i));
  if (std::abs(share) < 1e-6) return {block, {all[i]}, {1.0}};
  return {block, {all[i], all[i + 1]}, {1 - share, share}};
}

std::vector<Ring> discRings(const scenario::Wheelset& w, const elasticity::SweptBlock& body, int block) {
  std::vector<Ring> rings;
  for (const double place : scenario::brakeDiscPlaces(w))
    rings.push_back(sectionRing(body, block, w.axleRadius, -place));
  return rings;
}

}  // namespace squat::model
