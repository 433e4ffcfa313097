#include <algorithm>
#include <cmath>

#include "case/Resolve.h"
#include "contact/ContactSurfaces.h"
#include "core/Errors.h"
#include "estimation/Estimation.h"
#include "estimation/ModelSpread.h"
#include "estimation/ProfileBounds.h"
#include "estimation/ProfileSearch.h"
#include "scenario/DefectSurface.h"
#include "text/Numbers.h"

namespace squat::estimation {

namespace {

constexpr double room = 0.018;        // [m] of knots beyond either end of the start
constexpr double unexplained = 1.25;  // times the noise
constexpr double sameSpeed = 0.02;    // passages whose speeds differ by less share a model
constexpr double ownSpeed = 0.005;    // a record's speed that differs by less is the case's

simulation::RunOptions runOptions(const EstimateOptions& options) {
  simulation::RunOptions run;
  run.threads = options.threads, run.isa = options.isa;
  run.wheelsetModes = false, run.snapshots = false;
  return run;
}

// Speeds of the models, and which one each passage belongs to.
std::vector<double> speedsOf(const std::vector<MeasuredPassage>& measured, double own,
                             std::vector<std::size_t>& models) {
  std::vector<double> speeds;
  for (const auto& passage : measured) {
    const double speed = std::abs(passage.speed / own - 1) < ownSpeed ? own : passage.speed;
    std::size_t model = 0;
    while (model < speeds.size() && std::abs(speed / speeds[model] - 1) > sameSpeed) ++model;
    if (model == speeds.size()) speeds.push_back(speed);
    models.push_back(model);
  }
  return speeds;
}

class Estimation {
 public:
  Estimation(const EstimateDefinition& definition, const EstimateOptions& options, Monitor& monitor)
      : definition_(definition),
        options_(options),
        monitor_(monitor),
        case_(cases::loadCase(definition.caseName, definition.overrides)) {
    measured_ = readPassages(definition.files, definition.reading, case_.motion.speed, definition.cutoff);
    std::vector<std::size_t> models;
    speeds_ = speedsOf(measured_, case_.motion.speed, models);
    const double half = 0.5 * definition.longest + room;
    window_ = {-half, half + 0.01, definition.beyond};
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      compared_.push_back(comparedPassage(measured_[i], models[i], speeds_[models[i]], definition.cutoff, window_));
      for (const auto& note : measured_[i].notes) estimate_.notes.push_back(measured_[i].name + ": " + note);
    }
    radius_ = contact::seatOf(cases::resolve(case_)).radius;
    reportSpeeds();
  }

  Estimate run() {
    for (const double speed : speeds_)
      models_.emplace_back(caseForSearch(case_, window_, speed, definition_.cutoff), runOptions(options_));
    for (auto& model : models_)
      if (!model.warmUp(options_.threads * options_.jobs, monitor_)) return estimate_;
    ProfileRuns runs(models_, options_.jobs, plannedRuns(), monitor_);
    runs.setPhase("start");
    const auto start = findStart(runs, compared_, window_, definition_.longest);
    if (!start) return estimate_;
    const double half = 0.5 * start->dip.length + room;
    const SmoothProfile profile(std::max(-half, window_.first), std::min(half + 0.006, window_.last), spacing());
    ProfileSearch search(profile, compared_, runs, radius_, options_.runs);
    runs.setPhase("search");
    const bool isEnded = search.from(*start);
    estimate_.runs = runs.done();
    if (!search.best().isRun) return estimate_;
    describe(profile, search);
    estimate_.complete = !runs.isCancelled();
    if (!isEnded && estimate_.complete)
      estimate_.notes.push_back("the search ended after " + std::to_string(runs.done()) +
                                " runs before it had settled");
    if (estimate_.complete) spread(profile, search);
    return estimate_;
  }

 private:
  int plannedRuns() const { return static_cast<int>(models_.size()) * 60; }

  // Knots as near as the shortest wave that the signals hold can tell apart.
  double spacing() const {
    const double slowest = *std::min_element(speeds_.begin(), speeds_.end());
    return std::clamp(0.4 * slowest / definition_.cutoff, 0.004, 0.008);
  }

  void reportSpeeds() {
    for (const double speed : speeds_)
      if (speed != case_.motion.speed)
        estimate_.notes.push_back("the record's speed of " + text::roundedText(speed) +
                                  " m/s is taken in place of the case's " + text::roundedText(case_.motion.speed));
  }

  void describe(const SmoothProfile& profile, const ProfileSearch& search) {
    const auto distribution = search.distribution();
    auto best = distribution;
    best.unknowns = search.best().unknowns;
    estimate_.profile = profileWithBounds(profile, best, radius_);
    const auto extent = extentOf(profile, best);
    estimate_.depth = extent.depth, estimate_.length = extent.length;
    // Ends are known no better than to the distance of the knots.
    estimate_.length.low = std::max(0.0, estimate_.length.low - spacing()), estimate_.length.high += spacing();
    estimate_.misfit = search.misfit();
    const auto points = profile.points(search.best().unknowns.head(profile.unknowns()));
    estimate_.description = withProfile(case_, points);
    estimate_.description.motion.speed = speeds_.front();
    const auto surface = cases::surfaceOf(estimate_.description);
    for (const auto& point :
         cases::rigidWheelPath(surface, radius_, surface.first(), surface.last(), SmoothProfile::sampleStep))
      estimate_.depthOfPath = std::max(estimate_.depthOfPath, -point.height);
    explain(points, search);
  }

  void explain(const ProfilePoints& points, const ProfileSearch& search) {
    const auto deepest = std::min_element(points.begin(), points.end(),
                                          [](const auto& a, const auto& b) { return a.height < b.height; });
    const auto shifts = search.shifts();
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      const auto& compared = compared_[i];
      const auto& computed = search.best().computed[compared.model];
      ExplainedPassage passage;
      passage.name = measured_[i].name, passage.speed = measured_[i].speed;
      passage.location = shifts[i] + deepest->position;
      passage.noise = measured_[i].noise, passage.peak = measured_[i].peak;
      std::vector<double> locations;
      for (double x = window_.first; x <= window_.end; x += computed.step) locations.push_back(x);
      passage.measured = valuesAt(compared.measured, locations, shifts[i]);
      passage.computed = valuesAt(computed, locations, 0);
      for (const double x : locations) passage.position.push_back(x - deepest->position);
      const auto residuals = residualsOf(compared, computed, shifts[i]);
      passage.difference = passage.noise * std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
      estimate_.passages.push_back(std::move(passage));
    }
  }

  // Where noise does not account for what is left, something in the case is wrong. The wheelset decides most: the depth
  // with each of the shipped ones widens the range.
  void spread(const SmoothProfile& profile, const ProfileSearch& search) {
    if (!definition_.isSpreadWanted || search.regularisation().noise < unexplained) return;
    estimate_.notes.push_back("what is left is " + text::roundedText(search.regularisation().noise) +
                              " times the noise: vehicle, track or location differ from the case's, or the profile "
                              "has edges that a smooth curve cannot make");
    const auto points = profile.points(search.best().unknowns.head(profile.unknowns()));
    const SpreadQuestion question{definition_, options_, window_, speeds_, compared_};
    const auto others = otherWheelsets(question, points, estimate_.runs, monitor_);
    if (!others) {
      estimate_.complete = false;
      return;
    }
    double minimum = 1, maximum = 1;
    for (const auto& other : *others) {
      estimate_.notes.push_back("with wheelset.preset = " + other.name + " the record asks for heights " +
                                text::roundedText(other.factor) + " times as large");
      minimum = std::min(minimum, other.factor), maximum = std::max(maximum, other.factor);
    }
    estimate_.depth.low *= minimum, estimate_.depth.high *= maximum;
    for (auto& sample : estimate_.profile) {
      const double one = minimum * sample.lower, other = maximum * sample.lower;
      const double third = minimum * sample.upper, fourth = maximum * sample.upper;
      sample.lower = std::min({sample.lower, one, other});
      sample.upper = std::max({sample.upper, third, fourth});
    }
  }

  const EstimateDefinition& definition_;
  const EstimateOptions& options_;
  Monitor& monitor_;
  cases::CaseDescription case_;
  std::vector<MeasuredPassage> measured_;
  std::vector<ComparedPassage> compared_;
  std::vector<double> speeds_;
  std::vector<PassageModel> models_;
  SearchWindow window_;
  double radius_ = 0;
  Estimate estimate_;
};

}  // namespace

Estimate estimateProfile(const EstimateDefinition& definition, const EstimateOptions& options, Monitor& monitor) {
  return Estimation(definition, options, monitor).run();
}

}  // namespace squat::estimation
