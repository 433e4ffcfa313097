#include "verification/PressedSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace squat::elasticity {

namespace {

const double pi = std::acos(-1.0);

// From 0 to at least `to`: even steps over the contact, then growing.
std::vector<double> graded(double size, double even, double to) {
  std::vector<double> at{0};
  while (at.back() < even - 1e-9) at.push_back(at.back() + size);
  for (double step = size * 1.25; at.back() < to; step *= 1.25) at.push_back(at.back() + step);
  return at;
}

// The quarter block x, y >= 0, z <= 0, swept along x. Runs of whole vectors, lengths growing from run to run.
SweptBlock quarterBlock(double size, double halfAxis) {
  SweptBlock block;
  block.name = "quarter", block.material = steel;
  const double extent = 5 * halfAxis;
  const auto y = graded(size, 1.5 * halfAxis, extent), depth = graded(size, halfAxis, extent);
  std::vector<double> z;
  for (auto it = depth.rbegin(); it != depth.rend(); ++it) z.push_back(-*it);
  block.section = gridSection(y, z);
  const int even = static_cast<int>(std::ceil(1.5 * halfAxis / size / 8)) * 8;
  block.stations.runs.push_back({even, size});
  double at = even * size;
  for (double length = 1.5 * size; at < extent; length *= 1.5) {
    block.stations.runs.push_back({8, length});
    at += 8 * length;
  }
  return block;
}

// Load along -z on the surface of the half space z < 0, per newton.
Eigen::Vector3d boussinesq(const Eigen::Vector3d& p, double shear) {
  const double nu = steel.poisson, depth = -p[2], rho = p.norm(), scale = 1 / (4 * pi * shear);
  const double lateral = scale * (depth / (rho * rho * rho) - (1 - 2 * nu) / (rho * (rho + depth)));
  const double down = scale * (depth * depth / (rho * rho * rho) + 2 * (1 - nu) / rho);
  return {lateral * p[0], lateral * p[1], -down};
}

// Load along x.
Eigen::Vector3d cerruti(const Eigen::Vector3d& p, double shear) {
  const double nu = steel.poisson, depth = -p[2], rho = p.norm(), scale = 1 / (4 * pi * shear);
  const double cube = rho * rho * rho, far = rho * (rho + depth) * (rho + depth);
  const double along = 1 / rho + p[0] * p[0] / cube + (1 - 2 * nu) * (1 / (rho + depth) - p[0] * p[0] / far);
  const double across = p[0] * p[1] / cube - (1 - 2 * nu) * p[0] * p[1] / far;
  const double down = p[0] * depth / cube + (1 - 2 * nu) * p[0] / (rho * (rho + depth));
  return scale * Eigen::Vector3d(along, across, -down);
}

double dot(const AlignedVector& a, const AlignedVector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

PressedSphere::PressedSphere(const PressedCase& with)
    : with_(with), penalty_(2 * with.penalty * steel.young / with.size) {
  blocks_ = {quarterBlock(with.size, with.halfAxis)};
  size_ = layOut(blocks_);
  diagonal_ = stiffnessDiagonal(blocks_[0]);
  collectPoints();
}

// Frees and fixes unknowns: far faces at a field, symmetry at x = 0 and y = 0 (odd about x = 0 when shifted along x).
void PressedSphere::fixUnknowns(bool shifted, const Field& far) {
  const auto& block = blocks_[0];
  u_.assign(size_, 0.0), free_.assign(size_, 0);
  const auto &first = block.section.nodes.front(), &last = block.section.nodes.back();
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s < block.stationCount; ++s) {
      const auto p = nodePosition(block, n, s);
      const bool fixed = s == block.intervals || p[1] > last[0] - 1e-9 || p[2] < first[1] + 1e-9;
      for (int c = 0; c < 3; ++c) {
        const bool symmetric = (s == 0 && (c == 0) != shifted) || (c == 1 && p[1] < 1e-9);
        free_[block.index(n, c, s)] = !fixed && !symmetric;
        if (fixed && !symmetric) u_[block.index(n, c, s)] = far(p)[c];
      }
    }
}

void PressedSphere::collectPoints() {
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
        if (std::hypot(x0, y0) > 2 * with_.halfAxis) continue;
        Point p{{},
                {(1 - v) * (1 - u), (1 - v) * u, v * (1 - u), v * u},
                (x1 - x0) * (y1 - y0) / 4,
                x0 + u * (x1 - x0),
                y0 + v * (y1 - y0)};
        for (int i = 0; i < 4; ++i)
          for (int d = 0; d < 2; ++d) p.corner[d][i] = block.index(top[j + i / 2], d ? 2 : 0, s + i % 2);
        points_.push_back(p);
      }
}

double PressedSphere::value(const Point& p, int direction, const AlignedVector& u) const {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += p.weight[i] * u[p.corner[direction][i]];
  return sum;
}

double PressedSphere::penetration(const Point& p) const {
  return sinking_ - (p.x * p.x + p.y * p.y) / (4 * with_.radius) + value(p, 1, u_);
}

double PressedSphere::forceAt(double sinking) const {
  double sum = 0;
  for (const auto& p : points_) sum += penalty_ * p.area * std::max(0.0, penetration(p) + sinking - sinking_);
  return sum;
}

// Forces that are not balanced; the sphere sinks until the penalty carries the load.
AlignedVector PressedSphere::residual() {
  double low = -1e-3, high = 1e-3;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (forceAt(middle) < with_.load() / 4 ? low : high) = middle;
  }
  sinking_ = 0.5 * (low + high);
  AlignedVector r = applySwept(blocks_, u_, "");
  for (double& v : r) v = -v;
  active_.clear();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto& p = points_[k];
    const double overlap = penetration(p);
    if (overlap <= 0) continue;
    active_.push_back(k);
    for (int i = 0; i < 4; ++i) r[p.corner[1][i]] -= penalty_ * p.area * p.weight[i] * overlap;
  }
  for (std::size_t i = 0; i < size_; ++i)
    if (!free_[i]) r[i] = 0;
  return r;
}

// Stiffness with the closed points and a sphere that is free to sink under constant load; the sphere's unknown is
// eliminated: K + W k W^T - (W k 1)(W k 1)^T / (1^T k 1).
AlignedVector PressedSphere::product(const AlignedVector& x) const {
  AlignedVector f = applySwept(blocks_, x, "");
  double mean = 0, total = 0;
  for (const std::size_t k : active_) mean += points_[k].area * value(points_[k], 1, x), total += points_[k].area;
  for (const std::size_t k : active_) {
    const auto& p = points_[k];
    const double push = penalty_ * p.area * (value(p, 1, x) - mean / total);
    for (int i = 0; i < 4; ++i) f[p.corner[1][i]] += p.weight[i] * push;
  }
  return f;
}

// Conjugate gradients with the solid's diagonal.
AlignedVector PressedSphere::solve(const Product& matrix, AlignedVector r, double target) const {
  AlignedVector p(size_, 0.0), z(size_, 0.0), x(size_, 0.0);
  double rz = 0;
  for (int iteration = 0; iteration < 5000; ++iteration) {
    if (std::sqrt(dot(r, r)) < target) return x;
    for (std::size_t i = 0; i < size_; ++i) z[i] = free_[i] ? r[i] / diagonal_[i] : 0;
    const double next = dot(r, z);
    for (std::size_t i = 0; i < size_; ++i) p[i] = z[i] + (rz > 0 ? next / rz : 0) * p[i];
    rz = next;
    AlignedVector q = matrix(p);
    for (std::size_t i = 0; i < size_; ++i)
      if (!free_[i]) q[i] = 0;
    const double step = rz / dot(p, q);
    for (std::size_t i = 0; i < size_; ++i) x[i] += step * p[i], r[i] -= step * q[i];
  }
  ADD_FAILURE() << "conjugate gradients do not converge";
  return x;
}

// Newton on the closed points, damped: the energy of block, penalty and loaded sphere is convex, and each step goes as
// far as it falls.
PressedSphere::Pressed PressedSphere::press() {
  fixUnknowns(false, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return with_.load() * boussinesq(p, with_.shearModulus());
  });
  AlignedVector r = residual();
  int round = 0;
  for (double norm = std::sqrt(dot(r, r)); norm > 1e-5 * with_.load(); norm = std::sqrt(dot(r, r))) {
    if (++round > 40) {
      ADD_FAILURE() << "the sphere finds no equilibrium";
      return {};
    }
    const AlignedVector start = u_;
    const AlignedVector direction = solve([&](const AlignedVector& x) { return product(x); }, r, 1e-2 * norm);
    const double slope = dot(r, direction);
    for (double share = 1; share > 1e-3; share /= 2) {
      for (std::size_t i = 0; i < size_; ++i) u_[i] = start[i] + share * direction[i];
      r = residual();
      if (dot(r, direction) > -0.5 * slope) break;  // beyond the lowest point by little
    }
  }
  double n = 0, x2 = 0, y2 = 0;
  pressure_.clear();
  for (const std::size_t k : active_) {
    const auto& p = points_[k];
    pressure_.push_back(penalty_ * penetration(p));
    const double f = p.area * pressure_.back();
    n += f, x2 += f * p.x * p.x, y2 += f * p.y * p.y;
  }
  Pressed found;
  found.a = std::sqrt(5 * x2 / n), found.b = std::sqrt(5 * y2 / n);
  found.peak = 3 * 4 * n / (2 * pi * found.a * found.b);
  found.penaltyShare = found.peak / penalty_;  // p0 / 2k
  found.approach = 2 * sinking_ - found.penaltyShare;
  return found;
}

// The pressure stays as it is (one material: shear and pressure do not disturb each other). Traction grows with the
// relative motion, shift - 2 u of the block, and is returned to the cone; tractions across the shift are small and left
// out, as Cattaneo and Mindlin do. Within a step the set of slipping points is found by repetition.
PressedSphere::Shifted PressedSphere::shift(double distance, double farForce, int steps) {
  const double k = 0.5 * penalty_ * with_.tangentialShare;
  std::vector<double> limit, traction(active_.size(), 0.0), motion(active_.size(), 0.0);
  for (const double pressure : pressure_) limit.push_back(with_.friction * pressure);
  std::vector<char> slips(active_.size(), 0);
  const double stop = 1e-6 * with_.friction * with_.load();
  for (int step = 1; step <= steps; ++step) {
    const double now = distance * step / steps;
    std::vector<double> next(active_.size());
    const AlignedVector last = u_;
    fixUnknowns(true, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return farForce * step / steps * cerruti(p, with_.shearModulus());
    });
    if (step > 1)
      for (std::size_t i = 0; i < size_; ++i)
        if (free_[i]) u_[i] = last[i];
    for (int round = 0; round < 30; ++round) {
      AlignedVector r = applySwept(blocks_, u_, "");
      for (double& v : r) v = -v;
      for (std::size_t j = 0; j < active_.size(); ++j) {
        const auto& p = points_[active_[j]];
        const double pull = slips[j] ? limit[j] : traction[j] + k * (now - 2 * value(p, 0, u_) - motion[j]);
        for (int i = 0; i < 4; ++i) r[p.corner[0][i]] += p.area * p.weight[i] * pull;
      }
      for (std::size_t i = 0; i < size_; ++i)
        if (!free_[i]) r[i] = 0;
      const auto matrix = [&](const AlignedVector& x) {
        AlignedVector f = applySwept(blocks_, x, "");
        for (std::size_t j = 0; j < active_.size(); ++j) {
          if (slips[j]) continue;
          const auto& p = points_[active_[j]];
          const double push = 2 * k * p.area * value(p, 0, x);
          for (int i = 0; i < 4; ++i) f[p.corner[0][i]] += p.weight[i] * push;
        }
        return f;
      };
      const AlignedVector x = solve(matrix, r, stop);
      for (std::size_t i = 0; i < size_; ++i) u_[i] += x[i];
      int changed = 0;
      for (std::size_t j = 0; j < active_.size(); ++j) {
        next[j] = traction[j] + k * (now - 2 * value(points_[active_[j]], 0, u_) - motion[j]);
        const char slipping = next[j] > limit[j];
        changed += slipping != slips[j];
        slips[j] = slipping;
        next[j] = std::min(next[j], limit[j]);
      }
      if (changed == 0) break;
    }
    for (std::size_t j = 0; j < active_.size(); ++j) {
      traction[j] = next[j];
      motion[j] = now - 2 * value(points_[active_[j]], 0, u_);
    }
  }
  Shifted found;
  double stickArea = 0, stickForce = 0;
  for (std::size_t j = 0; j < active_.size(); ++j) {
    const double area = points_[active_[j]].area;
    found.force += 4 * traction[j] * area;
    if (!slips[j]) stickArea += 4 * area, stickForce += 4 * traction[j] * area;
  }
  found.stickRadius = std::sqrt(stickArea / pi);
  found.penaltyShare = stickArea > 0 ? stickForce / stickArea / k : 0;
  return found;
}

}  // namespace squat::elasticity
