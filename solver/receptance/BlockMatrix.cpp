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

DynamicStiffness::DynamicStiffness(std::vector<HarmonicTerm> terms, std::vector<int> kept)
    : terms_(std::move(terms)), groups_(terms_.front().matrix->groups()) {
  const auto& g = groups_;
  std::vector<std::set<int>> about(g.size.size());
  for (const auto& term : terms_)
    for (int i = 0; i < g.count(); ++i)
      for (const auto& [j, m] : term.matrix->row(i))
        if (j != i) about[i].insert(j), about[j].insert(i);
  eliminated_ = g.count() - static_cast<int>(kept.size());
  std::vector<char> done(g.size.size(), 0);
  placeInOrder_.assign(g.size.size(), 0);
  const auto unknownsAbout = [&](int i) {
    long sum = 0;
    for (const int j : about[i]) sum += g.size[j];
    return sum;
  };
  std::vector<long> cost;
  for (int i = 0; i < g.count(); ++i) cost.push_back(unknownsAbout(i));
  for (std::size_t i = 0; i < kept.size(); ++i)
    done[kept[i]] = 1, placeInOrder_[kept[i]] = eliminated_ + static_cast<int>(i);
  for (int k = 0; k < eliminated_; ++k) {
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
  order_.insert(order_.end(), kept.begin(), kept.end());
}

BlockFactor DynamicStiffness::eliminate(double omega) const {
  const auto& g = groups_;
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
  for (const auto& term : terms_) add(*term.matrix, term.factor(omega));

  BlockFactor result;
  result.groups_ = &g, result.order_ = order_;
  result.pivot_.resize(g.size.size()), result.later_.resize(g.size.size()), result.solved_.resize(g.size.size());
  for (int k = 0; k < eliminated_; ++k) {
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
  if (eliminated_ < g.count()) result.kept_ = keptOf(pivot, rows);
  return result;
}

// What is left of the kept groups, as one dense matrix.
MatrixXcd DynamicStiffness::keptOf(const std::vector<MatrixXcd>& pivot,
                                   const std::vector<std::map<int, MatrixXcd>>& rows) const {
  std::vector<Eigen::Index> first{0};
  for (int k = eliminated_; k < groups_.count(); ++k) first.push_back(first.back() + groups_.size[order_[k]]);
  MatrixXcd all = MatrixXcd::Zero(first.back(), first.back());
  for (int k = eliminated_; k < groups_.count(); ++k) {
    const auto at = first[k - eliminated_];
    all.block(at, at, pivot[k].rows(), pivot[k].cols()) = pivot[k];
    for (const auto& [l, m] : rows[k]) {
      all.block(at, first[l - eliminated_], m.rows(), m.cols()) = m;
      all.block(first[l - eliminated_], at, m.cols(), m.rows()) = m.transpose();
    }
  }
  return all;
}

CondensedSystem DynamicStiffness::condense(double omega, const MatrixXd& loads) const {
  const auto factor = eliminate(omega);
  CondensedSystem condensed;
  condensed.stiffness = factor.kept_;
  MatrixXcd x = loads.cast<Complex>();
  const auto part = [&](int k) { return x.middleRows(groups_.first[order_[k]], groups_.size[order_[k]]); };
  condensed.between = MatrixXcd::Zero(x.cols(), x.cols());
  for (int k = 0; k < eliminated_; ++k) {
    const MatrixXcd own = part(k);
    if (own.isZero(0)) continue;
    condensed.between += own.transpose() * factor.pivot_[k].solve(own);
    const MatrixXcd taken = factor.solved_[k].transpose() * own;
    Eigen::Index at = 0;
    for (const int l : factor.later_[k])
      part(l) -= taken.middleRows(at, groups_.size[order_[l]]), at += groups_.size[order_[l]];
  }
  condensed.loads.resize(condensed.stiffness.rows(), x.cols());
  Eigen::Index at = 0;
  for (int k = eliminated_; k < groups_.count(); ++k) {
    condensed.loads.middleRows(at, groups_.size[order_[k]]) = part(k);
    at += groups_.size[order_[k]];
  }
  return condensed;
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

namespace {

// First derivative and half the second one of a factor, by central differences: exact but for round-off of what is
// quadratic.
std::pair<Complex, Complex> derivatives(const HarmonicTerm& term, double omega) {
  const double step = 1e-3 * omega;
  const Complex before = term.factor(omega - step), here = term.factor(omega), behind = term.factor(omega + step);
  return {(behind - before) / (2 * step), (behind - 2.0 * here + before) / (2 * step * step)};
}

}  // namespace

std::vector<MatrixXcd> DynamicStiffness::taylor(const BlockFactor& factor, double omega, const MatrixXd& load,
                                                int order, double reach) const {
  std::vector<MatrixXcd> terms{factor.solve(load.cast<Complex>())};
  for (int k = 1; k <= order; ++k) {
    MatrixXcd right = MatrixXcd::Zero(load.rows(), load.cols());
    for (const auto& term : terms_) {
      const auto [first, second] = derivatives(term, omega);
      if (first != 0.0) right -= reach * first * term.matrix->times(terms[k - 1]);
      if (k > 1 && second != 0.0) right -= reach * reach * second * term.matrix->times(terms[k - 2]);
    }
    terms.push_back(factor.solve(right));
  }
  return terms;
}

double DynamicStiffness::residual(double omega, const MatrixXcd& x, const MatrixXd& load) const {
  MatrixXcd rest = -load.cast<Complex>();
  for (const auto& term : terms_) rest += term.factor(omega) * term.matrix->times(x);
  double largest = 0;
  for (Eigen::Index c = 0; c < load.cols(); ++c) largest = std::max(largest, rest.col(c).norm() / load.col(c).norm());
  return largest;
}

}  // namespace squat::receptance
