#include "model/Rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenario/WheelsetMass.h"

namespace squat::model {

namespace {

std::vector<int> nodesOn(const elasticity::SweptBlock& body, double radius) {
  return geometry::nodesWhere(
      body.section, [&](const geometry::Point2& p) { return std::abs(p[0] - radius) < 1e-9; }, 1);
}

Ring normalised(const Ring& ring) {
  const double sum = std::accumulate(ring.weight.begin(), ring.weight.end(), 0.0);
  Ring kept{ring.block, {}, {}};
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
    if (ring.weight[i] > 0) kept.nodes.push_back(ring.nodes[i]), kept.weight.push_back(ring.weight[i] / sum);
  return kept;
}

}  // namespace

Ring seatRing(const elasticity::SweptBlock& body, int block, double radius, double from, double to) {
  Ring ring{block, nodesOn(body, radius), {}};
  const auto& nodes = ring.nodes;
  ring.weight.assign(nodes.size(), nodes.size() == 1 ? 1.0 : 0.0);
  // Linear shape functions N integrated over the seat: its ends need not be nodes, resultant and middle are exact
  // where nodes lie on all of it.
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double a = body.section.nodes[nodes[i]][1], b = body.section.nodes[nodes[i + 1]][1];
    const double start = std::max(a, from), end = std::min(b, to);
    if (end <= start) continue;
    const double covered = (end - start) / (to - from), right = (0.5 * (start + end) - a) / (b - a);
    ring.weight[i] += covered * (1 - right), ring.weight[i + 1] += covered * right;
  }
  return normalised(ring);
}

Ring axleMassRing(const scenario::Wheelset& w, const elasticity::SweptBlock& body, int block) {
  const double from = -0.85 * w.trackCentre, to = -0.25 * w.trackCentre;
  std::vector<int> nodes = nodesOn(body, w.axleRadius);
  std::erase_if(nodes, [&](int n) { return body.section.nodes[n][1] < from || body.section.nodes[n][1] > to; });
  Ring ring{block, nodes, std::vector<double>(nodes.size(), nodes.size() == 1 ? 1.0 : 0.0)};
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double half = 0.5 * (body.section.nodes[nodes[i + 1]][1] - body.section.nodes[nodes[i]][1]);
    ring.weight[i] += half, ring.weight[i + 1] += half;
  }
  return normalised(ring);
}

Ring sectionRing(const elasticity::SweptBlock& body, int block, double radius, double y) {
  const auto all = nodesOn(body, radius);
  const auto at = [&](std::size_t i) { return body.section.nodes[all[i]][1]; };
  std::size_t i = 0;
  while (i + 2 < all.size() && at(i + 1) <= y + 1e-9) ++i;
  const double share = (y - at(i)) / (at(i + 1) - at(i));
  if (std::abs(share) < 1e-6) return {block, {all[i]}, {1.0}};
  return {block, {all[i], all[i + 1]}, {1 - share, share}};
}

std::vector<Ring> discRings(const scenario::Wheelset& w, const elasticity::SweptBlock& body, int block) {
  std::vector<Ring> rings;
  for (const double position : scenario::brakeDiscPositions(w))
    rings.push_back(sectionRing(body, block, w.axleRadius, -position));
  return rings;
}

}  // namespace squat::model
