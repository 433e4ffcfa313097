#include "elasticity/SelectiveMassScaling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/DenseAlgebra.h"
#include "elasticity/SweptBlock.h"

namespace squat::elasticity {

namespace {

// Fields, one a column, made orthonormal in the masses; columns that say nothing new are zero.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& given, const Eigen::VectorXd& mass) {
  const Eigen::VectorXd root = mass.cwiseSqrt();
  return root.cwiseInverse().asDiagonal() * algebra::orthonormalSpan(root.asDiagonal() * given, 1e-3);
}

void addCluster(const SweptBlock& block, const KernelCluster& cluster, const std::vector<double>& mass,
                SelectiveMassScaling& out) {
  const std::vector<int> nodes(block.order.members.begin() + cluster.first, block.order.members.begin() + cluster.end);
  const Eigen::MatrixXd kept = keptFields(block, nodes, mass);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int k = 0; k < keptAcross; ++k) {
      const double value = kept(static_cast<Eigen::Index>(i), k);
      const std::size_t at =
          2 * keptAcross * (static_cast<std::size_t>(cluster.first) + i) + static_cast<std::size_t>(k);
      out.weights[at] = (1 - out.share) * mass[nodes[i]] * value;
      out.weights[at + keptAcross] = value;
    }
}

// Weights and fields of `stations` stations, for accelerations times the station's mass (SweptKernel.h): there the
// fields of the accelerations are the weights. `before`: mass of the interval ahead of the first, `own` of all others.
Eigen::MatrixXd alongProjection(int stations, double before, double own) {
  Eigen::MatrixXd given(stations, keptAlong);
  Eigen::VectorXd mass = Eigen::VectorXd::Constant(stations, own);
  mass[0] = 0.5 * (before + own);
  for (int i = 0; i < stations; ++i) given.row(i) << 1, i - 0.5 * (stations - 1);
  Eigen::MatrixXd weightsAndFields(stations, 2 * keptAlong);
  weightsAndFields.leftCols(keptAlong) = orthonormal(given, mass);
  weightsAndFields.rightCols(keptAlong) = mass.asDiagonal() * weightsAndFields.leftCols(keptAlong);
  return weightsAndFields;
}

// Mass of each section node at a station amid a run: in proportion the same at every station.
std::vector<double> sectionMass(const SweptBlock& block) {
  const auto mass = lumpedMass(block);
  const int station = block.runIntervals.front()[0] + 1;
  std::vector<double> own;
  for (int n = 0; n < block.nodes; ++n) own.push_back(mass[static_cast<std::size_t>(n) * block.stride + station]);
  return own;
}

}  // namespace

Eigen::MatrixXd keptFields(const SweptBlock& block, const std::vector<int>& cluster, const std::vector<double>& mass) {
  const auto count = static_cast<Eigen::Index>(cluster.size());
  Eigen::MatrixXd given(count, keptAcross);
  Eigen::VectorXd own(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& p = block.section.nodes[cluster[i]];
    given.row(i) << 1, p[0], p[1];
    own[i] = mass[cluster[i]];
  }
  for (int k = 1; k < keptAcross; ++k) given.col(k).array() -= given.col(k).mean();
  given.rightCols(2) /= given.rightCols(2).cwiseAbs().maxCoeff();
  return orthonormal(given, own);
}

SelectiveMassScaling selectiveMassScaling(const SweptBlock& block) {
  SelectiveMassScaling out;
  out.along.resize(block.runIntervals.size()), out.singleAlong.resize(block.runIntervals.size());
  if (block.clusters.empty()) return out;
  out.share = shortShare;
  out.weights.assign(2 * keptAcross * static_cast<std::size_t>(block.nodes), 0.0);
  const auto mass = sectionMass(block);
  out.clusters = block.order.clusters;
  for (const auto& cluster : out.clusters) addCluster(block, cluster, mass, out);
  out.singleWeights.assign(out.weights.begin(), out.weights.end());
  const auto& runs = block.stations.runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r].length > block.shortLength) continue;
    const double before = r > 0 ? runs[r - 1].length : block.closed ? runs.back().length : 0.0;
    out.along[r].resize(projectionsSize);
    const double own = massOfInterval(block, runs[r].length);
    for (const int stations : {stationUnit, maximumStations})
      for (const bool isFirst : {true, false}) {
        const auto projection = alongProjection(stations, isFirst ? massOfInterval(block, before) : own, own);
        std::copy_n(projection.data(), projection.size(),
                    out.along[r].data() + projectionLocation[stations == maximumStations][!isFirst]);
      }
    out.singleAlong[r].assign(out.along[r].begin(), out.along[r].end());
  }
  return out;
}

StationGroup stationGroup(const SweptBlock& block, int station) {
  if (station >= block.intervals || block.inertia.along.empty()) return {station, 1};
  const auto r = static_cast<std::size_t>(block.runOf(station));
  if (block.inertia.along[r].empty()) return {station, 1};
  const int first = station / maximumStations * maximumStations;
  const auto [begin, end] = block.runIntervals[r];
  if (first >= begin && first + maximumStations <= end) return {first, maximumStations};
  return {station / stationUnit * stationUnit, stationUnit};
}

namespace {

using Square = std::array<std::array<double, keptInBlock>, keptInBlock>;

// Rows T with T G T^t = 1, each a combination of those before it: by Cholesky, without a field that the others hold.
Square orthonormalRows(const Square& gram) {
  Square lower{}, rows{};
  for (int k = 0; k < keptInBlock; ++k) {
    for (int j = 0; j < k; ++j) {
      if (lower[j][j] == 0) continue;
      double sum = gram[k][j];
      for (int l = 0; l < j; ++l) sum -= lower[k][l] * lower[j][l];
      lower[k][j] = sum / lower[j][j];
    }
    double left = gram[k][k];
    for (int j = 0; j < k; ++j) left -= lower[k][j] * lower[k][j];
    if (!(left > 1e-6 * gram[k][k])) continue;  // less than a thousandth beside the others (keptFields)
    lower[k][k] = std::sqrt(left);
    rows[k][k] = 1;
    for (int j = 0; j < k; ++j)
      for (int l = 0; l < keptInBlock; ++l) rows[k][l] -= lower[k][j] * rows[j][l];
    for (double& value : rows[k]) value /= lower[k][k];
  }
  return rows;
}

}  // namespace

// Fields are products of (1, b, c) and (1, a), each scaled to its reach: their moments along are summed for each node,
// then multiplied. Nodes in one line but for rounding have no reach beside it.
void blockFilter(const SweptBlock& block, const std::vector<int>& cluster, int stations,
                 const std::vector<double>& mass, std::vector<double>& values) {
  const std::size_t rows = cluster.size(), size = mass.size();
  geometry::Point2 middle{0, 0}, reach{0, 0};
  for (const int n : cluster)
    for (int k = 0; k < 2; ++k) middle[k] += block.section.nodes[n][k] / static_cast<double>(rows);
  for (const int n : cluster)
    for (int k = 0; k < 2; ++k) reach[k] = std::max(reach[k], std::abs(block.section.nodes[n][k] - middle[k]));
  const double minimum = 1e-9 * std::max(reach[0], reach[1]);
  const auto across = [&](std::size_t i) {
    const auto& p = block.section.nodes[cluster[i]];
    return std::array<double, keptAcross>{1, reach[0] > minimum ? (p[0] - middle[0]) / reach[0] : 0,
                                          reach[1] > minimum ? (p[1] - middle[1]) / reach[1] : 0};
  };
  const double half = 0.5 * (stations - 1);
  Square gram{};
  for (std::size_t i = 0; i < rows; ++i) {
    double moment[3] = {0, 0, 0};
    for (int s = 0; s < stations; ++s) {
      const double m = mass[i * stations + s], a = (s - half) / half;
      moment[0] += m, moment[1] += m * a, moment[2] += m * a * a;
    }
    const auto q = across(i);
    for (int j = 0; j < keptInBlock; ++j)
      for (int k = 0; k <= j; ++k)
        gram[j][k] += moment[j / keptAcross + k / keptAcross] * q[j % keptAcross] * q[k % keptAcross];
  }
  const Square kept = orthonormalRows(gram);
  values.resize(2 * keptInBlock * size);
  const double taken = 1 - block.inertia.share;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto q = across(i);
    for (int k = 0; k < keptInBlock; ++k) {
      const auto& t = kept[k];
      const double constant = t[0] * q[0] + t[1] * q[1] + t[2] * q[2], linear = t[3] * q[0] + t[4] * q[1] + t[5] * q[2];
      double* weights = values.data() + k * size + i * stations;
      double* fields = weights + keptInBlock * size;
      const double* own = mass.data() + i * stations;
      for (int s = 0; s < stations; ++s) {
        fields[s] = constant + (s - half) / half * linear;
        weights[s] = taken * own[s] * fields[s];
      }
    }
  }
}

void slowShortWaves(const SweptBlock& block, double* acceleration) {
  const auto& inertia = block.inertia;
  const auto at = [&](int member, int c, int s) -> double& {
    return acceleration[block.index(block.order.members[member], c, s) - block.offset];
  };
  const auto amplitudes = [&](const KernelCluster& cluster, int c, int s) {
    std::array<double, keptAcross> sum{};
    for (int member = cluster.first; member < cluster.end; ++member)
      for (int k = 0; k < keptAcross; ++k) sum[k] += inertia.weights[2 * keptAcross * member + k] * at(member, c, s);
    return sum;
  };
  const auto filter = [&](const KernelCluster& cluster, int c, int s, const std::array<double, keptAcross>& sum) {
    for (int member = cluster.first; member < cluster.end; ++member) {
      double& value = at(member, c, s);
      value *= inertia.share;
      for (int k = 0; k < keptAcross; ++k) value += inertia.weights[2 * keptAcross * member + keptAcross + k] * sum[k];
    }
  };
  for (const auto& cluster : inertia.clusters)
    for (int c = 0; c < 3; ++c)
      for (int first = 0; first < block.stationCount;) {
        const int count = stationGroup(block, first).count;
        std::array<std::array<double, keptAcross>, maximumStations> sums{}, along{};
        for (int s = 0; s < count; ++s) along[s] = sums[s] = amplitudes(cluster, c, first + s);
        if (count > 1) {
          const auto r = static_cast<std::size_t>(block.runOf(first));
          const double* projection =
              inertia.along[r].data() + projectionLocation[count == maximumStations][first != block.runIntervals[r][0]];
          for (int k = 0; k < keptAcross; ++k) {
            for (int i = 0; i < count; ++i) along[i][k] = 0;
            for (int field = 0; field < keptAlong; ++field) {  // here of accelerations themselves
              double amplitude = 0;
              for (int j = 0; j < count; ++j) amplitude += projection[count * (keptAlong + field) + j] * sums[j][k];
              for (int i = 0; i < count; ++i) along[i][k] += projection[count * field + i] * amplitude;
            }
          }
        }
        for (int s = 0; s < count; ++s) filter(cluster, c, first + s, along[s]);
        first += count;
      }
}

void scaleMassAcross(const SweptBlock& block, double* acceleration) {
  const auto& inertia = block.inertia;
  for (const auto& cluster : inertia.clusters)
    for (int c = 0; c < 3; ++c) {
      std::array<double, keptAcross> amplitude{};
      for (int member = cluster.first; member < cluster.end; ++member)
        for (int k = 0; k < keptAcross; ++k)
          amplitude[k] +=
              inertia.weights[2 * keptAcross * member + k] * acceleration[3 * block.order.members[member] + c];
      for (int member = cluster.first; member < cluster.end; ++member) {
        const auto at = 3 * block.order.members[member] + c;
        double value = acceleration[at] * inertia.share;
        for (int k = 0; k < keptAcross; ++k)
          value += inertia.weights[2 * keptAcross * member + keptAcross + k] * amplitude[k];
        acceleration[at] = value;
      }
    }
}

}  // namespace squat::elasticity
