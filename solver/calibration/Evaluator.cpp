#include "calibration/Evaluator.h"

#include <algorithm>
#include <cmath>

#include "calibration/StatementResiduals.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "core/platform/Memory.h"
#include "studies/CaseStudy.h"

namespace squat::calibration {

namespace {

// A grid of the limits: the fine zone of the mesh is then long enough for every defect between them.
studies::StudyDefinition cornersOf(const CalibrationDefinition& definition, const std::string& caseName) {
  studies::StudyDefinition study{caseName, {}, {}};
  for (const auto& input : definition.inputs)
    study.variations.push_back({input.key(), {valueText(input.low), valueText(input.high)}});
  return study;
}

simulation::RunOptions runOptions(const CalibrationOptions& options) {
  simulation::RunOptions run;
  run.threads = options.threads, run.isa = options.isa;
  run.wheelsetModes = false, run.snapshots = false;
  return run;
}

Evaluation failed(const std::string& mesh, const Values& values, const std::string& message) {
  Evaluation evaluation;
  evaluation.mesh = mesh, evaluation.values = values;
  evaluation.hasFailed = true, evaluation.message = message;
  std::replace(evaluation.message.begin(), evaluation.message.end(), '\n', ' ');
  return evaluation;
}

}  // namespace

MeasuredData readMeasuredData(const Targets& targets) {
  MeasuredData data;
  for (const auto& target : targets.signals) data.signals.push_back(readMeasured(target));
  for (const auto& target : targets.receptances) data.receptances.push_back(readMeasuredReceptance(target));
  for (const auto& target : targets.decays) data.decays.push_back(readMeasuredDecays(target));
  return data;
}

Evaluator::Evaluator(const CalibrationDefinition& definition, const MeasuredData& data, std::string mesh,
                     const CalibrationOptions& options)
    : definition_(definition), data_(data), mesh_(std::move(mesh)), options_(options) {
  own_.overrides = definition.overrides;
  own_.definition = cornersOf(definition, definition.caseName);
  auto meshed = definition.overrides;
  meshed.preset = mesh_;
  for (const auto& run : definition.targets.runs) {
    if (!isUsed(run.name)) continue;
    Run entry{meshed, cornersOf(definition, run.caseName), nullptr};
    entry.overrides.values.insert(entry.overrides.values.end(), run.sets.begin(), run.sets.end());
    entry.start = std::make_unique<studies::SharedStart>(entry.definition, entry.overrides, runOptions(options),
                                                         options.threads * options.jobs);
    runs_.emplace(run.name, std::move(entry));
  }
}

bool Evaluator::isUsed(const std::string& run) const {
  const auto& targets = definition_.targets;
  return std::any_of(
             targets.statements.begin(), targets.statements.end(),
             [&](const auto& target) { return target.statement.run == run || target.statement.against == run; }) ||
         std::any_of(targets.signals.begin(), targets.signals.end(),
                     [&](const auto& target) { return target.run == run; });
}

cases::CaseDescription Evaluator::caseOf(const Run& run, const Values& values) const {
  studies::StudyPoint point;
  for (const double value : values) point.values.push_back(valueText(value));
  return studies::caseAt(run.definition, run.overrides, point);
}

bool Evaluator::computeReceptances(const Values& values, std::vector<TargetValue>& targets, Monitor& monitor) const {
  receptance::ReceptanceOptions options;
  options.lowest = 1e9, options.highest = 0, options.threads = options_.threads, options.wheelset = false;
  for (const auto& measured : data_.receptances) {
    options.lowest = std::min(options.lowest, std::floor(measured.frequency.front()));
    options.highest = std::max(options.highest, std::ceil(measured.frequency.back()));
  }
  const auto computed = receptance::trackReceptance(cases::resolve(caseOf(own_, values)), options, monitor);
  if (!computed.complete) return false;
  for (const auto& measured : data_.receptances) {
    if (const auto doubt = unitDoubt(measured, computed); !doubt.empty())
      throw FileError(measured.target.file, "", doubt, "Give the unit in the header of the column");
    targets.push_back(receptanceValue(measured, computed));
  }
  return true;
}

bool Evaluator::computeDecays(const Values& values, std::vector<TargetValue>& targets, Monitor& monitor) const {
  receptance::DecayOptions options;
  options.track.threads = options_.threads;
  options.lowest = 1e9, options.highest = 0;
  for (const auto& measured : data_.decays) {
    options.lowest = std::min(options.lowest, measured.target.lowest);
    options.highest = std::max(options.highest, measured.target.highest);
  }
  const auto computed = receptance::trackDecayRates(cases::resolve(caseOf(own_, values)), options, monitor);
  if (!computed.complete) return false;
  for (const auto& measured : data_.decays) targets.push_back(decayValue(measured, computed));
  return true;
}

std::optional<Evaluation> Evaluator::evaluate(const Values& values, Monitor& monitor) const {
  platform::giveBackFreeMemory();
  // The case is read anew for every point: an edit in between would mix two cases in one table.
  const auto hash = cases::caseHash(cases::loadCase(definition_.caseName, definition_.overrides));
  if (hash != definition_.caseHash)
    throw CaseError({{"case", definition_.caseName + " (" + hash + ")",
                      "the case that the calibration started with (" + definition_.caseHash + ")",
                      "The case was changed during the search: restore it, or choose another folder with -o"}});
  Evaluation evaluation;
  evaluation.mesh = mesh_, evaluation.values = values;
  try {
    std::map<std::string, results::RunResult> results;
    for (const auto& [name, run] : runs_) {
      auto result = run.start->run(caseOf(run, values), monitor);
      if (!result.complete) return std::nullopt;
      results.emplace(name, std::move(result));
    }
    evaluation.targets = statementValues(definition_.targets, results, mesh_);
    for (const auto& measured : data_.signals)
      evaluation.targets.push_back(signalValue(measured, results.at(measured.target.run)));
    if (!data_.receptances.empty() && !computeReceptances(values, evaluation.targets, monitor)) return std::nullopt;
    if (!data_.decays.empty() && !computeDecays(values, evaluation.targets, monitor)) return std::nullopt;
  } catch (const CaseError& error) {
    return failed(mesh_, values, error.what());
  } catch (const RunError& error) {
    return failed(mesh_, values, error.what());
  }
  evaluation.misfit = totalMisfit(definition_.targets, evaluation.targets);
  return evaluation;
}

double totalMisfit(const Targets& targets, const std::vector<TargetValue>& values) {
  const auto weights = targets.weights();
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i].misfit, weight += weights[i];
  return sum / weight;
}

}  // namespace squat::calibration
