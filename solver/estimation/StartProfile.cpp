#include "estimation/StartProfile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "scenario/DefectSurface.h"

namespace squat::estimation {

namespace {

constexpr double firstDepth = 1e-4;                                                   // [m]
constexpr double shallowest = 2e-6, deepest = 2e-3;                                   // [m]
constexpr double lengths[] = {0.016, 0.023, 0.032, 0.045, 0.064, 0.09, 0.127, 0.18};  // [m] a factor of 1.4 apart

struct Tried {
  Start start;
  double factor = 1;  // on the computed signal for the smallest misfit
  bool hasFailed = true;
};

Tried judge(const Dip& dip, const Response& response, const std::vector<ComparedPassage>& passages) {
  Tried tried;
  tried.start.dip = dip;
  if (!response) return tried;
  tried.hasFailed = false;
  double both = 0, own = 0;
  for (const auto& passage : passages) {
    const auto& computed = (*response)[passage.model];
    const double shift = shiftOf(passage, computed);
    tried.start.shifts.push_back(shift);
    tried.start.misfit += residualsOf(passage, computed, shift).squaredNorm();
    const auto ours = valuesAt(computed, passage.locations, 0);
    const auto theirs = valuesAt(passage.measured, passage.locations, shift);
    for (std::size_t i = 0; i < ours.size(); ++i) both += ours[i] * theirs[i], own += ours[i] * ours[i];
  }
  if (own > 0) tried.factor = std::clamp(both / own, 0.25, 4.0);
  return tried;
}

ProfilePoints pointsOf(const Dip& dip, const SearchWindow& window) {
  ProfilePoints points;
  const auto count = static_cast<long>(std::lround((window.last - window.first) / 1e-3));
  for (long i = 0; i <= count; ++i) {
    const double x = window.first + (window.last - window.first) * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({x, heightOf(dip, x)});
  }
  return points;
}

Dip deepened(const Tried& tried) {
  auto dip = tried.start.dip;
  dip.depth = std::clamp(dip.depth * tried.factor, shallowest, deepest);
  return dip;
}

const Tried* bestOf(const std::vector<Tried>& all) {
  const Tried* best = nullptr;
  for (const auto& tried : all)
    if (!tried.hasFailed && (!best || tried.start.misfit < best->start.misfit)) best = &tried;
  return best;
}

}  // namespace

double heightOf(const Dip& dip, double position) {
  scenario::Defect defect;
  defect.shape = dip.shape, defect.length = dip.length, defect.depth = dip.depth;
  defect.ramp = 0.2 * dip.length, defect.middleHeight = 0.3;
  // The W has its first bottom at zero.
  const double middle = dip.shape == cases::DefectShape::wshape ? 0.25 * dip.length : 0;
  return scenario::defectHeight(defect, position + middle);
}

std::optional<Start> findStart(ProfileRuns& runs, const std::vector<ComparedPassage>& passages,
                               const SearchWindow& window, double longest) {
  std::vector<Tried> all;
  const auto tryAll = [&](const std::vector<Dip>& dips) {
    std::vector<ProfilePoints> profiles;
    for (const auto& dip : dips) profiles.push_back(pointsOf(dip, window));
    const auto responses = runs.all(profiles);
    for (std::size_t i = 0; i < dips.size(); ++i) all.push_back(judge(dips[i], responses[i], passages));
    return !runs.isCancelled();
  };
  std::vector<Dip> dips;
  for (const double length : lengths)
    if (length <= longest * 1.001) dips.push_back({cases::DefectShape::cosine, length, firstDepth});
  if (!tryAll(dips)) return std::nullopt;
  dips.clear();
  for (const auto& tried : all)
    if (!tried.hasFailed) dips.push_back(deepened(tried));
  if (!tryAll(dips)) return std::nullopt;
  if (const auto* best = bestOf(all)) {
    auto dip = deepened(*best);
    dips = {dip};
    for (const auto shape : {cases::DefectShape::cut, cases::DefectShape::wshape})
      dip.shape = shape, dips.push_back(dip);
    if (!tryAll(dips)) return std::nullopt;
  }
  const auto* best = bestOf(all);
  if (!best) throw RunError("no dip of any length can be run with this case", 0, 0, "start of the estimate");
  return best->start;
}

}  // namespace squat::estimation
