#include "estimation/ProfileSearch.h"

#include <algorithm>
#include <cmath>

namespace squat::estimation {

namespace {

constexpr double bridged =
    0.1;  // of the wheel's curvature: deviation of what a hollow may have more, by the flat contact
constexpr double difference = 3e-6;  // [m] of each height for the derivatives: a hundredth of a defect

}  // namespace

ProfileSearch::ProfileSearch(const SmoothProfile& profile, const std::vector<ComparedPassage>& passages,
                             ProfileRuns& runs, double radius, int maximumRuns)
    : profile_(profile),
      passages_(passages),
      runs_(runs),
      smallest_(0.05 / radius),
      largest_(2 / radius),
      followed_(1 / radius),
      maximumRuns_(maximumRuns) {
  const auto shifts = static_cast<Eigen::Index>(passages.size()) - 1;
  const auto& curvature = profile.curvature();
  penalty_ = Eigen::MatrixXd::Zero(curvature.rows(), curvature.cols() + shifts);
  penalty_.leftCols(curvature.cols()) = curvature;
}

std::vector<double> ProfileSearch::shiftsOf(const Eigen::VectorXd& unknowns) const {
  std::vector<double> shifts{firstShift_};
  for (Eigen::Index i = profile_.unknowns(); i < unknowns.size(); ++i) shifts.push_back(unknowns[i]);
  return shifts;
}

std::vector<double> ProfileSearch::shifts() const { return shiftsOf(best_.unknowns); }

SearchState ProfileSearch::stateFrom(const Eigen::VectorXd& unknowns, const Response& response) const {
  SearchState state;
  state.unknowns = unknowns;
  if (!response) return state;
  state.isRun = true;
  state.computed = *response;
  const auto shifts = shiftsOf(unknowns);
  std::vector<Eigen::VectorXd> parts;
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    parts.push_back(residualsOf(passages_[i], (*response)[passages_[i].model], shifts[i]));
    count += parts.back().size();
  }
  state.residuals.resize(count);
  Eigen::Index at = 0;
  for (const auto& part : parts) state.residuals.segment(at, part.size()) = part, at += part.size();
  return state;
}

std::vector<SearchState> ProfileSearch::statesAt(const std::vector<Eigen::VectorXd>& unknowns) {
  std::vector<ProfilePoints> profiles;
  for (const auto& each : unknowns) profiles.push_back(profile_.points(each.head(profile_.unknowns())));
  const auto responses = runs_.all(profiles);
  std::vector<SearchState> states;
  for (std::size_t i = 0; i < unknowns.size(); ++i) states.push_back(stateFrom(unknowns[i], responses[i]));
  return states;
}

// One run for each height; shifts cost none.
bool ProfileSearch::findSlope() {
  std::vector<Eigen::VectorXd> about;
  for (Eigen::Index k = 0; k < profile_.unknowns(); ++k) {
    about.push_back(best_.unknowns);
    about.back()[k] -= difference;
  }
  const auto states = statesAt(about);
  if (runs_.isCancelled()) return false;
  slope_ = Eigen::MatrixXd::Zero(best_.residuals.size(), best_.unknowns.size());
  for (Eigen::Index k = 0; k < profile_.unknowns(); ++k) {
    const auto& state = states[static_cast<std::size_t>(k)];
    if (state.isRun) slope_.col(k) = (best_.residuals - state.residuals) / difference;
  }
  const auto shifts = shiftsOf(best_.unknowns);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    const auto part = slopeOfShift(passages_[i], shifts[i]);
    if (i > 0) slope_.col(profile_.unknowns() + static_cast<Eigen::Index>(i) - 1).segment(row, part.size()) = part;
    row += part.size();
  }
  return true;
}

// Curvature of hollows at the knots above what the wheel follows, over its deviation.
Eigen::VectorXd ProfileSearch::excessOf(const Eigen::VectorXd& unknowns) const {
  return ((penalty_ * unknowns).array() - followed_).max(0) / (bridged * followed_);
}

// The linear problem at the best, the wheel's limit on those hollows that exceed it at `about`.
LinearProblem ProfileSearch::problem(const Eigen::VectorXd& about) const {
  LinearProblem problem{best_.residuals, slope_, penalty_, best_.unknowns};
  const double deviation = bridged * followed_;
  const Eigen::VectorXd there = penalty_ * about, here = penalty_ * best_.unknowns;
  problem.limits = Eigen::MatrixXd::Zero(penalty_.rows(), penalty_.cols());
  problem.excess = Eigen::VectorXd::Zero(penalty_.rows());
  for (Eigen::Index i = 0; i < there.size(); ++i) {
    if (!(there[i] > followed_)) continue;
    problem.limits.row(i) = penalty_.row(i) / deviation;
    problem.excess[i] = (here[i] - followed_) / deviation;
  }
  return problem;
}

// Which hollows the limit fixes is known when the step is: a few rounds settle both.
LinearSolution ProfileSearch::solveFixed(double damping) const {
  auto solution = solve(problem(best_.unknowns), chosen_.scale, chosen_.noise, damping);
  for (int round = 0; round < 8; ++round)
    solution = solve(problem(solution.unknowns), chosen_.scale, chosen_.noise, damping);
  return solution;
}

double ProfileSearch::objective(const SearchState& state) const {
  return state.residuals.squaredNorm() / (chosen_.noise * chosen_.noise) +
         (penalty_ * state.unknowns).squaredNorm() / (chosen_.scale * chosen_.scale) +
         excessOf(state.unknowns).squaredNorm();
}

// One step from the best; several lengths of it are tried at once. False where none is better.
bool ProfileSearch::step(bool& improvedMuch) {
  chosen_ = chooseScale(problem(solveFixed(damping_).unknowns), smallest_, largest_);
  const auto whole = solveFixed(damping_), damped = solveFixed(std::max(1.0, 10 * damping_));
  const auto states = statesAt({whole.unknowns, damped.unknowns});
  const double before = objective(best_);
  const SearchState* found = nullptr;
  for (const auto& state : states)
    if (state.isRun && objective(state) < (found ? objective(*found) : before)) found = &state;
  for (const auto& state : states)
    if (state.isRun && &state != found)
      update(slope_, state.unknowns - best_.unknowns, state.residuals - best_.residuals);
  if (!found) return false;
  update(slope_, found->unknowns - best_.unknowns, found->residuals - best_.residuals);
  damping_ = found == &states[0] ? 0.1 * damping_ : std::max(0.1, damping_);
  improvedMuch = objective(*found) < 0.97 * before - 0.01;
  best_ = *found;
  return true;
}

bool ProfileSearch::from(const Start& start) {
  firstShift_ = start.shifts.front();
  Eigen::VectorXd unknowns(penalty_.cols());
  unknowns.head(profile_.unknowns()) = profile_.fit([&](double x) { return heightOf(start.dip, x); });
  for (std::size_t i = 1; i < start.shifts.size(); ++i)
    unknowns[profile_.unknowns() + static_cast<Eigen::Index>(i) - 1] = start.shifts[i];
  best_ = statesAt({unknowns}).front();
  slope_ = Eigen::MatrixXd::Zero(best_.residuals.size(), unknowns.size());  // nothing is known yet
  if (!best_.isRun || !findSlope()) return false;
  bool isFresh = true;
  while (runs_.done() < maximumRuns_) {
    bool improvedMuch = false;
    const bool isBetter = step(improvedMuch);
    if (runs_.isCancelled()) return false;
    if (improvedMuch) {
      isFresh = false;
      continue;
    }
    if (isFresh && !isBetter && damping_ < 10) {
      damping_ = std::max(1.0, 10 * damping_);
      continue;
    }
    if (isFresh) return true;
    if (!findSlope()) return false;
    isFresh = true;
  }
  return false;
}

LinearSolution ProfileSearch::distribution() const {
  return solve(problem(best_.unknowns), chosen_.scale, chosen_.noise);
}

double ProfileSearch::misfit() const {
  return std::sqrt(best_.residuals.squaredNorm() / static_cast<double>(best_.residuals.size()));
}

}  // namespace squat::estimation
