#include "commands/DrivenRun.h"

#include <cstdio>

#include "analysis/FeatureTable.h"
#include "case/CaseDescription.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "studies/EvaluationFiles.h"

namespace squat::commands {

namespace {

std::vector<std::string> featuresAsked(const DrivenOptions& driven, const studies::EvaluationRequest& request) {
  if (driven.features.empty() && request.features.empty())
    throw CaseError({{"--features", "none", "names of features",
                      "Example: --features peak,largest_contact_force, or name them in the parameters file"}});
  if (!driven.features.empty() && !request.features.empty() && driven.features.size() != request.features.size())
    throw CaseError(
        {{"--features", std::to_string(driven.features.size()) + " features",
          "as many as the parameters file asks for (" + std::to_string(request.features.size()) + ")", ""}});
  return driven.features.empty() ? request.features : driven.features;
}

}  // namespace

void addDrivenOptions(CLI::App& command, DrivenOptions& options) {
  auto* parameters = command
                         .add_option("--parameters", options.parameters,
                                     "For another program's loop: sets the keys in this file of Dakota's, writes "
                                     "--results and nothing else")
                         ->type_name("FILE");
  auto* results =
      command.add_option("--results", options.results, "Features of the run, as Dakota reads them")->type_name("FILE");
  parameters->needs(results);
  results->needs(parameters);
  command.add_option("--features", options.features, "Which of them (default: those that the parameters file names)")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->needs(parameters);
}

int driveRun(const DrivenOptions& driven, const CaseOptions& caseOptions, simulation::RunOptions run) {
  keepInputs({driven.parameters, caseOptions.name}, {driven.results});
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  try {
    const auto request = studies::readRequest(driven.parameters);
    const auto features = featuresAsked(driven, request);
    auto overrides = caseOverrides(caseOptions);
    overrides.values.insert(overrides.values.end(), request.values.begin(), request.values.end());
    run.wheelsetModes = run.snapshots = run.resume = false;
    const auto result = simulation::runCase(cases::loadCase(caseOptions.name, overrides), run, monitor);
    monitor.clearLine();
    if (!result.complete) {
      writeDurably(driven.results, std::string_view(studies::kFailedAnswer));
      return kCancelled;
    }
    writeDurably(driven.results, std::string_view(studies::answerText(analysis::featureTable(result), features)));
    return kDone;
  } catch (...) {
    // Without a results file the other program would stop as a whole.
    writeDurably(driven.results, std::string_view(studies::kFailedAnswer));
    throw;
  }
}

}  // namespace squat::commands
