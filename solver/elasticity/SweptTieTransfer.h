// solver/elasticity/SweptTieTransfer.h - the transpose of the tie as a template over where force lines are kept.
#pragma once

#include <algorithm>
#include <vector>

namespace squat::elasticity {

// What one column passes on from the stations of one stretch, [first, last), to its masters left and right of them:
// forces of the outer one, and their moments by which the inner one pulls against it. Lines of `force` begin at `from`.
struct StretchSums {
  double outer[3][2], excess[3][2];  // component, left and right

  StretchSums(const SweptTie::Stations& at, const double* force, int from, int first, int last) {
    SweptTie::Stations::Turned a{}, b{}, c{};  // sums of the components times the weights
    for (int s = first; s < last; ++s) {
      const auto& by = at.turned[s];
      const double alongA = force[s - from], alongB = force[tieStations + s - from];
      a.left += by.left * alongA, a.right += by.right * alongA;
      a.leftBeyond += by.leftBeyond * alongA, a.rightBeyond += by.rightBeyond * alongA;
      b.left += by.left * alongB, b.right += by.right * alongB;
      b.leftBeyond += by.leftBeyond * alongB, b.rightBeyond += by.rightBeyond * alongB;
      const double alongC = force[2 * tieStations + s - from];
      c.across += by.across * alongC, c.acrossBeyond += by.acrossBeyond * alongC;
    }
    const auto turnBack = [](Two cosineA, Two cosineB, double(&to)[3][2], int side) {
      to[0][side] = cosineA[0] - cosineB[1], to[1][side] = cosineA[1] + cosineB[0];
    };
    turnBack(a.left, b.left, outer, 0), turnBack(a.right, b.right, outer, 1);
    turnBack(a.leftBeyond, b.leftBeyond, excess, 0), turnBack(a.rightBeyond, b.rightBeyond, excess, 1);
    for (int side = 0; side < 2; ++side) outer[2][side] = c.across[side], excess[2][side] = c.acrossBeyond[side];
  }
};

// A function of its own, so that nothing but these four stays in registers while it runs.
[[gnu::noinline]] inline void addTimes(double weight, const double* values, int count, double* __restrict sum) {
  for (int k = 0; k < count; ++k) sum[k] += weight * values[k];
}

// Adds what a column passes on to its masters' lines, all stretches of [from, end) in turn.
template <typename MasterLine>
void passColumn(const SweptTie& tie, const SweptTie::Column& column, const double* force, int from, int end,
                const MasterLine& masterLine, int firstMaster, int lastMaster) {
  using Line = decltype(masterLine(0, 0));
  const bool hasInner = column.inner >= 0;
  const int inner = hasInner ? column.inner : column.outer;
  Line to[3] = {masterLine(column.outer, 0), masterLine(column.outer, 1), masterLine(column.outer, 2)};
  Line against[3] = {masterLine(inner, 0), masterLine(inner, 1), masterLine(inner, 2)};
  for (int first = from, last = from; first < end; first = last) {
    last = tie.stretchEnd[tie.stretchOf[first]];
    const StretchSums passed(tie.stations, force, from, first, last);
    const int masters[2] = {tie.stations.left[first], tie.stations.right[first]};
    for (int side = 0; side < 2; ++side) {
      if (masters[side] < firstMaster || masters[side] >= lastMaster) continue;
      for (int c = 0; c < 3; ++c) {
        to[c][masters[side]] += passed.outer[c][side] + passed.excess[c][side];
        if (hasInner) against[c][masters[side]] -= passed.excess[c][side];
      }
    }
  }
}

template <typename SlaveLine, typename MasterLine>
void transferForces(const SweptTie& tie, double sign, const SlaveLine& slaveLine, const MasterLine& masterLine,
                    double* workspace, int firstMaster, int lastMaster, const std::vector<StationSpan>& spans) {
  constexpr int maximum = tieStations;  // a few stations at a time: lines are read and written in long pieces
  const std::size_t sums = 3 * tie.columns.size();
  const auto endOf = [&](int station) { return tie.stretchEnd[tie.stretchOf[station]]; };
  for (const auto& span : spans)
    for (int from = span.first, end = from; from < span.last; from = end) {
      while (end < span.last && endOf(end) - from <= maximum) end = endOf(end);
      const int count = end - from;
      std::fill(workspace, workspace + sums * maximum, 0.0);
      for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
        for (int c = 0; c < 3; ++c) {
          const auto line = slaveLine(static_cast<int>(i), c);
          for (int k = end; k < std::min(end + maximum, span.last); k += 8) __builtin_prefetch(&line[k], 0, 2);
          double force[maximum];
          for (int k = 0; k < count; ++k) force[k] = line[from + k];
          for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
            double* sum = workspace + (3 * static_cast<std::size_t>(tie.entryColumn[e]) + c) * maximum;
            addTimes(sign * tie.entryWeight[e], force, count, sum);
          }
        }
      for (std::size_t j = 0; j < tie.columns.size(); ++j)
        passColumn(tie, tie.columns[j], workspace + 3 * j * maximum, from, end, masterLine, firstMaster, lastMaster);
    }
}

}  // namespace squat::elasticity
