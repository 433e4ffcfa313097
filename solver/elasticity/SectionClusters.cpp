#include "elasticity/SectionClusters.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/DenseAlgebra.h"
#include "core/ElementaryFunctions.h"
#include "elasticity/SelectiveMassScaling.h"

namespace squat::elasticity {

namespace {

using Clusters = std::vector<std::vector<int>>;
using DynamicVector = Eigen::VectorXd;

double distance(const geometry::Point2& a, const geometry::Point2& b) {
  return elementary::hypot(a[0] - b[0], a[1] - b[1]);
}

// For every node those that share a quad and stand within `reach`; none for nodes that stay alone.
std::vector<std::vector<int>> closeNeighbours(const SweptBlock& block, const std::vector<unsigned char>& mayJoin,
                                              double reach) {
  std::vector<std::vector<int>> close(static_cast<std::size_t>(block.nodes));
  for (int n = 0; n < block.nodes; ++n)
    for (int p = block.rowStart[n]; p < block.rowStart[n + 1]; ++p) {
      const int other = block.columns[p];
      if (other != n && mayJoin[n] && mayJoin[other] &&
          distance(block.section.nodes[n], block.section.nodes[other]) <= reach)
        close[n].push_back(other);
    }
  return close;
}

// The neighbour that keeps the cluster compact: near its middle, with many neighbours in it.
int bestToJoin(const SweptBlock& block, const std::vector<std::vector<int>>& close, const std::vector<int>& cluster,
               const std::vector<unsigned char>& taken) {
  geometry::Point2 middle{0, 0};
  for (const int n : cluster)
    for (int k = 0; k < 2; ++k) middle[k] += block.section.nodes[n][k] / static_cast<double>(cluster.size());
  int best = -1;
  double minimum = std::numeric_limits<double>::infinity();
  for (const int n : cluster)
    for (const int other : close[n]) {
      if (taken[other]) continue;
      const auto links = std::count_if(close[other].begin(), close[other].end(), [&](int m) {
        return std::find(cluster.begin(), cluster.end(), m) != cluster.end();
      });
      const double far = distance(block.section.nodes[other], middle);
      const double badness = far * far / (1 + 0.3 * static_cast<double>(links));
      if (badness < minimum) minimum = badness, best = other;
    }
  return best;
}

Clusters grow(const SweptBlock& block, const std::vector<std::vector<int>>& close, const std::vector<int>& starts,
              std::size_t maximum) {
  Clusters clusters;
  std::vector<unsigned char> taken(static_cast<std::size_t>(block.nodes), 0);
  for (const int start : starts) {
    if (taken[start] || close[start].empty()) continue;
    std::vector<int> cluster{start};
    taken[start] = 1;
    while (cluster.size() < maximum) {
      const int next = bestToJoin(block, close, cluster, taken);
      if (next < 0) break;
      cluster.push_back(next), taken[next] = 1;
    }
    if (cluster.size() > 2) clusters.push_back(std::move(cluster));
  }
  return clusters;
}

// The section in plane strain and shear: what every station of a uniform wave of infinite length does. Nodes that stay
// alone are fixed: they follow others.
class PlaneSection {
 public:
  PlaneSection(const SweptBlock& block, const std::vector<unsigned char>& moves) : block_(block), moves_(moves) {
    std::size_t finest = 0;
    const auto& runs = block.stations.runs;
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (runs[r].length < runs[finest].length) finest = r;
    coefficients_ = &block.coefficients[finest];
    const auto mass = lumpedMass(block);
    for (int n = 0; n < block.nodes; ++n)
      mass_.push_back(mass[static_cast<std::size_t>(n) * block.stride + block.runIntervals[finest][0] + 1]);
  }

  // 4 (S_bb S_bc; S_cb S_cc) and 4 T_aa: both neighbouring intervals, sums 2 u, no differences.
  DynamicVector stiffness(const DynamicVector& u) const {
    DynamicVector f = DynamicVector::Zero(u.size());
    for (int n = 0; n < block_.nodes; ++n)
      for (int p = block_.rowStart[n]; p < block_.rowStart[n + 1]; ++p) {
        const double* s = coefficients_->data() + 18 * static_cast<std::size_t>(p);
        const double* in = u.data() + 3 * block_.columns[p];
        f[3 * n] += 4 * s[9] * in[0];
        f[3 * n + 1] += 4 * (s[4] * in[1] + s[5] * in[2]);
        f[3 * n + 2] += 4 * (s[7] * in[1] + s[8] * in[2]);
      }
    return f;
  }

  // F M^-1 f.
  DynamicVector accelerations(const DynamicVector& f, const Clusters& clusters,
                              const std::vector<Eigen::MatrixXd>& kept) const {
    DynamicVector a(f.size());
    for (int n = 0; n < block_.nodes; ++n) a.segment<3>(3 * n) = moves_[n] * f.segment<3>(3 * n) / mass_[n];
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const auto count = static_cast<Eigen::Index>(clusters[i].size());
      Eigen::MatrixXd own(count, 3), momentum(count, 3);
      for (Eigen::Index k = 0; k < count; ++k) {
        const int node = clusters[i][k];
        own.row(k) = a.segment<3>(3 * node), momentum.row(k) = mass_[node] * a.segment<3>(3 * node);
      }
      own = shortShare * own + (1 - shortShare) * kept[i] * (kept[i].transpose() * momentum);
      for (Eigen::Index k = 0; k < count; ++k) a.segment<3>(3 * clusters[i][k]) = own.row(k);
    }
    return a;
  }

  // Largest eigenvalue of F M^-1 K by Lanczos in the inner product of the effective mass, from below.
  double highestEigenvalue(const Clusters& clusters) const {
    std::vector<Eigen::MatrixXd> kept;
    for (const auto& cluster : clusters) kept.push_back(keptFields(block_, cluster, mass_));
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(block_.nodes);
    DynamicVector momentum(size), before = DynamicVector::Zero(size);
    unsigned seed = 12345;
    for (Eigen::Index i = 0; i < size; ++i) {
      seed = seed * 1664525u + 1013904223u;
      momentum[i] = moves_[i / 3] * (static_cast<double>(seed >> 8) / (1u << 24) - 0.5) * std::sqrt(mass_[i / 3]);
    }
    DynamicVector shape = accelerations(momentum, clusters, kept);
    double norm = std::sqrt(shape.dot(momentum)), last = 0;
    momentum /= norm, shape /= norm;
    constexpr int iterations = 40;
    DynamicVector diagonal(iterations), side(iterations);
    for (int k = 0; k < iterations; ++k) {
      DynamicVector rest = stiffness(shape);
      diagonal[k] = shape.dot(rest);
      rest -= diagonal[k] * momentum + last * before;
      const DynamicVector next = accelerations(rest, clusters, kept);
      last = side[k] = std::sqrt(std::max(0.0, next.dot(rest)));
      before = momentum, momentum = rest / last, shape = next / last;
    }
    return algebra::largestOfTridiagonal(diagonal, side.head(iterations - 1));
  }

 private:
  const SweptBlock& block_;
  std::vector<unsigned char> moves_;
  const std::vector<double>* coefficients_;
  std::vector<double> mass_;
};

}  // namespace

Clusters sectionClusters(const SweptBlock& block, const std::function<bool(int)>& mayJoin) {
  std::vector<unsigned char> joins;
  for (int n = 0; n < block.nodes; ++n) joins.push_back(mayJoin(n));
  const PlaneSection plane(block, joins);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& quad : block.section.quads)
    for (int k = 0; k < 4; ++k)
      shortest = std::min(shortest, distance(block.section.nodes[quad[k]], block.section.nodes[quad[(k + 1) % 4]]));
  Clusters best;
  double minimum = plane.highestEigenvalue({});
  for (const double reach : {2.2, 3.0, 4.0, 6.0})
    for (const std::size_t maximum : {16u, 18u, 20u, 22u, 24u, 26u, 28u, 30u, 32u}) {
      const auto close = closeNeighbours(block, joins, reach * shortest);
      std::vector<int> starts = block.order.nodes;
      for (int turn = 0; turn < 2; ++turn, std::reverse(starts.begin(), starts.end())) {
        Clusters trial = grow(block, close, starts, maximum);
        const double highest = plane.highestEigenvalue(trial);
        if (highest < minimum) minimum = highest, best = std::move(trial);
      }
    }
  std::vector<unsigned char> alone = joins;
  for (const auto& cluster : best)
    for (const int n : cluster) alone[n] = 0;
  for (int n = 0; n < block.nodes; ++n)
    if (alone[n]) best.push_back({n});
  return best;
}

}  // namespace squat::elasticity
