#include "growth/ComputeForecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "core/platform/Memory.h"
#include "studies/CaseStudy.h"
#include "studies/CostEstimate.h"
#include "studies/Jobs.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

constexpr const char* limitColumn = "limit reached after [Mt]";

std::string inMegatonnes(double kilograms) { return text::numberText(kilograms / kilogramsInMegatonne); }

std::string nameAt(const ForecastPoint& point) {
  return "depth after " + inMegatonnes(point.tonnage) + " Mt" + (point.toBeGround ? ", to be ground [mm]" : " [mm]");
}

std::string workOf(const GrowthOptions& growth) {
  std::string work = "growth over " + inMegatonnes(growth.tonnage) + " Mt";
  for (const auto& grinding : growth.grindings)
    work += ", " + text::numberText(1e3 * grinding.depth) + " mm ground off after " + inMegatonnes(grinding.tonnage) +
            " Mt";
  if (growth.untilDepth) work += ", limit " + text::numberText(1e3 * *growth.untilDepth) + " mm";
  return work;
}

// A study is asked by --vary and --sample.
[[noreturn]] void rethrowInOwnWords(const CaseError& error) {
  auto problems = error.problems();
  for (auto& problem : problems) {
    if (problem.key.rfind("--vary", 0) == 0) problem.key.replace(0, 6, "--uncertain");
    if (problem.key == "--sample") problem.key = "--growths";
    if (problem.advice.starts_with("The folder holds another study"))
      problem.advice = "The folder holds another forecast: choose another folder or name, or remove that folder";
  }
  throw CaseError(problems);
}

// Of the first point that can be grown; others become failed rows. Throws CaseError where there is none.
cases::CaseDescription firstCase(const ForecastPlan& plan) {
  std::optional<CaseError> refused;
  for (const auto& point : studies::gridOf(plan.study)) {
    try {
      return growingCase(studies::caseAt(plan.study, plan.overrides, point));
    } catch (const CaseError& error) {
      if (!refused) refused = error;
    }
  }
  throw CaseError(refused->problems());
}

// The wheelsets of a growth and the case's own stay in memory together.
void shareMachine(ForecastPlan& plan) {
  const auto description = firstCase(plan);
  const auto cost = studies::costOf(description);
  auto machine = studies::thisMachine();
  if (plan.growth.threads > 0) machine.cores = std::min(machine.cores, plan.growth.threads);
  const int wheelsets = description.growth.wheelsets + 1;
  const auto sharing =
      studies::shareMachine(machine, {cost.bytes * wheelsets, studies::kTrafficOfAThread,
                                      studies::kStateOfAnElement * static_cast<double>(cost.elements)});
  const int growths = static_cast<int>(studies::gridOf(plan.study).size());
  plan.jobs = std::min(sharing.jobs, growths);
  plan.threads = sharing.jobs > growths ? std::max(1, machine.cores / growths) : sharing.threads;
}

// Each growth reads the case file: an edit meanwhile would put growths of two cases into one table.
void requireSameCase(const ForecastPlan& plan) {
  const auto hash = cases::caseHash(cases::loadCase(plan.study.caseName, plan.overrides));
  if (hash != plan.study.caseHash)
    throw CaseError({{"case", plan.study.caseName + " (" + hash + ")",
                      "the case that the forecast started with (" + plan.study.caseHash + ")",
                      "The case was changed meanwhile: restore it, or choose another folder or name"}});
}

studies::FeatureRow rowOf(const Growth& grown, const GrowthOptions& options) {
  const auto points = forecastPoints(options);
  const auto depths = depthsAt(grown, points);
  studies::FeatureRow row;
  for (std::size_t i = 0; i < depths.size(); ++i) row.emplace_back(nameAt(points[i]), 1e3 * depths[i]);
  if (!options.untilDepth) return row;
  const auto passed = firstPassage(grown, *options.untilDepth);
  row.emplace_back(limitColumn, passed ? *passed / kilogramsInMegatonne : std::numeric_limits<double>::quiet_NaN());
  return row;
}

ForecastGrowth growthOf(const studies::FeatureRow& row, const std::vector<ForecastPoint>& points) {
  const auto valueOf = [&](const std::string& name) {
    const auto found = std::find_if(row.begin(), row.end(), [&](const auto& feature) { return feature.first == name; });
    return found == row.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  };
  ForecastGrowth grown;
  for (const auto& point : points) grown.depths.push_back(1e-3 * valueOf(nameAt(point)));
  if (const double passed = valueOf(limitColumn); !std::isnan(passed)) grown.passedAt = passed * kilogramsInMegatonne;
  return grown;
}

}  // namespace

ForecastPlan forecastPlan(const std::string& caseName, const cases::CaseOverrides& overrides,
                          const ForecastRequest& request, const GrowthOptions& growth, const std::string& folder) {
  studies::StudyRequest points;
  points.variations = request.uncertain;
  points.sample = "latin-hypercube:" + std::to_string(request.growths);
  ForecastPlan plan;
  plan.overrides = overrides, plan.growth = growth, plan.folder = folder;
  try {
    plan.study = studies::studyOf(caseName, overrides, points);
    plan.study.work = workOf(growth);
    studies::readTable(plan.study, folder);
  } catch (const CaseError& error) {
    rethrowInOwnWords(error);
  }
  shareMachine(plan);
  return plan;
}

std::optional<Forecast> forecastGrowth(const ForecastPlan& plan, Monitor& monitor) {
  makeFolder(plan.folder);
  const FolderLock owner(plan.folder, "squat grow " + plan.study.caseName);
  studies::StudyOptions study;
  study.folder = plan.folder, study.jobs = plan.jobs, study.retryFailed = true;
  GrowthOptions each = plan.growth;
  each.checkpoint.clear(), each.finishedStage = {}, each.soFar = {}, each.resume = false;
  each.untilDepth.reset();  // each to the end of the traffic
  each.threads = plan.threads;
  const auto growAt = [&](const studies::StudyPoint& point, Monitor& own) -> std::optional<studies::FeatureRow> {
    requireSameCase(plan);
    platform::giveBackFreeMemory();
    const auto grown = grow(studies::caseAt(plan.study, plan.overrides, point), each, own);
    if (!grown.complete) return {};
    return rowOf(grown, plan.growth);
  };
  const auto table = studies::runStudy(plan.study, growAt, study, monitor);
  if (table.count(studies::RowState::open) > 0) return {};
  const auto points = forecastPoints(plan.growth);
  std::vector<ForecastGrowth> growths;
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::done) growths.push_back(growthOf(row.features, points));
  return forecastFrom(points, growths, plan.growth.untilDepth, table.rows.size());
}

}  // namespace squat::growth
