// solver/elasticity/SweptTieTransfer.h - the transpose of the tie as a template over where force lines are kept.
#pragma once

#include <algorithm>
#include <vector>

namespace squat::elasticity {

// What one column passes on from the stations of one stretch, [first, last), to its masters left and right of them:
// forces of the outer one, and their moments by which the inner one pulls against it. Lines of `force` begin at `from`.
struct StretchSums {
  double outer[3][2] = {}, excess[3][2] = {};  // component, left and right

  StretchSums(const SweptTie::Stations& at, const double* force, int from, int first, int last) {
    for (int s = first; s < last; ++s) {
      const double a = force[s - from], b = force[tieStations + s - from], c = force[2 * tieStations + s - from];
      const double parts[3][2] = {
          {at.leftCosine[s] * a - at.leftSine[s] * b, at.rightCosine[s] * a - at.rightSine[s] * b},
          {at.leftSine[s] * a + at.leftCosine[s] * b, at.rightSine[s] * a + at.rightCosine[s] * b},
          {at.leftWeight[s] * c, at.rightWeight[s] * c}};
      for (int k = 0; k < 3; ++k)
        for (int side = 0; side < 2; ++side) {
          outer[k][side] += parts[k][side];
          excess[k][side] += at.extrapolation[s] * parts[k][side];
        }
    }
  }
};

template <typename SlaveLine, typename MasterLine>
void transferForces(const SweptTie& tie, double sign, const SlaveLine& slaveLine, const MasterLine& masterLine,
                    double* workspace, int firstMaster, int lastMaster, const std::vector<StationSpan>& spans) {
  constexpr int most = tieStations;  // a few stations at a time: lines are read and written in long pieces
  std::vector<decltype(slaveLine(0, 0))> slaves;
  for (int i = 0; i < static_cast<int>(tie.slaveNodes.size()); ++i)
    for (int c = 0; c < 3; ++c) slaves.push_back(slaveLine(i, c));
  const std::size_t sums = 3 * tie.columns.size();
  const auto endOf = [&](int station) { return tie.stretchEnd[tie.stretchOf[station]]; };
  for (const auto& span : spans)
    for (int from = span.first, end = from; from < span.last; from = end) {
      while (end < span.last && endOf(end) - from <= most) end = endOf(end);
      const int count = end - from;
      std::fill(workspace, workspace + sums * most, 0.0);
      for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
        for (int c = 0; c < 3; ++c) {
          for (int k = end; k < std::min(end + most, span.last); k += 8)
            __builtin_prefetch(&slaves[3 * i + c][k], 0, 2);
          double force[most];
          for (int k = 0; k < count; ++k) force[k] = slaves[3 * i + c][from + k];
          for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
            double* sum = workspace + (3 * static_cast<std::size_t>(tie.entryColumn[e]) + c) * most;
            const double weight = sign * tie.entryWeight[e];
            for (int k = 0; k < count; ++k) sum[k] += weight * force[k];
          }
        }
      for (std::size_t j = 0; j < tie.columns.size(); ++j)
        for (int first = from; first < end; first = endOf(first)) {
          const StretchSums passed(tie.stations, workspace + 3 * j * most, from, first, endOf(first));
          const int masters[2] = {tie.stations.left[first], tie.stations.right[first]};
          for (int c = 0; c < 3; ++c)
            for (int side = 0; side < 2; ++side) {
              if (masters[side] < firstMaster || masters[side] >= lastMaster) continue;
              masterLine(tie.columns[j].outer, c)[masters[side]] += passed.outer[c][side] + passed.excess[c][side];
              if (tie.columns[j].inner >= 0)
                masterLine(tie.columns[j].inner, c)[masters[side]] -= passed.excess[c][side];
            }
        }
    }
}

}  // namespace squat::elasticity
