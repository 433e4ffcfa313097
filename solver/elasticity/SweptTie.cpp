#include "elasticity/SweptTie.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "core/ElementaryFunctions.h"

namespace squat::elasticity {

namespace {

struct EdgeLocation {
  int first = -1, second = -1;            // ends of the master edge
  int firstInner = -1, secondInner = -1;  // their neighbours across the quad
  double fraction = 0;                    // of the way from first to second
};

// The master edge on which a section point lies. Around the axis only edges along y count: at a corner the edge along
// the radius would name the lateral neighbour for the one further in.
EdgeLocation findEdge(const geometry::SectionMesh& mesh, const geometry::Point2& point, bool around) {
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

struct Location {
  int left = 0, right = 0;
  double leftCosine = 0, leftSine = 0, rightCosine = 0, rightSine = 0, leftWeight = 0, rightWeight = 0;
  double extrapolation = 0;
};

Location alongLine(const std::vector<double>& master, double at) {
  int k = 0;
  while (k + 2 < static_cast<int>(master.size()) && master[k + 1] <= at) ++k;
  const double t = (at - master[k]) / (master[k + 1] - master[k]);
  return {k, k + 1, 1 - t, 0, t, 0, 1 - t, t, 0};
}

// On an arc the point r e(alpha) is sought as r' ((1 - t) e(alpha1) + t e(alpha2)): t and r' / r follow from the two
// components; r' exceeds r, that is the extrapolation beyond the chord.
Location aroundArc(const SweptBlock& master, double at, double radius, double layer) {
  const double full = 2 * std::numbers::pi;
  const double start = master.positions.front();
  at = start + std::fmod(std::fmod(at - start, full) + full, full);
  int k = 0;
  while (k + 1 < master.intervals && master.positions[k + 1] <= at) ++k;
  const double angle = master.positions[k + 1] - master.positions[k], fromLeft = at - master.positions[k];
  const double left = elementary::sin(angle - fromLeft),
               right = elementary::sin(fromLeft);  // weights up to a common factor
  const double t = right / (left + right);
  const double stretched = radius * (left + right) / elementary::sin(angle);
  // Turning from the master's basis at angle difference d = alpha(slave) - alpha(master): e_a(s) = c e_a(m) - ... so
  // u_a(s) = cos d u_a + sin d (-u_r) ... written for u_a = cos u_a(m) + sin u_b(m) with sin of the turn below.
  const double toLeft = fromLeft, toRight = fromLeft - angle;
  return {k,
          (k + 1) % master.intervals,
          (1 - t) * elementary::cos(toLeft),
          -(1 - t) * elementary::sin(toLeft),
          t * elementary::cos(toRight),
          -t * elementary::sin(toRight),
          1 - t,
          t,
          (stretched - radius) / layer};
}

void addStation(const Location& at, SweptTie& tie) {
  auto& s = tie.stations;
  const bool joins = !s.left.empty() && s.left.back() == at.left && s.right.back() == at.right;
  const int station = static_cast<int>(s.left.size());
  const int begun = tie.stretchEnd.size() > 1 ? tie.stretchEnd[tie.stretchEnd.size() - 2] : 0;
  if (joins && station - begun < tieStations)
    ++tie.stretchEnd.back();
  else
    tie.stretchEnd.push_back(station + 1);
  tie.stretchOf.push_back(static_cast<int>(tie.stretchEnd.size()) - 1);
  s.left.push_back(at.left), s.right.push_back(at.right);
  s.leftWeight.push_back(at.leftWeight), s.rightWeight.push_back(at.rightWeight);
  s.extrapolation.push_back(at.extrapolation);
  const double e = at.extrapolation;
  const Two left{at.leftCosine, at.leftSine}, right{at.rightCosine, at.rightSine},
      across{at.leftWeight, at.rightWeight};
  s.turned.push_back({left, right, e * left, e * right, across, e * across});
}

// Components a and b together: times the cosine of a turn, and as they are times its sine.
struct InPlane {
  Two straight, across;
  InPlane(double a, double b) : straight{a, b}, across{b, -a} {}
  Two turned(Two cosineAndSine) const { return cosineAndSine[0] * straight + cosineAndSine[1] * across; }
};

// One column on `count` stations from `from` on: its masters' displacement, turned and weighted, three lines of
// tieStations. The masters' values are the same on a whole stretch.
void interpolateColumn(const SweptTie& tie, const SweptTie::Column& column, const SweptBlock& master,
                       const double* state, int from, int count, double* out) {
  const auto& at = tie.stations;
  const int innerNode = column.inner >= 0 ? column.inner : column.outer;
  for (int first = from, last = from; first < from + count; first = last) {
    last = std::min(from + count, tie.stretchEnd[tie.stretchOf[first]]);
    double outer[3][2], excess[3][2];  // component, left and right; excess of the outer over the inner
    for (int c = 0; c < 3; ++c) {
      const auto line = master.line(state, column.outer, c), inner = master.line(state, innerNode, c);
      outer[c][0] = line[at.left[first]], outer[c][1] = line[at.right[first]];
      excess[c][0] = outer[c][0] - inner[at.left[first]], excess[c][1] = outer[c][1] - inner[at.right[first]];
    }
    const InPlane left(outer[0][0], outer[1][0]), right(outer[0][1], outer[1][1]),
        leftExcess(excess[0][0], excess[1][0]), rightExcess(excess[0][1], excess[1][1]);
    const Two lateral{outer[2][0], outer[2][1]}, lateralExcess{excess[2][0], excess[2][1]};
    for (int s = first; s < last; ++s) {
      const auto& by = at.turned[s];
      const Two plane = (left.turned(by.left) + right.turned(by.right)) +
                        (leftExcess.turned(by.leftBeyond) + rightExcess.turned(by.rightBeyond));
      const Two sides = by.across * lateral + by.acrossBeyond * lateralExcess;
      double* to = out + (s - from);
      to[0] = plane[0], to[tieStations] = plane[1], to[2 * tieStations] = sides[0] + sides[1];
    }
  }
}

// A tied node's line on stations [from, from + count) from the columns that it lies between.
void interpolateLine(const SweptTie& tie, std::size_t i, int c, const double* columns, int from, int count,
                     StateLine<double> line) {
  const int begin = tie.entryStart[i], end = tie.entryStart[i + 1];
  const auto valuesOf = [&](int e) {
    return columns + (3 * static_cast<std::size_t>(tie.entryColumn[e]) + c) * tieStations;
  };
  for (int at = from, stop = from; at < from + count; at = stop) {  // within a chunk a line is one piece
    stop = std::min(from + count, (at / SweptBlock::chunk + 1) * SweptBlock::chunk);
    double* const to = &line[at];
    const int here = at - from, stations = stop - at;
    const double *one = valuesOf(begin) + here, weight = tie.entryWeight[begin];
    if (end - begin == 2) {
      const double *other = valuesOf(begin + 1) + here, otherWeight = tie.entryWeight[begin + 1];
      for (int k = 0; k < stations; ++k) to[k] = weight * one[k] + otherWeight * other[k];
      continue;
    }
    for (int k = 0; k < stations; ++k) to[k] = weight * one[k];
  }
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
    addStation(
        around ? aroundArc(master, slave.positions[s], radius, layer) : alongLine(master.positions, slave.positions[s]),
        tie);
  return tie;
}

std::size_t tieWorkspace(const SweptTie& tie) { return tie.columns.size() * 3 * tieStations; }

std::vector<StationSpan> slaveSpans(const SweptTie& tie, int firstMaster, int lastMaster) {
  std::vector<StationSpan> spans;
  const auto isOwn = [&](int master) { return master >= firstMaster && master < lastMaster; };
  for (int s = 0; s < static_cast<int>(tie.stretchOf.size()); ++s) {
    if (!isOwn(tie.stations.left[s]) && !isOwn(tie.stations.right[s])) continue;
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
  constexpr int maximum = tieStations;
  const auto &slave = blocks[tie.slaveBlock], &master = blocks[tie.masterBlock];
  for (int from = span.first; from < span.last; from += maximum) {
    const int count = std::min(maximum, span.last - from);
    for (std::size_t j = 0; j < tie.columns.size(); ++j)
      interpolateColumn(tie, tie.columns[j], master, state, from, count, workspace + 3 * j * maximum);
    for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const auto line = slave.line(state, tie.slaveNodes[i], c);
        for (int k = from + maximum; k < std::min(from + 2 * maximum, span.last); k += 8)
          __builtin_prefetch(&line[k], 1, 2);
        interpolateLine(tie, i, c, workspace, from, count, line);
      }
  }
  if (slave.closed && span.first == 0)
    for (const int n : tie.slaveNodes)
      for (int c = 0; c < 3; ++c) state[slave.index(n, c, slave.intervals)] = state[slave.index(n, c, 0)];
}

}  // namespace squat::elasticity
