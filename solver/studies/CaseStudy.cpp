#include "studies/CaseStudy.h"

#include <algorithm>
#include <map>

#include "analysis/FeatureTable.h"
#include "case/Applicability.h"
#include "case/CaseDescription.h"
#include "case/NamedTables.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "core/platform/Memory.h"
#include "studies/SampledPoints.h"

namespace squat::studies {
namespace {

// Each value on its own: type and range. Relations between keys are found when the point's case is made.
void checkValues(const Variation& variation, std::vector<CaseProblem>& problems) {
  const auto* parameter = cases::findOnEitherSide(variation.key);
  if (!parameter) {
    problems.push_back(cases::unknownKey(variation.key));
    return;
  }
  auto description = cases::defaultCase();
  for (const auto& value : variation.values)
    if (auto problem = cases::trySetValue(description, *parameter, value)) problems.push_back(*problem);
}

// A grid of which no point can be run is an error; single points that cannot become failed rows. So is a key that has
// an effect at no point: its rows would all be equal.
void checkGrid(const StudyDefinition& definition, const cases::CaseOverrides& overrides) {
  std::vector<CaseProblem> problems;
  std::map<std::string, std::string> withoutEffect;  // key and why
  for (const auto& variation : definition.variations) withoutEffect[variation.key];
  bool canBeRun = false;
  for (const auto& point : gridOf(definition)) {
    try {
      const auto description = caseAt(definition, overrides, point);
      canBeRun = true;
      for (auto item = withoutEffect.begin(); item != withoutEffect.end();) {
        const auto& parameter = *cases::findOnEitherSide(item->first);
        const auto reason = cases::keyOnRight(item->first).empty() ? cases::reasonWithoutEffect(description, parameter)
                                                                   : cases::reasonWithoutRight(description, parameter);
        if (item->second.empty()) item->second = reason;
        item = reason.empty() ? withoutEffect.erase(item) : std::next(item);
      }
    } catch (const CaseError& error) {
      if (problems.empty()) problems = error.problems();
    }
    if (canBeRun && withoutEffect.empty()) return;
  }
  if (!canBeRun) throw CaseError(problems);
  problems.clear();
  for (const auto& [key, reason] : withoutEffect) problems.push_back({"--vary " + key, "", "", reason});
  throw CaseError(problems);
}

std::vector<Variation> griddedVariations(const std::vector<std::string>& texts) {
  std::vector<Variation> variations;
  std::vector<CaseProblem> problems;
  for (const auto& text : texts) {
    try {
      variations.push_back(variationFromText(text));
    } catch (const CaseError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  for (const auto& variation : variations) checkValues(variation, problems);
  if (!problems.empty()) throw CaseError(problems);
  return variations;
}

std::vector<Variation> listedVariations(const StudyRequest& request) {
  auto variations = request.sample.empty() ? variationsFromFile(request.pointsFile)
                                           : sampledVariations(request.variations, request.sample, request.seed);
  std::vector<CaseProblem> problems;
  for (const auto& variation : variations) checkValues(variation, problems);
  if (!problems.empty()) throw CaseError(problems);
  return variations;
}

}  // namespace

StudyDefinition studyOf(const std::string& nameOrPath, const cases::CaseOverrides& overrides,
                        const std::vector<std::string>& variations) {
  return studyOf(nameOrPath, overrides, StudyRequest{variations});
}

StudyDefinition studyOf(const std::string& nameOrPath, const cases::CaseOverrides& overrides,
                        const StudyRequest& request) {
  StudyDefinition definition{nameOrPath, cases::caseHash(cases::loadCase(nameOrPath, overrides)), {}};
  definition.program = programVersion();
  definition.isList = !request.sample.empty() || !request.pointsFile.empty();
  definition.variations = definition.isList ? listedVariations(request) : griddedVariations(request.variations);
  checkGrid(definition, overrides);
  return definition;
}

cases::CaseDescription caseAt(const StudyDefinition& definition, const cases::CaseOverrides& overrides,
                              const StudyPoint& point) {
  cases::CaseOverrides all = overrides;
  for (std::size_t v = 0; v < definition.variations.size(); ++v)
    all.values.emplace_back(definition.variations[v].key, point.values[v]);
  return cases::loadCase(definition.caseName, all);
}

StudyTable runCaseStudy(const StudyDefinition& definition, const cases::CaseOverrides& overrides, const CaseRunner& run,
                        const StudyOptions& options, Monitor& monitor) {
  auto inputs = cases::filesOfCase(definition.caseName, cases::loadCase(definition.caseName, overrides));
  for (const auto& variation : definition.variations)
    if (const auto* parameter = cases::findOnEitherSide(variation.key); parameter && cases::namesTable(*parameter))
      inputs.insert(inputs.end(), variation.values.begin(), variation.values.end());
  keepInputs(inputs, studyFiles(options.folder, options.part));
  const StudyRunner runner = [&](const StudyPoint& point, Monitor& own) -> std::optional<FeatureRow> {
    // The case is read anew for every point: an edit in between would mix two cases in one table.
    if (const auto hash = cases::caseHash(cases::loadCase(definition.caseName, overrides)); hash != definition.caseHash)
      throw CaseError({{"case", definition.caseName + " (" + hash + ")",
                        "the case that the study started with (" + definition.caseHash + ")",
                        "The case was changed during the study: restore it, or start a new study in another folder"}});
    platform::giveBackFreeMemory();
    const auto result = run(caseAt(definition, overrides, point), point, own);
    if (!result.complete) return std::nullopt;
    return analysis::featureTable(result);
  };
  return runStudy(definition, runner, options, monitor);
}

}  // namespace squat::studies
