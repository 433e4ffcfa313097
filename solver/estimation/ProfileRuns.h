// solver/estimation/ProfileRuns.h - runs of many profiles, several at once, with progress.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "estimation/PassageModel.h"

namespace squat::estimation {

// What one profile gives: a series for each model. Nothing where it cannot be run, or where it was cancelled.
using Response = std::optional<std::vector<PositionSeries>>;

class ProfileRuns {
 public:
  // Keeps references. `planned`: profiles that will be run about, for the progress.
  ProfileRuns(const std::vector<PassageModel>& models, int jobs, int planned, Monitor& monitor);

  std::vector<Response> all(const std::vector<ProfilePoints>& profiles);
  void setPhase(const std::string& phase) { phase_ = phase; }  // for people
  void plan(int more) { planned_ = done_ + more; }             // profiles still to come, about

  bool isCancelled() { return monitor_.cancelled(); }
  int done() const { return done_; }  // runs
  int jobs() const { return jobs_; }

 private:
  class RunMonitor;
  void report();

  const std::vector<PassageModel>& models_;
  int jobs_, planned_, done_ = 0;
  double started_ = 0;  // [s]
  std::string phase_ = "start";
  Monitor& monitor_;
  std::mutex mutex_;
};

}  // namespace squat::estimation
