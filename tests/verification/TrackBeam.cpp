#include "verification/TrackBeam.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace squat::verification {

TrackBeam::TrackBeam(const cases::CaseDescription& d, const BeamSection& section, double railStart,
                     const std::vector<double>& sleeperPositions)
    : gravity_(d.motion.gravity) {
  constexpr int alongRail = 6, acrossRail = 4;
  const auto& pad = d.pad;
  const auto padOffset = [&](int p) { return ((p + 0.5) / alongRail - 0.5) * pad.length; };
  // Rail nodes: a fine grid and every pad spring.
  const double end = railStart + d.track.length;
  for (int i = 0; i <= 400; ++i) railX_.push_back(railStart + d.track.length * i / 400);
  for (const double x : sleeperPositions)
    for (int p = 0; p < alongRail; ++p) railX_.push_back(std::clamp(x + padOffset(p), railStart, end));
  std::sort(railX_.begin(), railX_.end());
  railX_.erase(std::unique(railX_.begin(), railX_.end(), [](double a, double b) { return b - a < 1e-6; }),
               railX_.end());
  const int nodes = static_cast<int>(railX_.size());
  unknowns_ = 3 * nodes;  // u, w, slope

  const auto& steel = d.rail.material;
  const double shearModulus = steel.young / 2 / (1 + steel.poisson);
  for (int i = 0; i + 1 < nodes; ++i) {
    const double length = railX_[i + 1] - railX_[i];
    addBeam(3 * i + 1, 3 * i + 2, 3 * i + 4, 3 * i + 5, length, steel.young * section.inertia,
            section.shearCoefficient * section.area * shearModulus, steel.density * section.area,
            steel.density * section.inertia);
    addSpring({{3 * i, 1}, {3 * i + 3, -1}}, steel.young * section.area / length, 0);
    for (const int node : {i, i + 1}) {
      mass_.emplace_back(3 * node, 3 * node, 0.5 * steel.density * section.area * length);
      addWeight(3 * node + 1, 0.5 * steel.density * section.area * length);
    }
  }

  const auto& s = d.sleeper;
  const double area = s.width * s.height, inertia = s.width * std::pow(s.height, 3) / 12;
  const double concreteShear = s.material.young / 2 / (1 + s.material.poisson);
  constexpr int parts = 72;
  const double step = s.halfLength / parts;
  for (const double x : sleeperPositions) {
    const int first = unknowns_, slide = first + 2 * (parts + 1), rock = slide + 1;
    unknowns_ = rock + 1;
    const auto w = [&](int j) { return first + 2 * j; };
    for (int j = 0; j < parts; ++j) {
      addBeam(w(j), w(j) + 1, w(j + 1), w(j + 1) + 1, step, s.material.young * inertia, 5.0 / 6 * area * concreteShear,
              s.material.density * area, s.material.density * inertia);
      addWeight(w(j), 0.5 * s.material.density * area * step),
          addWeight(w(j + 1), 0.5 * s.material.density * area * step);
    }
    addSpring({{w(0) + 1, 1}}, 1e15, 0);  // symmetry plane: no slope
    const double mass = s.material.density * area * s.halfLength;
    // About the middle of its height; slide is that of the top.
    mass_.emplace_back(slide, slide, mass);
    mass_.emplace_back(slide, rock, mass * s.height / 2), mass_.emplace_back(rock, slide, mass * s.height / 2);
    mass_.emplace_back(rock, rock, mass * (s.height * s.height / 3 + s.width * s.width / 12));
    // Ballast: evenly under the base. Across: three strips for the rocking stiffness, exact for the second moment.
    for (int j = 0; j <= parts; ++j) {
      const double share = (j == 0 || j == parts ? 0.5 : 1.0) / parts;
      for (const double side : {-0.5, 0.5}) {
        const double offset = side * s.width / std::sqrt(3.0);
        addSpring({{w(j), 1}, {rock, offset}}, 0.5 * share * d.ballast.stiffness, 0.5 * share * d.ballast.damping);
      }
      addSpring({{slide, 1}, {rock, s.height}}, share * d.ballast.longitudinalStiffness,
                share * d.ballast.longitudinalDamping);
    }
    for (int p = 0; p < alongRail; ++p) {
      const int rail = 3 * railNode(x + padOffset(p));
      for (int q = 0; q < acrossRail; ++q) {
        const double y = ((q + 0.5) / acrossRail - 0.5) * pad.width;
        const double at = (y + d.wheelset.trackCentre) / step;
        const int j = std::clamp(static_cast<int>(at), 0, parts - 1);
        const double t = at - j, share = 1.0 / (alongRail * acrossRail);
        addSpring({{rail + 1, 1}, {w(j), t - 1}, {w(j + 1), -t}, {rock, -padOffset(p)}}, share * pad.stiffness,
                  share * pad.damping);
        addSpring({{rail, 1}, {rail + 2, section.centroidAboveBase}, {slide, -1}}, share * pad.longitudinalStiffness,
                  share * pad.longitudinalDamping);
      }
    }
  }
}

void TrackBeam::addBeam(int w0, int slope0, int w1, int slope1, double l, double bending, double shear, double lineMass,
                        double rotaryMass) {
  const double phi = 12 * bending / (shear * l * l), f = bending / (l * l * l * (1 + phi));
  const int at[4] = {w0, slope0, w1, slope1};
  const double k[4][4] = {{12, 6 * l, -12, 6 * l},
                          {6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l},
                          {-12, -6 * l, 12, -6 * l},
                          {6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) stiffness_.emplace_back(at[i], at[j], f * k[i][j]);
  // Lumped; elements are short against every wave that is looked at.
  for (int i = 0; i < 4; ++i) mass_.emplace_back(at[i], at[i], 0.5 * l * (i % 2 ? rotaryMass : lineMass));
}

void TrackBeam::addSpring(const Terms& terms, double stiffness, double damping) {
  for (const auto& [i, a] : terms)
    for (const auto& [j, b] : terms) {
      stiffness_.emplace_back(i, j, a * b * stiffness);
      if (damping != 0) damping_.emplace_back(i, j, a * b * damping);
    }
}

void TrackBeam::addWeight(int unknown, double mass) { weights_.emplace_back(unknown, mass); }

int TrackBeam::railNode(double x) const {
  const auto next = std::lower_bound(railX_.begin(), railX_.end(), x - 2e-6);
  return std::min(static_cast<int>(next - railX_.begin()), static_cast<int>(railX_.size()) - 1);
}

// Hermite interpolation of the deflection.
Eigen::VectorXd TrackBeam::railShape(double x) const {
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(unknowns_);
  int i = static_cast<int>(std::upper_bound(railX_.begin(), railX_.end(), x) - railX_.begin()) - 1;
  i = std::clamp(i, 0, static_cast<int>(railX_.size()) - 2);
  const double l = railX_[i + 1] - railX_[i], t = (x - railX_[i]) / l;
  shape[3 * i + 1] = 1 - 3 * t * t + 2 * t * t * t, shape[3 * i + 4] = 3 * t * t - 2 * t * t * t;
  shape[3 * i + 2] = l * (t - 2 * t * t + t * t * t), shape[3 * i + 5] = l * (t * t * t - t * t);
  return shape;
}

double TrackBeam::deflection(double x, double loadX, double force, bool withWeight) const {
  Eigen::SparseMatrix<double> k(unknowns_, unknowns_);
  k.setFromTriplets(stiffness_.begin(), stiffness_.end());
  Eigen::VectorXd load = -force * railShape(loadX);
  if (withWeight)
    for (const auto& [unknown, mass] : weights_) load[unknown] -= mass * gravity_;
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(k);
  const Eigen::VectorXd u = factor.solve(load);
  return railShape(x).dot(u);
}

std::complex<double> TrackBeam::receptance(double x, double frequency) const {
  const double omega = 2 * std::acos(-1.0) * frequency;
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  for (const auto& e : stiffness_) entries.emplace_back(e.row(), e.col(), e.value());
  for (const auto& e : damping_) entries.emplace_back(e.row(), e.col(), std::complex<double>(0, omega * e.value()));
  for (const auto& e : mass_) entries.emplace_back(e.row(), e.col(), -omega * omega * e.value());
  Eigen::SparseMatrix<std::complex<double>> dynamic(unknowns_, unknowns_);
  dynamic.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<std::complex<double>>> factor(dynamic);
  const Eigen::VectorXcd shape = railShape(x).cast<std::complex<double>>();
  const Eigen::VectorXcd u = factor.solve(shape);
  return shape.dot(u);
}

}  // namespace squat::verification
