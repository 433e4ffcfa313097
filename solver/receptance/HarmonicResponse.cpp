#include "receptance/HarmonicResponse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace squat::receptance {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr int taylorOrder = 4;
// Share of a vector outside the basis that is left out: far below the tolerance, and keeps the basis small.
constexpr double negligible = 1e-4;

double angular(double frequency) { return 2 * std::numbers::pi * frequency; }

// The system projected on a growing orthonormal basis.
class Projection {
 public:
  Projection(const std::vector<HarmonicTerm>& terms, const MatrixXd& loads, const MatrixXd& responses)
      : terms_(terms), loads_(loads), responses_(responses), projected_(terms.size()) {}

  void add(const MatrixXcd& solution) {
    MatrixXd fresh(solution.rows(), 0);
    for (Index c = 0; c < 2 * solution.cols(); ++c) {
      VectorXd v = c % 2 ? VectorXd(solution.col(c / 2).imag()) : VectorXd(solution.col(c / 2).real());
      const double whole = v.norm();
      for (int twice = 0; twice < 2; ++twice) {
        if (basis_.cols() > 0) v -= basis_ * (basis_.transpose() * v);
        if (fresh.cols() > 0) v -= fresh * (fresh.transpose() * v);
      }
      if (!(v.norm() > negligible * whole)) continue;  // nothing new, or nothing at all
      fresh.conservativeResize(Eigen::NoChange, fresh.cols() + 1);
      fresh.rightCols(1) = v.normalized();
    }
    if (fresh.cols() == 0) return;
    basis_.conservativeResize(fresh.rows(), basis_.cols() + fresh.cols());
    basis_.rightCols(fresh.cols()) = fresh;
    for (std::size_t t = 0; t < terms_.size(); ++t) border(*terms_[t].matrix, projected_[t]);
    load_ = basis_.transpose() * loads_, response_ = basis_.transpose() * responses_;
  }

  VectorXcd at(double omega) const {
    MatrixXcd dynamic = MatrixXcd::Zero(basis_.cols(), basis_.cols());
    for (std::size_t t = 0; t < terms_.size(); ++t) dynamic += terms_[t].factor(omega) * projected_[t];
    const MatrixXcd x = dynamic.partialPivLu().solve(load_.cast<Complex>());
    return (response_.cast<Complex>().cwiseProduct(x)).colwise().sum().transpose();
  }

 private:
  // Completes the projected matrix for the columns that the basis has gained.
  void border(const BlockMatrix& matrix, MatrixXd& projected) const {
    const Index old = projected.rows(), all = basis_.cols();
    const MatrixXd gained = basis_.transpose() * matrix.times(MatrixXd(basis_.rightCols(all - old)));
    projected.conservativeResize(all, all);
    projected.rightCols(all - old) = gained;
    projected.bottomRows(all - old) = gained.transpose();
  }

  const std::vector<HarmonicTerm>& terms_;
  const MatrixXd &loads_, &responses_;
  MatrixXd basis_, load_, response_;
  std::vector<MatrixXd> projected_;  // one a term
};

struct Stretch {
  double from = 0, to = 0;
  double middle() const { return 0.5 * (from + to); }
};

// One row a load, one value a frequency.
std::vector<std::vector<Complex>> evaluate(const Projection& projection, Index loads,
                                           const std::vector<double>& frequencies, ThreadTeam& team) {
  std::vector<std::vector<Complex>> values(static_cast<std::size_t>(loads), std::vector<Complex>(frequencies.size()));
  team.run([&](int index) {
    for (std::size_t f = static_cast<std::size_t>(index); f < frequencies.size();
         f += static_cast<std::size_t>(team.size())) {
      const VectorXcd at = projection.at(angular(frequencies[f]));
      for (Index p = 0; p < at.size(); ++p) values[static_cast<std::size_t>(p)][f] = at[p];
    }
  });
  return values;
}

// Largest relative difference, over the loads, between what the projection predicts and a direct solution.
double differenceOf(const VectorXcd& predicted, const MatrixXcd& solution, const MatrixXd& responses) {
  double difference = 0;
  for (Index p = 0; p < predicted.size(); ++p) {
    const Complex direct = (responses.col(p).cast<Complex>().cwiseProduct(solution.col(p))).sum();
    difference = std::max(difference, std::abs(predicted[p] - direct) / std::abs(direct));
  }
  return difference;
}

}  // namespace

HarmonicResponse harmonicResponse(const std::vector<HarmonicTerm>& terms, const MatrixXd& loads,
                                  const MatrixXd& responses, const std::vector<double>& frequencies,
                                  const HarmonicOptions& options, ThreadTeam& team, Monitor& monitor) {
  HarmonicResponse result;
  const DynamicStiffness system(terms);
  Projection projection(terms, loads, responses);
  const double lowest = frequencies.front(), highest = frequencies.back();
  const double reach = angular(highest - lowest) / (2 * options.firstStretches);
  const auto reportProgress = [&](double fraction) {
    Progress progress;
    progress.phase = "receptance", progress.fraction = fraction;
    monitor.report(progress);
  };
  // Solves directly at all given frequencies, some at a time on each thread.
  const auto solveAt = [&](const std::vector<double>& at) {
    std::vector<std::vector<MatrixXcd>> solutions(at.size());
    std::vector<double> residuals(at.size(), 0.0);
    const auto threads = static_cast<std::size_t>(team.size());
    for (std::size_t done = 0; done < at.size() && !monitor.cancelled(); done += threads) {
      team.run([&](int index) {
        const std::size_t i = done + static_cast<std::size_t>(index);
        if (i >= at.size()) return;
        const double omega = angular(at[i]);
        solutions[i] = system.taylor(system.factor(omega), omega, loads, taylorOrder, reach);
        residuals[i] = system.residual(omega, solutions[i].front(), loads);
      });
      result.solutions += static_cast<int>(std::min(threads, at.size() - done));
      // About four solutions for each of the first stretches, as it turns out.
      reportProgress(std::min(0.95, result.solutions / (4.0 * options.firstStretches)));
    }
    for (const double r : residuals) result.largestResidual = std::max(result.largestResidual, r);
    return solutions;
  };

  std::vector<double> ends;
  for (int i = 0; i <= options.firstStretches; ++i)
    ends.push_back(lowest + (highest - lowest) * i / options.firstStretches);
  const auto first = solveAt(ends);
  std::vector<Stretch> open;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) open.push_back({ends[i], ends[i + 1]});
  if (!monitor.cancelled())
    for (const auto& solution : first)
      for (const auto& term : solution) projection.add(term);
  while (!open.empty() && !monitor.cancelled()) {
    std::vector<double> middles;
    for (const auto& stretch : open) middles.push_back(stretch.middle());
    const auto solutions = solveAt(middles);
    if (monitor.cancelled()) break;
    std::vector<Stretch> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const double difference = differenceOf(projection.at(angular(middles[i])), solutions[i].front(), responses);
      if (difference > options.tolerance && result.solutions < options.maximumSolutions) {
        next.push_back({open[i].from, middles[i]}), next.push_back({middles[i], open[i].to});
      } else {
        result.largestDifference = std::max(result.largestDifference, difference);
      }
    }
    for (const auto& solution : solutions)
      for (const auto& term : solution) projection.add(term);
    open = std::move(next);
  }
  if (monitor.cancelled()) {
    result.cancelled = true;
    return result;
  }
  result.values = evaluate(projection, loads.cols(), frequencies, team);
  reportProgress(1);
  return result;
}

}  // namespace squat::receptance
