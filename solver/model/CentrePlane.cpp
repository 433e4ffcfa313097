#include "model/CentrePlane.h"

#include <numeric>

#include "model/BuildForceElements.h"

namespace squat::model {

namespace {

constexpr int alongSleeper = 0, acrossPlane = 2;  // component along y of a sleeper, of the wheelset

bool isAtCentre(const scenario::Wheelset& wheelset, const geometry::Point2& node) {
  return node[1] < -wheelset.trackCentre + 1e-9;
}

}  // namespace

std::vector<double> centreMask(const scenario::Wheelset& wheelset, const elasticity::SweptBlock& body, Centre centre) {
  std::vector<double> mask(body.lines(), 1.0);
  if (centre == Centre::shared) return mask;
  for (int n = 0; n < body.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      if (isAtCentre(wheelset, body.section.nodes[n]) && (c == acrossPlane) == (centre == Centre::symmetric))
        mask[3 * n + c] = 0;
  return mask;
}

// Sleepers that are fixed do not move at all.
void fixSleeper(Model& model, const elasticity::SweptBlock& sleeper, Centre centre) {
  const bool whole = model.scenario.sleeper.fixed;
  const auto holds = [&](int component) {
    return whole || (centre == Centre::symmetric && component == alongSleeper) ||
           (centre == Centre::antisymmetric && component != alongSleeper);
  };
  for (int n = 0; n < sleeper.nodes; ++n)
    for (int c = 0; c < 3; ++c)
      for (int s = 0; holds(c) && s < (whole ? sleeper.stationCount : 1); ++s)
        model.fixed.push_back(sleeper.index(n, c, s));
}

void fixUnknowns(Model& model, Centre centre) {
  model.fixed.clear(), model.freeMask.clear();
  fixRailEnds(model);
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
    model.freeMask.push_back(
        centreMask(model.scenario.wheelset, model.blocks[b], b == model.body ? centre : Centre::shared));
  for (int i = 0; i < model.sleepers; ++i) fixSleeper(model, model.blocks[model.firstSleeper + i], centre);
}

bool haveLikeUnknowns(const Model& a, const Model& b) {
  if (a.stateSize != b.stateSize || a.blocks.size() != b.blocks.size() || a.body != b.body) return false;
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    if (a.blocks[i].offset != b.blocks[i].offset || a.blocks[i].nodes != b.blocks[i].nodes ||
        a.blocks[i].stationCount != b.blocks[i].stationCount)
      return false;
  return true;
}

CentreNodes axleCentre(const Model& model) {
  CentreNodes centre{model.body, {}, {1, 1, -1}};
  const auto& body = model.blocks[model.body];
  for (int n = 0; n < body.nodes; ++n)
    if (isAtCentre(model.scenario.wheelset, body.section.nodes[n])) centre.nodes.push_back(n);
  return centre;
}

CentreNodes sleeperCentre(const Model& model, int block) {
  CentreNodes centre{block, std::vector<int>(static_cast<std::size_t>(model.blocks[block].nodes)), {-1, 1, 1}};
  std::iota(centre.nodes.begin(), centre.nodes.end(), 0);
  return centre;
}

void joinAtCentre(const elasticity::SweptBlock& block, const CentreNodes& centre, int first, int end, double* left,
                  double* right) {
  for (const int node : centre.nodes)
    for (int c = 0; c < 3; ++c)
      for (int s = first; s < end; ++s) {
        const std::size_t at = block.index(node, c, s);
        const bool alike = centre.sign[c] > 0;
        const double mean = 0.5 * (alike ? left[at] + right[at] : left[at] - right[at]);
        left[at] = mean;
        right[at] = alike ? mean : 0 - mean;
      }
}

void copyToGhost(const elasticity::SweptBlock& block, const CentreNodes& centre, double* state) {
  for (const int node : centre.nodes)
    for (int c = 0; c < 3; ++c) state[block.index(node, c, block.intervals)] = state[block.index(node, c, 0)];
}

}  // namespace squat::model
