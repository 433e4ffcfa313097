// A steel sphere pressed on a steel block, on three meshes: Hertz's contact in a case of its own, with the penalty and
// the 2x2 Gauss points a face that wheel and rail use. Theory: H. Hertz 1881; K. L. Johnson, Contact Mechanics (1985),
// ch. 4: with 1/E* = 2 (1 - nu^2) / E,
//   a^3 = 3 F R / 4 E*,  p0 = 3 F / 2 pi a^2,  approach = a^2 / R.
// Two bodies of one material share gap and approach evenly (both are half spaces to Hertz): the block sees half of the
// gap, r^2 / 4 R, and a penalty of 2 k. The block is a quarter of the half space out to five contact radii; its far
// faces are held at the displacements of a point load on a half space (J. Boussinesq; Johnson 3.4), so that what is
// missing of the half space is in the model. Half axes sqrt(5 <x^2>) and peak 3 F / 2 pi a b by moments, as the program
// reports them; the approach after the penalty's own share p0 / 2k is taken off. Tolerances: 6 % at 1.3 mm, 3 % at 0.65
// mm for a contact radius of 6 mm; at 2.6 mm 12 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "elasticity/SweptSamples.h"
#include "elasticity/SweptWork.h"

namespace squat::elasticity {
namespace {

constexpr double radius = 0.4, wishedHalfAxis = 0.006;
const double modulus = steel.young / (2 * (1 - steel.poisson * steel.poisson));
const double load = 4 * modulus * std::pow(wishedHalfAxis, 3) / (3 * radius);  // [N] on the whole sphere

// From 0 to at least `to`: even steps over the contact, then growing.
std::vector<double> graded(double size, double even, double to) {
  std::vector<double> at{0};
  while (at.back() < even - 1e-9) at.push_back(at.back() + size);
  for (double step = size * 1.25; at.back() < to; step *= 1.25) at.push_back(at.back() + step);
  return at;
}

// The quarter block x, y >= 0, z <= 0, swept along x. Runs of eight even intervals, lengths growing from run to run.
SweptBlock quarterBlock(double size) {
  SweptBlock block;
  block.name = "quarter", block.material = steel;
  const double extent = 5 * wishedHalfAxis;
  const auto y = graded(size, 1.5 * wishedHalfAxis, extent);
  auto depth = graded(size, wishedHalfAxis, extent);
  std::vector<double> z;
  for (auto it = depth.rbegin(); it != depth.rend(); ++it) z.push_back(-*it);
  block.section = gridSection(y, z);
  double at = 0;
  int even = static_cast<int>(std::ceil(1.5 * wishedHalfAxis / size / 8)) * 8;
  block.stations.runs.push_back({even, size});
  at = even * size;
  for (double length = 1.5 * size; at < extent; length *= 1.5) {
    block.stations.runs.push_back({8, length});
    at += 8 * length;
  }
  return block;
}

Eigen::Vector3d boussinesq(const Eigen::Vector3d& p) {
  // Load along -z on the surface z = 0 of the half space z < 0.
  const double shear = steel.young / 2 / (1 + steel.poisson), nu = steel.poisson, pi = std::acos(-1.0);
  const double depth = -p[2], rho = p.norm(), scale = load / (4 * pi * shear);
  const double lateral = scale * (depth / (rho * rho * rho) - (1 - 2 * nu) / (rho * (rho + depth)));
  const double down = scale * (depth * depth / (rho * rho * rho) + 2 * (1 - nu) / rho);
  return {lateral * p[0], lateral * p[1], -down};
}

struct Point {
  std::size_t corner[4];
  double weight[4];
  double area, x, y;
};

struct Hertz {
  double a = 0, b = 0, peak = 0;     // [m], [m], [Pa]
  double approach = 0, sinking = 0;  // [m] without the penalty's share; of the half gap, with it
};

class PressedSphere {
 public:
  explicit PressedSphere(double size, double penaltyFactor = 2.5) : penalty_(2 * penaltyFactor * steel.young / size) {
    blocks_ = {quarterBlock(size)};
    size_ = layOut(blocks_);
    const auto& block = blocks_[0];
    u_.assign(size_, 0.0), free_.assign(size_, 0);
    AlignedVector far(size_, 0.0);
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) {
        const auto p = nodePosition(block, n, s);
        const auto& first = block.section.nodes.front();
        const auto& last = block.section.nodes.back();
        const bool held = s == block.intervals || p[1] > last[0] - 1e-9 || p[2] < first[1] + 1e-9;
        for (int c = 0; c < 3; ++c) {
          const bool symmetric = (c == 0 && s == 0) || (c == 1 && p[1] < 1e-9);
          free_[block.index(n, c, s)] = !held && !symmetric;
          if (held) u_[block.index(n, c, s)] = boussinesq(p)[c];
        }
      }
    diagonal_ = stiffnessDiagonal(block);
    collectPoints();
  }

  // Newton on the closed points, damped: the energy of block, penalty and loaded sphere is convex, and each step goes
  // as far as it falls.
  Hertz press() {
    AlignedVector r = residual();
    for (int round = 0; round < 40; ++round) {
      const double norm = std::sqrt(dot(r, r));
      if (norm < 1e-5 * load) return describe();
      const AlignedVector start = u_, direction = solve(r, 1e-2 * norm);
      const double slope = dot(r, direction);
      for (double share = 1; share > 1e-3; share /= 2) {
        for (std::size_t i = 0; i < size_; ++i) u_[i] = start[i] + share * direction[i];
        r = residual();
        if (dot(r, direction) > -0.5 * slope) break;  // beyond the lowest point by little
      }
    }
    ADD_FAILURE() << "the sphere finds no equilibrium";
    return {};
  }

 private:
  void collectPoints() {
    const auto& block = blocks_[0];
    const auto top = geometry::nodesWhere(
        block.section, [](const geometry::Point2& p) { return std::abs(p[1]) < 1e-12; }, 0);
    const double gauss = 1 / std::sqrt(3.0);
    for (int s = 0; s < block.intervals; ++s)
      for (std::size_t j = 0; j + 1 < top.size(); ++j)
        for (int g = 0; g < 4; ++g) {
          const double u = 0.5 * (1 + (g % 2 ? gauss : -gauss)), v = 0.5 * (1 + (g / 2 ? gauss : -gauss));
          const double x0 = block.positions[s], x1 = block.positions[s + 1];
          const double y0 = block.section.nodes[top[j]][0], y1 = block.section.nodes[top[j + 1]][0];
          if (std::hypot(x0, y0) > 2 * wishedHalfAxis) continue;
          Point p{{block.index(top[j], 2, s), block.index(top[j], 2, s + 1), block.index(top[j + 1], 2, s),
                   block.index(top[j + 1], 2, s + 1)},
                  {(1 - v) * (1 - u), (1 - v) * u, v * (1 - u), v * u},
                  (x1 - x0) * (y1 - y0) / 4,
                  x0 + u * (x1 - x0),
                  y0 + v * (y1 - y0)};
          points_.push_back(p);
        }
  }

  double penetration(const Point& p, double sinking) const {
    double height = 0;
    for (int i = 0; i < 4; ++i) height += p.weight[i] * u_[p.corner[i]];
    return sinking - (p.x * p.x + p.y * p.y) / (4 * radius) + height;
  }

  double force(double sinking) const {
    double sum = 0;
    for (const auto& p : points_) sum += penalty_ * p.area * std::max(0.0, penetration(p, sinking));
    return sum;
  }

  // Forces that are not balanced; the sphere sinks until the penalty carries the load.
  AlignedVector residual() {
    double low = -1e-3, high = 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (force(middle) < load / 4 ? low : high) = middle;
    }
    sinking_ = 0.5 * (low + high);
    AlignedVector r = applySwept(blocks_, u_, "");
    for (double& v : r) v = -v;
    active_.clear();
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const auto& p = points_[k];
      const double overlap = penetration(p, sinking_);
      if (overlap <= 0) continue;
      active_.push_back(k);
      for (int i = 0; i < 4; ++i) r[p.corner[i]] -= penalty_ * p.area * p.weight[i] * overlap;
    }
    for (std::size_t i = 0; i < size_; ++i)
      if (!free_[i]) r[i] = 0;
    return r;
  }

  static double dot(const AlignedVector& a, const AlignedVector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }

  // Stiffness with the closed points and a sphere that is free to sink under constant load: the sphere's unknown is
  // eliminated, S = K + W k W^T - (W k 1)(W k 1)^T / (1^T k 1).
  AlignedVector product(const AlignedVector& x) const {
    AlignedVector f = applySwept(blocks_, x, "");
    double mean = 0, total = 0;
    std::vector<double> lift(active_.size());
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto& p = points_[active_[k]];
      for (int i = 0; i < 4; ++i) lift[k] += p.weight[i] * x[p.corner[i]];
      mean += penalty_ * p.area * lift[k], total += penalty_ * p.area;
    }
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto& p = points_[active_[k]];
      const double push = penalty_ * p.area * (lift[k] - mean / total);
      for (int i = 0; i < 4; ++i) f[p.corner[i]] += p.weight[i] * push;
    }
    for (std::size_t i = 0; i < size_; ++i)
      if (!free_[i]) f[i] = 0;
    return f;
  }

  // Conjugate gradients with the diagonal.
  AlignedVector solve(AlignedVector r, double target) const {
    AlignedVector diagonal(diagonal_.begin(), diagonal_.end()), p(size_, 0.0), z(size_, 0.0), x(size_, 0.0);
    for (const std::size_t k : active_)
      for (int i = 0; i < 4; ++i)
        diagonal[points_[k].corner[i]] += penalty_ * points_[k].area * points_[k].weight[i] * points_[k].weight[i];
    double rz = 0;
    for (int iteration = 0; iteration < 3000; ++iteration) {
      double norm = 0, next = 0;
      for (std::size_t i = 0; i < size_; ++i) {
        z[i] = free_[i] ? r[i] / diagonal[i] : 0;
        norm += r[i] * r[i], next += r[i] * z[i];
      }
      if (std::sqrt(norm) < target) return x;
      for (std::size_t i = 0; i < size_; ++i) p[i] = z[i] + (rz > 0 ? next / rz : 0) * p[i];
      rz = next;
      const AlignedVector q = product(p);
      const double curvature = dot(p, q);
      for (std::size_t i = 0; i < size_; ++i) x[i] += rz / curvature * p[i], r[i] -= rz / curvature * q[i];
    }
    ADD_FAILURE() << "conjugate gradients do not converge";
    return x;
  }

  Hertz describe() const {
    double n = 0, x2 = 0, y2 = 0;
    for (const auto& p : points_) {
      const double f = penalty_ * p.area * std::max(0.0, penetration(p, sinking_));
      n += f, x2 += f * p.x * p.x, y2 += f * p.y * p.y;
    }
    Hertz h;
    h.a = std::sqrt(5 * x2 / n), h.b = std::sqrt(5 * y2 / n);
    h.peak = 3 * 4 * n / (2 * std::acos(-1.0) * h.a * h.b);
    h.sinking = sinking_;
    h.approach = 2 * sinking_ - h.peak / penalty_;  // penalty_ is 2 k
    return h;
  }

  double penalty_, sinking_ = 0;
  std::vector<SweptBlock> blocks_;
  std::size_t size_ = 0;
  AlignedVector u_;
  std::vector<char> free_;
  std::vector<double> diagonal_;
  std::vector<Point> points_;
  std::vector<std::size_t> active_;
};

TEST(Hertz, SphereOnBlock) {
  const double pi = std::acos(-1.0), a = wishedHalfAxis;
  const double peak = 3 * load / (2 * pi * a * a), approach = a * a / radius;
  const double sizes[3] = {0.0026, 0.0013, 0.00065}, tolerance[3] = {0.12, 0.06, 0.03};
  double error[3];
  for (int i = 0; i < 3; ++i) {
    const Hertz found = PressedSphere(sizes[i]).press();
    EXPECT_NEAR(found.a, a, tolerance[i] * a) << sizes[i];
    EXPECT_NEAR(found.b, a, tolerance[i] * a) << sizes[i];
    EXPECT_NEAR(found.peak, peak, tolerance[i] * peak) << sizes[i];
    EXPECT_NEAR(found.approach, approach, tolerance[i] * approach) << sizes[i];
    error[i] = std::abs(found.approach / approach - 1);
    RecordProperty("peak_pressure_error_" + std::to_string(i), std::to_string(found.peak / peak - 1));
  }
  // Order of convergence, seen in the approach, an energy-like mean: second order is usual for it, first is asked for.
  EXPECT_GT(std::log2(error[0] / error[2]) / 2, 1);
}

// What the penalty adds to the approach, from two penalties on one mesh: p0 / 2k each (the mean of the pressure's
// square over its mean, 3/4 p0, less what the widened patch gives back). Tolerance 10 %.
TEST(Hertz, PenaltyAddsHalfThePeakPressureOverItself) {
  const Hertz soft = PressedSphere(0.0013, 2.5).press(), hard = PressedSphere(0.0013, 10).press();
  const double k = steel.young / 0.0013;
  const double expected = soft.peak / (2 * 2.5 * k) - hard.peak / (2 * 10 * k);
  const double found = 2 * (soft.sinking - hard.sinking);
  EXPECT_NEAR(found, expected, 0.1 * expected);
  // Below 4 % of the approach with the shipped penalty at 1.3 mm.
  EXPECT_LT(soft.peak / (2 * 2.5 * k), 0.04 * wishedHalfAxis * wishedHalfAxis / radius);
}

}  // namespace
}  // namespace squat::elasticity
