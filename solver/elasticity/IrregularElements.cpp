#include "elasticity/IrregularElements.h"

namespace squat::elasticity {

namespace {

// product = difference * gathered u of one element.
void multiply(const double* matrix, const std::array<std::size_t, 24>& unknown, const double* u,
              double (&product)[24]) {
  double own[24];
  for (int j = 0; j < 24; ++j) own[j] = u[unknown[j]], product[j] = 0;
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 24; ++i) product[i] += matrix[24 * j + i] * own[j];
}

}  // namespace

IrregularElements irregularElements(const SweptBlock& block, const NodeShift& shift) {
  IrregularElements list;
  for (int q = 0; q < static_cast<int>(block.section.quads.size()); ++q)
    for (int s = 0; s < block.intervals; ++s) {
      const auto& quad = block.section.quads[q];
      const double length = block.stations.runs[block.runOf(s)].length;
      Corners corners = elementCorners(block, q, length);
      bool moved = false;
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < 4; ++i) {
          const Eigen::Vector3d by = shift(quad[i], s + side);
          moved = moved || by.squaredNorm() > 0;
          corners[4 * side + i] += by;
        }
      if (!moved) continue;
      const Matrix24 difference = hexahedronStiffness(corners, block.material) - elementStiffness(block, q, length);
      std::array<std::size_t, 24> unknown{};
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < 4; ++i)
          for (int c = 0; c < 3; ++c) unknown[12 * side + 3 * i + c] = block.index(quad[i], c, s + side);
      list.unknown.push_back(unknown);
      list.difference.insert(list.difference.end(), difference.data(), difference.data() + 576);
    }
  return list;
}

void addIrregularStiffness(const IrregularElements& elements, const double* u, double* result) {
  double product[24];
  for (std::size_t e = 0; e < elements.size(); ++e) {
    multiply(elements.difference.data() + 576 * e, elements.unknown[e], u, product);
    for (int i = 0; i < 24; ++i) result[elements.unknown[e][i]] += product[i];
  }
}

void addIrregularForces(const IrregularElements& elements, const double* u, double* forces) {
  double product[24];
  for (std::size_t e = 0; e < elements.size(); ++e) {
    multiply(elements.difference.data() + 576 * e, elements.unknown[e], u, product);
    for (int i = 0; i < 24; ++i) forces[elements.forceSlot[e][i]] -= product[i];
  }
}

}  // namespace squat::elasticity
