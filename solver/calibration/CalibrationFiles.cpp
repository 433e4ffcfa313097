#include "calibration/CalibrationFiles.h"

#include <string_view>

#include "calibration/CalibratedCase.h"
#include "calibration/CalibrationSummary.h"
#include "case/CaseDescription.h"
#include "core/DurableFile.h"
#include "studies/Jobs.h"

namespace squat::calibration {

namespace {

std::string summaryFile(const std::string& folder) { return folder + "/calibration.txt"; }

}  // namespace

void shareCores(const CalibrationDefinition& definition, int jobs, int threads, CalibrationOptions& options) {
  const auto search = studies::demandOnMesh(definition.searchMesh),
             confirm = studies::demandOnMesh(definition.confirmMesh);
  const auto& demand = search.memory < confirm.memory ? confirm : search;
  const auto sharing = studies::shareMachine(studies::thisMachine(), demand, {jobs, threads});
  options.jobs = sharing.jobs, options.threads = sharing.threads;
}

std::string calibratedCaseFile(const std::string& folder, const std::string& stem) {
  return folder + "/" + stem + "-calibrated.toml";
}

void keepInputsOf(const CalibrationDefinition& definition, const std::vector<std::string>& targetFiles,
                  const std::string& folder, const std::string& stem) {
  const auto description = cases::loadCase(definition.caseName, definition.overrides);
  auto inputs = cases::filesOfCase(definition.caseName, description);
  inputs.insert(inputs.end(), targetFiles.begin(), targetFiles.end());
  const auto& targets = definition.targets;
  for (const auto& target : targets.signals) inputs.insert(inputs.end(), target.files.begin(), target.files.end());
  for (const auto& target : targets.receptances) inputs.push_back(target.file);
  for (const auto& target : targets.decays) inputs.push_back(target.file);
  for (const auto& run : targets.runs) inputs.push_back(run.caseName);
  auto outputs = calibrationFiles(folder);
  outputs.insert(outputs.end(), {calibratedCaseFile(folder, stem), summaryFile(folder)});
  keepInputs(inputs, outputs);
}

std::vector<std::string> writeCalibrated(const Calibration& found, const std::string& folder, const std::string& stem) {
  const auto casePath = calibratedCaseFile(folder, stem), summaryPath = summaryFile(folder);
  writeDurably(casePath, std::string_view(calibratedCase(found)));
  writeDurably(summaryPath, std::string_view(calibrationSummary(found)));
  return {calibrationFiles(folder).front(), casePath, summaryPath};  // the others are for resuming
}

}  // namespace squat::calibration
