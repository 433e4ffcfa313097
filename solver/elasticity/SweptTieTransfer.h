// solver/elasticity/SweptTieTransfer.h - the transpose of the tie as a template over where force lines are kept.
#pragma once

#include <algorithm>

namespace squat::elasticity {

template <typename SlaveLine, typename MasterLine>
void transferForces(const SweptTie& tie, const SweptBlock& slave, double sign, const SlaveLine& slaveLine,
                    const MasterLine& masterLine, double* workspace, int firstMaster, int lastMaster,
                    const std::vector<StationSpan>& spans) {
  const std::size_t stride = slave.stride;
  for (const auto& span : spans)
    for (std::size_t line = 0; line < tie.columns.size() * 3; ++line)
      std::fill(workspace + line * stride + span.first, workspace + line * stride + span.last, 0.0);
  for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
    for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e)
      for (int c = 0; c < 3; ++c) {
        const auto force = slaveLine(static_cast<int>(i), c);
        double* column = workspace + (static_cast<std::size_t>(tie.entryColumn[e]) * 3 + c) * stride;
        const double weight = sign * tie.entryWeight[e];
        for (const auto& span : spans)
          for (int s = span.first; s < span.last; ++s) column[s] += weight * force[s];
      }
  for (std::size_t j = 0; j < tie.columns.size(); ++j) {
    const double* f = workspace + j * 3 * stride;
    for (int layer = 0; layer < 2; ++layer) {
      const int node = layer ? tie.columns[j].inner : tie.columns[j].outer;
      if (layer && node < 0) continue;
      const auto a = masterLine(node, 0), b = masterLine(node, 1), c = masterLine(node, 2);
      for (const auto& span : spans)
        for (int s = span.first; s < span.last; ++s) {
          const auto& at = tie.stations[s];
          const double share = layer ? -at.extrapolation : 1 + at.extrapolation;
          const double fa = share * f[s], fb = share * f[stride + s], fc = share * f[2 * stride + s];
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
