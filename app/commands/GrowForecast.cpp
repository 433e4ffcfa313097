#include "commands/GrowForecast.h"

#include <algorithm>
#include <limits>

#include "case/CaseFile.h"
#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "studies/CaseStudy.h"
#include "studies/CostEstimate.h"
#include "studies/Jobs.h"
#include "text/Numbers.h"

namespace squat::commands {

namespace {

std::string nameAt(double tonnage) {
  return "depth after " + text::numberText(tonnage / growth::kilogramsInMegatonne) + " Mt [mm]";
}

// Growths at once, each with a thread: all wheelsets of the traffic and the case's own stay in memory.
int growthsAtOnce(const studies::StudyDefinition& definition, const cases::CaseOverrides& overrides,
                  const cases::CaseDescription& description, int threads) {
  auto machine = studies::thisMachine();
  if (threads > 0) machine.cores = std::min(machine.cores, threads);
  const auto cost = studies::costOfARun(definition, overrides);
  studies::Sharing wanted;
  wanted.threads = 1;
  return studies::shareMachine(machine, {cost.bytes * (description.growth.wheelsets + 1), 0, 0}, wanted).jobs;
}

}  // namespace

studies::StudyDefinition forecastStudy(const CaseOptions& options, const ForecastRequest& request,
                                       const growth::GrowthOptions& growth) {
  studies::StudyRequest points;
  points.variations = request.uncertain;
  points.sample = "latin-hypercube:" + std::to_string(request.growths);
  auto definition = studies::studyOf(options.name, caseOverrides(options), points);
  // The table of another tonnage or grinding is that of another study.
  std::string traffic = definition.caseHash + " " + std::to_string(growth.tonnage);
  for (const auto& grinding : growth.grindings)
    traffic += " " + std::to_string(grinding.depth) + "@" + std::to_string(grinding.tonnage);
  definition.caseHash = cases::shortHash(traffic);
  return definition;
}

std::optional<growth::Forecast> forecastGrowth(const CaseOptions& options, const studies::StudyDefinition& definition,
                                               const growth::GrowthOptions& growth, const std::string& folder,
                                               Monitor& monitor) {
  const auto overrides = caseOverrides(options);
  const auto tonnages = growth::forecastTonnages(growth.tonnage);
  makeFolder(folder);
  const FolderLock owner(folder, "squat grow " + options.name);
  studies::StudyOptions study;
  study.folder = folder;
  study.jobs = growthsAtOnce(definition, overrides, readCase(options), growth.threads);
  const auto grow = [&](const studies::StudyPoint& point, Monitor& own) -> std::optional<studies::FeatureRow> {
    growth::GrowthOptions alone;
    alone.tonnage = growth.tonnage, alone.grindings = growth.grindings;
    alone.threads = 1, alone.isa = growth.isa;
    const auto grown = growth::grow(studies::caseAt(definition, overrides, point), alone, own);
    if (!grown.complete) return {};
    const auto depths = growth::depthsAt(grown, tonnages);
    studies::FeatureRow row;
    for (std::size_t i = 0; i < depths.size(); ++i) row.emplace_back(nameAt(tonnages[i]), 1e3 * depths[i]);
    return row;
  };
  const auto table = studies::runStudy(definition, grow, study, monitor);
  if (table.count(studies::RowState::open) > 0) return {};
  std::vector<std::vector<double>> depths;
  for (const auto& row : table.rows) {
    if (row.state != studies::RowState::done) {
      monitor.message("failed: " + studies::toText(definition, row.point) + ": " + row.message);
      continue;
    }
    auto& own = depths.emplace_back();
    for (const double tonnage : tonnages) {
      const auto name = nameAt(tonnage);
      const auto found = std::find_if(row.features.begin(), row.features.end(),
                                      [&](const auto& feature) { return feature.first == name; });
      own.push_back(found == row.features.end() ? std::numeric_limits<double>::quiet_NaN() : 1e-3 * found->second);
    }
  }
  return growth::forecastFrom(tonnages, depths, growth.untilDepth);
}

}  // namespace squat::commands
