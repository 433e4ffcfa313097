#include "estimation/PassageModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "core/Errors.h"
#include "signals/Record.h"
#include "signals/Resample.h"
#include "signals/SignalCatalogue.h"

namespace squat::estimation {

namespace {

// The deepest point may come to lie elsewhere than in the middle, and the mesh has to serve it there.
constexpr double margin = 0.02;  // [m]

// What a run would say of the case is said when the case is read, once.
class Quiet : public Monitor {
 public:
  explicit Quiet(Monitor& monitor) : monitor_(monitor) {}
  void report(const Progress& progress) override { monitor_.report(progress); }
  bool cancelled() override { return monitor_.cancelled(); }
  bool paused() override { return monitor_.paused(); }

 private:
  Monitor& monitor_;
};

double deepestPosition(const ProfilePoints& points) {
  const auto lowest =
      std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
  return lowest->position;
}

}  // namespace

double positionStep(double speed, double cutoff) { return speed / (10 * cutoff); }

cases::CaseDescription caseForSearch(const cases::CaseDescription& description, const SearchWindow& window,
                                     double speed, double cutoff) {
  cases::requireHalf(description, "an estimate");
  cases::requireSingleWheelset(description, "an estimate");
  auto searched = description;
  ProfilePoints points;  // some dip; every run has its own
  for (int i = -10; i <= 10; ++i) points.push_back({2e-3 * i, -5e-5 * (1 + std::cos(i * 0.1 * std::numbers::pi))});
  searched = withProfile(searched, points);
  searched.mesh.zoneBefore = -window.first + margin, searched.mesh.zoneBehind = window.last + margin;
  // The wheel starts outside the zone, as makeWarmState asks.
  searched.motion.runUp = std::max(searched.motion.runUp, searched.mesh.zoneBefore + 0.06);
  searched.motion.beyond = window.end + margin;
  searched.motion.speed = speed;
  searched.output.filterCutoff = cutoff;
  searched.output.cwtVoices = 4;  // the scalogram is not looked at
  return searched;
}

cases::CaseDescription withProfile(cases::CaseDescription description, const ProfilePoints& points) {
  auto& defect = description.defect;
  const auto lateral = defect.lateral;
  const double centre = defect.lateralCentre, halfWidth = defect.halfWidth;
  defect = cases::defaultCase().defect;
  defect.lateral = lateral, defect.lateralCentre = centre, defect.halfWidth = halfWidth;
  defect.shape = cases::DefectShape::profile;
  defect.points = points;
  defect.heightScale = 1, defect.level = false, defect.moveNodes = false;
  return description;
}

PassageModel::PassageModel(cases::CaseDescription description, simulation::RunOptions options)
    : description_(std::move(description)), options_(std::move(options)) {}

bool PassageModel::warmUp(int threads, Monitor& monitor) {
  auto options = options_;
  options.threads = threads;
  Quiet quiet(monitor);
  auto made = simulation::makeWarmState(description_, options, quiet);
  if (!made) return false;
  warm_ = std::make_shared<const simulation::WarmState>(*std::move(made));
  return true;
}

std::optional<PositionSeries> PassageModel::run(const ProfilePoints& points, Monitor& monitor) const {
  auto options = options_;
  options.warm = warm_;
  results::RunResult result;
  try {
    result = simulation::runCase(withProfile(description_, points), options, monitor);
  } catch (const CaseError&) {  // the profile rises above what the wheel has room for, or is too steep
    return std::nullopt;
  } catch (const RunError&) {
    return std::nullopt;
  }
  if (!result.complete) return std::nullopt;
  const auto series = signals::seriesOf(result, signals::names::axleBoxFiltered);
  const auto last = static_cast<double>(result.position.size() - 1);
  const PositionSeries own{result.position.front() + deepestPosition(points),
                           (result.position.back() - result.position.front()) / last, series.values,
                           signals::names::axleBox, "m/s2"};
  return signals::resample(own, positionStep(description_.motion.speed, description_.output.filterCutoff));
}

}  // namespace squat::estimation
