#include "elasticity/SweptTie.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace squat::elasticity {

namespace {

struct EdgePlace {
  int first = -1, second = -1;            // ends of the master edge
  int firstInner = -1, secondInner = -1;  // their neighbours across the quad
  double fraction = 0;                    // of the way from first to second
};

// The master edge on which a section point lies. Around the axis only edges along y count: at a corner the edge along
// the radius would name the lateral neighbour for the one further in.
EdgePlace findEdge(const geometry::SectionMesh& mesh, const geometry::Point2& point, bool around) {
  for (const auto& quad : mesh.quads) {
    for (int i = 0; i < 4; ++i) {
      const auto &p = mesh.nodes[quad[i]], &q = mesh.nodes[quad[(i + 1) % 4]];
      const double db = q[0] - p[0], dc = q[1] - p[1], length2 = db * db + dc * dc;
      if (around && std::abs(db) > 1e-9) continue;
      const double t = ((point[0] - p[0]) * db + (point[1] - p[1]) * dc) / length2;
      const double away = std::abs((point[0] - p[0]) * dc - (point[1] - p[1]) * db) / std::sqrt(length2);
      if (t > -1e-9 && t < 1 + 1e-9 && away < 1e-7)
        return {quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4], quad[(i + 2) % 4], t};
    }
  }
  throw std::invalid_argument("a tied node lies on no edge of the coarser section");
}

SweptTie::Station alongLine(const std::vector<double>& master, double at) {
  int k = 0;
  while (k + 2 < static_cast<int>(master.size()) && master[k + 1] <= at) ++k;
  const double t = (at - master[k]) / (master[k + 1] - master[k]);
  return {k, k + 1, 1 - t, 0, t, 0, 1 - t, t, 0};
}

// On an arc the point r e(alpha) is sought as r' ((1 - t) e(alpha1) + t e(alpha2)): t and r' / r follow from the two
// components; r' exceeds r, that is the extrapolation beyond the chord.
SweptTie::Station aroundArc(const SweptBlock& master, double at, double radius, double layer) {
  const double full = 2 * std::acos(-1.0);
  const double start = master.positions.front();
  at = start + std::fmod(std::fmod(at - start, full) + full, full);
  int k = 0;
  while (k + 1 < master.intervals && master.positions[k + 1] <= at) ++k;
  const double angle = master.positions[k + 1] - master.positions[k], fromLeft = at - master.positions[k];
  const double left = std::sin(angle - fromLeft), right = std::sin(fromLeft);  // weights up to a common factor
  const double t = right / (left + right);
  const double stretched = radius * (left + right) / std::sin(angle);
  SweptTie::Station station;
  station.left = k, station.right = (k + 1) % master.intervals;
  station.leftWeight = 1 - t, station.rightWeight = t;
  // Turning from the master's basis at angle difference d = alpha(slave) - alpha(master): e_a(s) = c e_a(m) - ... so
  // u_a(s) = cos d u_a + sin d (-u_r) ... written for u_a = cos u_a(m) + sin u_b(m) with sin of the turn below.
  const double toLeft = fromLeft, toRight = fromLeft - angle;
  station.leftCosine = (1 - t) * std::cos(toLeft), station.leftSine = -(1 - t) * std::sin(toLeft);
  station.rightCosine = t * std::cos(toRight), station.rightSine = -t * std::sin(toRight);
  station.extrapolation = (stretched - radius) / layer;
  return station;
}

}  // namespace

SweptTie makeTie(const std::vector<SweptBlock>& blocks, int slaveBlock, int masterBlock, std::vector<int> slaveNodes) {
  const auto &slave = blocks[slaveBlock], &master = blocks[masterBlock];
  if (slave.kind != master.kind) throw std::invalid_argument("tied blocks are swept in different ways");
  SweptTie tie;
  tie.slaveBlock = slaveBlock, tie.masterBlock = masterBlock, tie.slaveNodes = std::move(slaveNodes);
  std::map<int, int> columnOf;
  const bool around = slave.kind == SweepKind::aroundAxis;
  double radius = 0, layer = 1;
  const auto column = [&](int outer, int inner) {
    const auto [entry, fresh] = columnOf.try_emplace(outer, static_cast<int>(tie.columns.size()));
    if (fresh) tie.columns.push_back({outer, around ? inner : -1});
    return entry->second;
  };
  tie.entryStart.push_back(0);
  for (const int node : tie.slaveNodes) {
    const auto& point = slave.section.nodes[node];
    const auto edge = findEdge(master.section, point, around);
    const double weights[2] = {1 - edge.fraction, edge.fraction};
    const int outer[2] = {edge.first, edge.second}, inner[2] = {edge.firstInner, edge.secondInner};
    for (int i = 0; i < 2; ++i)
      if (std::abs(weights[i]) > 1e-12) {
        tie.entryColumn.push_back(column(outer[i], inner[i]));
        tie.entryWeight.push_back(weights[i]);
      }
    tie.entryStart.push_back(static_cast<int>(tie.entryColumn.size()));
    if (around) radius = point[0], layer = point[0] - master.section.nodes[edge.firstInner][0];
  }
  for (int s = 0; s < slave.stationCount; ++s)
    tie.stations.push_back(around ? aroundArc(master, slave.positions[s], radius, layer)
                                  : alongLine(master.positions, slave.positions[s]));
  return tie;
}

std::size_t tieWorkspace(const SweptTie& tie) { return tie.columns.size() * 3 * tieStations; }

std::vector<StationSpan> slaveSpans(const SweptTie& tie, int firstMaster, int lastMaster) {
  std::vector<StationSpan> spans;
  for (int s = 0; s < static_cast<int>(tie.stations.size()); ++s) {
    const auto& at = tie.stations[s];
    if (!((at.left >= firstMaster && at.left < lastMaster) || (at.right >= firstMaster && at.right < lastMaster)))
      continue;
    if (!spans.empty() && spans.back().last == s)
      ++spans.back().last;
    else
      spans.push_back({s, s + 1});
  }
  return spans;
}

void interpolateSlaves(const SweptTie& tie, const std::vector<SweptBlock>& blocks, double* state, double* workspace) {
  interpolateSlaves(tie, blocks, state, workspace, {0, blocks[tie.slaveBlock].stationCount});
}

void interpolateSlaves(const SweptTie& tie, const std::vector<SweptBlock>& blocks, double* state, double* workspace,
                       StationSpan span) {
  constexpr int most = tieStations;
  const auto &slave = blocks[tie.slaveBlock], &master = blocks[tie.masterBlock];
  for (int from = span.first; from < span.last; from += most) {
    const int count = std::min(most, span.last - from);
    for (std::size_t j = 0; j < tie.columns.size(); ++j) {
      double* out = workspace + 3 * j * most;
      std::fill(out, out + 3 * most, 0.0);
      for (int layer = 0; layer < 2; ++layer) {
        const int node = layer ? tie.columns[j].inner : tie.columns[j].outer;
        if (node < 0) continue;
        const auto a = master.line(state, node, 0), b = master.line(state, node, 1), c = master.line(state, node, 2);
        for (int k = 0; k < count; ++k) {
          const auto& at = tie.stations[from + k];
          const double share = layer ? -at.extrapolation : 1 + at.extrapolation;
          const double leftA = a[at.left], leftB = b[at.left], rightA = a[at.right], rightB = b[at.right];
          out[k] +=
              share * (at.leftCosine * leftA + at.leftSine * leftB + at.rightCosine * rightA + at.rightSine * rightB);
          out[most + k] +=
              share * (at.leftCosine * leftB - at.leftSine * leftA + at.rightCosine * rightB - at.rightSine * rightA);
          out[2 * most + k] += share * (at.leftWeight * c[at.left] + at.rightWeight * c[at.right]);
        }
      }
    }
    for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        double sum[most] = {};
        for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
          const double* value = workspace + (3 * static_cast<std::size_t>(tie.entryColumn[e]) + c) * most;
          for (int k = 0; k < most; ++k) sum[k] += tie.entryWeight[e] * value[k];
        }
        const auto line = slave.line(state, tie.slaveNodes[i], c);
        for (int k = 0; k < count; ++k) line[from + k] = sum[k];
      }
  }
  if (slave.closed && span.first == 0)
    for (const int n : tie.slaveNodes)
      for (int c = 0; c < 3; ++c) state[slave.index(n, c, slave.intervals)] = state[slave.index(n, c, 0)];
}

}  // namespace squat::elasticity
