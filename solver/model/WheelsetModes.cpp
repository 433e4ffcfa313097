#include "model/WheelsetModes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "elasticity/SweptBlock.h"
#include "geometry/WheelSection.h"

namespace squat::model {

namespace {

constexpr int sectors = 48;
constexpr double sectionSize = 0.016;  // [m]

elasticity::SweptBlock wholeWheelset(const cases::Wheelset& w) {
  elasticity::SweptBlock block;
  block.name = "wheelset";
  block.kind = elasticity::SweepKind::aroundAxis;
  block.section = geometry::wheelBodySectionMesh(w, {sectionSize, 0, sectionSize, 1.5, 0});
  block.material = w.material;
  block.stations = {0, true, {{sectors, 2 * std::acos(-1.0) / sectors}}};
  elasticity::prepareBlock(block);
  return block;
}

std::vector<int> nodesOn(const elasticity::SweptBlock& block, double radius, double from, double to) {
  return geometry::nodesWhere(
      block.section,
      [&](const geometry::Point2& p) {
        return std::abs(p[0] - radius) < 1e-9 && p[1] > from - 1e-9 && p[1] < to + 1e-9;
      },
      1);
}

void addMass(std::vector<double>& mass, const std::vector<int>& nodes, double total) {
  for (const int n : nodes) mass[n] += total / static_cast<double>(nodes.size()) / sectors;
}

// Vertical mean motion of a ring for u_r = b cos(alpha), u_alpha = a sin(alpha): (a - b) / 2.
double ringShare(const std::vector<int>& nodes, const Eigen::VectorXd& shape) {
  double sum = 0;
  for (const int n : nodes) sum += 0.5 * (shape[3 * n] - shape[3 * n + 1]);
  return sum / static_cast<double>(nodes.size());
}

}  // namespace

std::vector<HarmonicMode> wheelsetModes(const cases::CaseDescription& d, double highest, int lastHarmonic) {
  const auto& w = d.wheelset;
  const auto block = wholeWheelset(w);
  const auto lumped = elasticity::lumpedMass(block);
  std::vector<double> mass(block.nodes);
  double solid = 0;
  for (int n = 0; n < block.nodes; ++n) mass[n] = lumped[n * block.stride], solid += sectors * mass[n];
  const auto bearing =
      nodesOn(block, w.journalRadius, w.bearingCentre - w.bearingWidth / 2, w.bearingCentre + w.bearingWidth / 2);
  const auto centre = nodesOn(block, w.seatRadius, -1e-6, 1e-6);
  const auto tread = nodesOn(block, w.radius, -1e-6, 1e-6);
  addMass(mass, bearing, w.axleBoxMass);
  addMass(mass, nodesOn(block, w.axleRadius, -0.85 * w.trackCentre, -0.25 * w.trackCentre),
          std::max(0.0, w.totalMass - w.axleBoxMass - solid));

  std::vector<HarmonicMode> modes;
  for (int harmonic = 0; harmonic <= lastHarmonic; ++harmonic) {
    const double half = harmonic * std::acos(-1.0) / sectors, c = std::cos(half), s = std::sin(half);
    // Sums and differences over an interval of u_r, u_y ~ cos(n alpha), u_alpha ~ sin(n alpha).
    const double forS[3] = {2 * s, 2 * c, 2 * c}, forT[3] = {2 * c, -2 * s, -2 * s};
    const int size = 3 * block.nodes;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < block.nodes; ++i)
      for (int p = block.rowStart[i]; p < block.rowStart[i + 1]; ++p) {
        const double* k = block.coefficients[0].data() + 18 * static_cast<std::size_t>(p);
        const int j = block.columns[p];
        for (int row = 0; row < 3; ++row)
          for (int column = 0; column < 3; ++column)
            matrix(3 * i + row, 3 * j + column) +=
                forS[row] * k[3 * row + column] * forS[column] + forT[row] * k[9 + 3 * row + column] * forT[column];
      }
    std::vector<int> kept;
    for (int n = 0; n < block.nodes; ++n)
      for (int component = 0; component < 3; ++component)
        if (component != 2 || block.section.nodes[n][1] > -w.trackCentre + 1e-9) kept.push_back(3 * n + component);
    Eigen::MatrixXd scaled(kept.size(), kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (std::size_t j = 0; j < kept.size(); ++j)
        scaled(i, j) = matrix(kept[i], kept[j]) / std::sqrt(mass[kept[i] / 3] * mass[kept[j] / 3]);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    // Half the circumference's mean of cos^2 for n > 0; the whole for n = 0.
    const double share = harmonic == 0 ? 1.0 : 0.5;
    for (int k = 0; k < static_cast<int>(kept.size()); ++k) {
      const double frequency = std::sqrt(std::max(0.0, eigen.eigenvalues()[k])) / (2 * std::acos(-1.0));
      if (frequency > highest) break;
      if (frequency < 1) continue;  // rigid
      Eigen::VectorXd shape = Eigen::VectorXd::Zero(size);
      for (std::size_t i = 0; i < kept.size(); ++i)
        shape[kept[i]] =
            eigen.eigenvectors()(static_cast<Eigen::Index>(i), k) / std::sqrt(mass[kept[i] / 3] * share * sectors);
      HarmonicMode mode{frequency, harmonic, 0, 0, 0};
      if (harmonic == 1) mode.boxShare = ringShare(bearing, shape), mode.wheelShare = ringShare(centre, shape);
      for (const int n : tread) mode.contactShare -= shape[3 * n + 1] / static_cast<double>(tread.size());
      modes.push_back(mode);
    }
  }
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace squat::model
