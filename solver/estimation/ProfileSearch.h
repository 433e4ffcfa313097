// solver/estimation/ProfileSearch.h - steps of Gauss and Newton from a start to the profile that explains the record.
#pragma once

#include <vector>

#include "estimation/LeastSquares.h"
#include "estimation/ProfileRuns.h"
#include "estimation/Residuals.h"
#include "estimation/SmoothProfile.h"
#include "estimation/StartProfile.h"

namespace squat::estimation {

// Where the search stands: heights of the knots [m], then the shifts [m] of all passages but the first, whose shift is
// that of the start: profile and record would otherwise be free to walk along the track together.
struct SearchState {
  Eigen::VectorXd unknowns;
  Eigen::VectorXd residuals;
  std::vector<PositionSeries> computed;  // of each model
  bool isRun = false;
};

class ProfileSearch {
 public:
  // Keeps references. `radius` [m] of the wheel, which sets how rough a profile is expected to be, and which holds its
  // hollows back: a hollow that is curved more than the wheel is bridged, and nothing tells how deep it is.
  ProfileSearch(const SmoothProfile& profile, const std::vector<ComparedPassage>& passages, ProfileRuns& runs,
                double radius, int maximumRuns);

  // Returns true when it has converged, false where it was cancelled, had no runs left or could run none. The best
  // profile so far is known in any case once `best().isRun`.
  bool from(const Start& start);

  const SearchState& best() const { return best_; }
  std::vector<double> shifts() const;  // [m] of each passage at the best
  // The distribution of the unknowns about the best, by the last derivatives; and what it was made with.
  LinearSolution distribution() const;
  const Regularisation& regularisation() const { return chosen_; }
  double misfit() const;  // root mean square of the residuals

 private:
  SearchState stateFrom(const Eigen::VectorXd& unknowns, const Response& response) const;
  std::vector<double> shiftsOf(const Eigen::VectorXd& unknowns) const;
  std::vector<SearchState> statesAt(const std::vector<Eigen::VectorXd>& unknowns);
  bool findSlope();
  LinearProblem problem(const Eigen::VectorXd& about) const;
  LinearSolution solveFixed(double damping) const;
  double objective(const SearchState& state) const;
  Eigen::VectorXd excessOf(const Eigen::VectorXd& unknowns) const;
  bool step(bool& improvedMuch);

  const SmoothProfile& profile_;
  const std::vector<ComparedPassage>& passages_;
  ProfileRuns& runs_;
  double smallest_, largest_;  // [1/m] limits of the scale of curvature
  double followed_;            // [1/m] curvature that the wheel can follow
  int maximumRuns_;
  double firstShift_ = 0;
  SearchState best_;
  Eigen::MatrixXd slope_, penalty_;
  Regularisation chosen_{1, 1};
  double damping_ = 0;
};

}  // namespace squat::estimation
