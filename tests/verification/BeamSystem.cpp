#include "verification/BeamSystem.h"

#include <Eigen/SparseLU>
#include <algorithm>

namespace squat::verification {

int BeamSystem::add(int count) {
  unknowns_ += count;
  return unknowns_ - count;
}

void BeamSystem::addElement(Entries& to, const int (&at)[4], const double (&matrix)[4][4], double factor) {
  if (factor == 0) return;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) to.emplace_back(at[i], at[j], factor * matrix[i][j]);
}

void BeamSystem::addBeam(int left, int slopeLeft, int right, int slopeRight, double l, double bending, double shear,
                         double lineMass, double rotaryMass) {
  const double phi = 12 * bending / (shear * l * l);
  const double k[4][4] = {{12, 6 * l, -12, 6 * l},
                          {6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l},
                          {-12, -6 * l, 12, -6 * l},
                          {6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l}};
  addElement(stiffness_, {left, slopeLeft, right, slopeRight}, k, bending / (l * l * l * (1 + phi)));
  for (const int i : {left, right}) addMass({{i, 1}}, 0.5 * l * lineMass);
  for (const int i : {slopeLeft, slopeRight}) addMass({{i, 1}}, 0.5 * l * rotaryMass);
}

void BeamSystem::addTwist(int left, int rateLeft, int right, int rateRight, double l, double torsion, double warping,
                          double rotaryMass) {
  const int at[4] = {left, rateLeft, right, rateRight};
  const double bent[4][4] = {
      {12, 6 * l, -12, 6 * l},
      {6 * l, 4 * l * l, -6 * l, 2 * l * l},
      {-12, -6 * l, 12, -6 * l},
      {6 * l, 2 * l * l, -6 * l, 4 * l * l},
  };
  const double turned[4][4] = {
      {36, 3 * l, -36, 3 * l},
      {3 * l, 4 * l * l, -3 * l, -l * l},
      {-36, -3 * l, 36, -3 * l},
      {3 * l, -l * l, -3 * l, 4 * l * l},
  };
  addElement(stiffness_, at, bent, warping / (l * l * l));
  addElement(stiffness_, at, turned, torsion / (30 * l));
  for (const int i : {left, right}) addMass({{i, 1}}, 0.5 * l * rotaryMass);
}

void BeamSystem::addBar(int left, int right, double length, double stiffness, double lineMass) {
  addSpring({{left, 1}, {right, -1}}, stiffness / length, 0);
  for (const int i : {left, right}) addMass({{i, 1}}, 0.5 * length * lineMass);
}

void BeamSystem::addSpring(const Terms& terms, double stiffness, double damping) {
  for (const auto& [i, a] : terms)
    for (const auto& [j, b] : terms) {
      if (stiffness != 0) stiffness_.emplace_back(i, j, a * b * stiffness);
      if (damping != 0) damping_.emplace_back(i, j, a * b * damping);
    }
}

void BeamSystem::addMass(const Terms& terms, double mass) {
  for (const auto& [i, a] : terms)
    for (const auto& [j, b] : terms) mass_.emplace_back(i, j, a * b * mass);
}

void BeamSystem::addGapSpring(const Terms& terms, double stiffness, double gap) {
  gapSprings_.push_back({terms, stiffness, gap});
}

double BeamSystem::GapSpring::compression(const Eigen::VectorXd& displacement) const {
  double q = 0;
  for (const auto& [i, weight] : terms) q += weight * displacement[i];
  return -q - gap;
}

Eigen::VectorXd BeamSystem::atRest(const Eigen::VectorXd& load) const {
  std::vector<char> closed(gapSprings_.size(), 1);
  Eigen::VectorXd displacement;
  for (int k = 0; k < 30; ++k) {
    auto entries = stiffness_;
    Eigen::VectorXd all = load;
    for (std::size_t g = 0; g < closed.size(); ++g) {
      if (!closed[g]) continue;
      const auto& spring = gapSprings_[g];
      for (const auto& [i, a] : spring.terms) {
        all[i] -= a * spring.stiffness * spring.gap;
        for (const auto& [j, b] : spring.terms) entries.emplace_back(i, j, a * b * spring.stiffness);
      }
    }
    Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    displacement = Eigen::SparseLU<Eigen::SparseMatrix<double>>(matrix).solve(all);
    const auto before = closed;
    for (std::size_t g = 0; g < closed.size(); ++g) closed[g] = gapSprings_[g].compression(displacement) > 0;
    if (closed == before) break;
  }
  return displacement;
}

double BeamSystem::gapLoad(const Eigen::VectorXd& displacement) const {
  double sum = 0;
  for (const auto& spring : gapSprings_) sum += spring.stiffness * std::max(0.0, spring.compression(displacement));
  return sum;
}

std::vector<std::complex<double>> BeamSystem::answers(const Eigen::MatrixXd& shapes, double omega) const {
  const Eigen::MatrixXcd all = transfers(shapes, omega);
  const Eigen::VectorXcd own = all.diagonal();
  return {own.begin(), own.end()};
}

Eigen::MatrixXcd BeamSystem::transfers(const Eigen::MatrixXd& shapes, std::complex<double> omega) const {
  const std::complex<double> i(0, 1);
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  for (const auto& e : stiffness_) entries.emplace_back(e.row(), e.col(), e.value());
  for (const auto& e : damping_) entries.emplace_back(e.row(), e.col(), i * omega * e.value());
  for (const auto& e : mass_) entries.emplace_back(e.row(), e.col(), -omega * omega * e.value());
  Eigen::SparseMatrix<std::complex<double>> dynamic(unknowns_, unknowns_);
  dynamic.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<std::complex<double>>> factor(dynamic);
  const Eigen::MatrixXcd forces = shapes.cast<std::complex<double>>();
  return forces.transpose() * factor.solve(forces);
}

}  // namespace squat::verification
