#include "receptance/BlockMatrix.h"

#include <algorithm>
#include <set>

namespace squat::receptance {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Complex = std::complex<double>;

int Groups::add(int count) {
  size.push_back(count);
  first.push_back(first.back() + count);
  return static_cast<int>(size.size()) - 1;
}

MatrixXd& BlockMatrix::block(int i, int j) {
  auto [entry, fresh] = rows_[i].try_emplace(j);
  if (fresh) entry->second = MatrixXd::Zero(groups_->size[i], groups_->size[j]);
  return entry->second;
}

void BlockMatrix::addOuter(const std::map<int, Eigen::VectorXd>& pieces, double factor) {
  if (factor == 0) return;
  for (auto a = pieces.begin(); a != pieces.end(); ++a)
    for (auto b = a; b != pieces.end(); ++b)
      block(a->first, b->first).noalias() += factor * a->second * b->second.transpose();
}

MatrixXd BlockMatrix::times(const MatrixXd& vectors) const {
  MatrixXd result = MatrixXd::Zero(vectors.rows(), vectors.cols());
  const auto& g = *groups_;
  for (int i = 0; i < g.count(); ++i)
    for (const auto& [j, m] : rows_[i]) {
      result.middleRows(g.first[i], g.size[i]).noalias() += m * vectors.middleRows(g.first[j], g.size[j]);
      if (j != i)
        result.middleRows(g.first[j], g.size[j]).noalias() += m.transpose() * vectors.middleRows(g.first[i], g.size[i]);
    }
  return result;
}

MatrixXcd BlockMatrix::times(const MatrixXcd& vectors) const {
  MatrixXcd result(vectors.rows(), vectors.cols());
  result.real() = times(MatrixXd(vectors.real()));
  result.imag() = times(MatrixXd(vectors.imag()));
  return result;
}

DynamicStiffness::DynamicStiffness(const BlockMatrix& stiffness, const BlockMatrix& damping, const BlockMatrix& mass)
    : stiffness_(stiffness), damping_(damping), mass_(mass) {
  const auto& g = stiffness.groups();
  std::vector<std::set<int>> about(g.size.size());
  for (const auto* matrix : {&stiffness, &damping, &mass})
    for (int i = 0; i < g.count(); ++i)
      for (const auto& [j, m] : matrix->row(i))
        if (j != i) about[i].insert(j), about[j].insert(i);
  std::vector<char> done(g.size.size(), 0);
  placeInOrder_.assign(g.size.size(), 0);
  const auto unknownsAbout = [&](int i) {
    long sum = 0;
    for (const int j : about[i]) sum += g.size[j];
    return sum;
  };
  std::vector<long> cost;
  for (int i = 0; i < g.count(); ++i) cost.push_back(unknownsAbout(i));
  for (int k = 0; k < g.count(); ++k) {
    int minimum = -1;
    for (int i = 0; i < g.count(); ++i)
      if (!done[i] && (minimum < 0 || cost[i] < cost[minimum])) minimum = i;
    done[minimum] = 1;
    placeInOrder_[minimum] = k;
    order_.push_back(minimum);
    for (const int i : about[minimum]) {
      about[i].erase(minimum);
      for (const int j : about[minimum])
        if (j != i) about[i].insert(j);
    }
    for (const int i : about[minimum]) cost[i] = unknownsAbout(i);
  }
}

BlockFactor DynamicStiffness::factor(double omega) const {
  const auto& g = stiffness_.groups();
  // rows[k]: couplings of the group eliminated k-th with later ones, its own unknowns along the rows.
  std::vector<std::map<int, MatrixXcd>> rows(g.size.size());
  std::vector<MatrixXcd> pivot(g.size.size());
  for (int i = 0; i < g.count(); ++i) pivot[placeInOrder_[i]] = MatrixXcd::Zero(g.size[i], g.size[i]);
  const auto add = [&](const BlockMatrix& matrix, Complex factor) {
    for (int i = 0; i < g.count(); ++i)
      for (const auto& [j, m] : matrix.row(i)) {
        const int k = placeInOrder_[i], l = placeInOrder_[j];
        if (k == l) {
          pivot[k] += factor * m;
          continue;
        }
        auto [entry, fresh] = rows[std::min(k, l)].try_emplace(std::max(k, l));
        auto& to = entry->second;
        if (fresh) to = MatrixXcd::Zero(g.size[order_[std::min(k, l)]], g.size[order_[std::max(k, l)]]);
        if (k < l)
          to += factor * m;
        else
          to += factor * m.transpose();
      }
  };
  add(stiffness_, 1), add(damping_, Complex(0, omega)), add(mass_, -omega * omega);

  BlockFactor result;
  result.groups_ = &g, result.order_ = order_;
  result.pivot_.resize(g.size.size()), result.later_.resize(g.size.size()), result.solved_.resize(g.size.size());
  for (int k = 0; k < g.count(); ++k) {
    result.pivot_[k].compute(pivot[k]);
    pivot[k].resize(0, 0);
    Eigen::Index width = 0;
    for (const auto& [l, m] : rows[k]) width += m.cols(), result.later_[k].push_back(l);
    MatrixXcd side(result.pivot_[k].rows(), width);
    Eigen::Index at = 0;
    for (const auto& [l, m] : rows[k]) side.middleCols(at, m.cols()) = m, at += m.cols();
    // The last group couples with no later one: Eigen's solver reads an element even of an empty right side.
    result.solved_[k] = width > 0 ? MatrixXcd(result.pivot_[k].solve(side)) : side;
    Eigen::Index column = 0;
    for (auto a = rows[k].begin(); a != rows[k].end(); ++a) {
      const auto& [l, m] = *a;
      // One product for this row of what is taken from the later groups.
      const MatrixXcd taken = m.transpose() * result.solved_[k].rightCols(width - column);
      Eigen::Index other = 0;
      for (auto b = a; b != rows[k].end(); ++b) {
        const Eigen::Index wide = b->second.cols();
        auto& to = a == b ? pivot[l] : rows[l][b->first];
        if (to.size() == 0) to = MatrixXcd::Zero(m.cols(), wide);
        to -= taken.middleCols(other, wide);
        other += wide;
      }
      column += m.cols();
    }
    rows[k].clear();
  }
  return result;
}

MatrixXcd BlockFactor::solve(const MatrixXcd& right) const {
  const auto& g = *groups_;
  MatrixXcd x = right;
  const auto part = [&](int k) { return x.middleRows(g.first[order_[k]], g.size[order_[k]]); };
  for (int k = 0; k < g.count(); ++k) {
    const MatrixXcd taken = solved_[k].transpose() * part(k);
    Eigen::Index at = 0;
    for (const int l : later_[k]) part(l) -= taken.middleRows(at, g.size[order_[l]]), at += g.size[order_[l]];
    part(k) = pivot_[k].solve(MatrixXcd(part(k)));
  }
  for (int k = g.count() - 1; k >= 0; --k) {
    MatrixXcd others(solved_[k].cols(), x.cols());
    Eigen::Index at = 0;
    for (const int l : later_[k]) others.middleRows(at, g.size[order_[l]]) = part(l), at += g.size[order_[l]];
    part(k) -= solved_[k] * others;
  }
  return x;
}

std::vector<MatrixXcd> DynamicStiffness::taylor(const BlockFactor& factor, double omega, const MatrixXd& load,
                                                int order, double reach) const {
  std::vector<MatrixXcd> terms{factor.solve(load.cast<Complex>())};
  for (int k = 1; k <= order; ++k) {
    MatrixXcd right = 2 * omega * reach * mass_.times(terms[k - 1]) - Complex(0, reach) * damping_.times(terms[k - 1]);
    if (k > 1) right += reach * reach * mass_.times(terms[k - 2]);
    terms.push_back(factor.solve(right));
  }
  return terms;
}

double DynamicStiffness::residual(double omega, const MatrixXcd& x, const MatrixXd& load) const {
  const MatrixXd re = x.real(), im = x.imag();
  const MatrixXd real = stiffness_.times(re) - omega * omega * mass_.times(re) - omega * damping_.times(im) - load;
  const MatrixXd imaginary = stiffness_.times(im) - omega * omega * mass_.times(im) + omega * damping_.times(re);
  double largest = 0;
  for (Eigen::Index c = 0; c < load.cols(); ++c)
    largest = std::max(largest, std::hypot(real.col(c).norm(), imaginary.col(c).norm()) / load.col(c).norm());
  return largest;
}

}  // namespace squat::receptance
