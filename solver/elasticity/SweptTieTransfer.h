// solver/elasticity/SweptTieTransfer.h - the transpose of the tie as a template over where force lines are kept.
#pragma once

#include <algorithm>
#include <vector>

namespace squat::elasticity {

template <typename SlaveLine, typename MasterLine>
void transferForces(const SweptTie& tie, double sign, const SlaveLine& slaveLine, const MasterLine& masterLine,
                    double* workspace, int firstMaster, int lastMaster, const std::vector<StationSpan>& spans) {
  constexpr int most = tieStations;  // a few stations at a time: lines are read and written in long pieces
  std::vector<decltype(slaveLine(0, 0))> slaves;
  for (int i = 0; i < static_cast<int>(tie.slaveNodes.size()); ++i)
    for (int c = 0; c < 3; ++c) slaves.push_back(slaveLine(i, c));
  const std::size_t sums = 3 * tie.columns.size();
  for (const auto& span : spans)
    for (int from = span.first; from < span.last; from += most) {
      const int count = std::min(most, span.last - from);
      std::fill(workspace, workspace + sums * most, 0.0);
      for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
        for (int c = 0; c < 3; ++c) {
          double force[most] = {};
          for (int k = 0; k < count; ++k) force[k] = slaves[3 * i + c][from + k];
          for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
            double* sum = workspace + (3 * static_cast<std::size_t>(tie.entryColumn[e]) + c) * most;
            const double weight = sign * tie.entryWeight[e];
            for (int k = 0; k < most; ++k) sum[k] += weight * force[k];
          }
        }
      for (std::size_t j = 0; j < tie.columns.size(); ++j)
        for (int layer = 0; layer < 2; ++layer) {
          const int node = layer ? tie.columns[j].inner : tie.columns[j].outer;
          if (node < 0) continue;
          const double* f = workspace + 3 * j * most;
          const auto a = masterLine(node, 0), b = masterLine(node, 1), c = masterLine(node, 2);
          for (int k = 0; k < count; ++k) {
            const auto& at = tie.stations[from + k];
            const double share = layer ? -at.extrapolation : 1 + at.extrapolation;
            const double fa = share * f[k], fb = share * f[most + k], fc = share * f[2 * most + k];
            if (at.left >= firstMaster && at.left < lastMaster) {
              a[at.left] += at.leftCosine * fa - at.leftSine * fb;
              b[at.left] += at.leftSine * fa + at.leftCosine * fb;
              c[at.left] += at.leftWeight * fc;
            }
            if (at.right >= firstMaster && at.right < lastMaster) {
              a[at.right] += at.rightCosine * fa - at.rightSine * fb;
              b[at.right] += at.rightSine * fa + at.rightCosine * fb;
              c[at.right] += at.rightWeight * fc;
            }
          }
        }
    }
}

}  // namespace squat::elasticity
