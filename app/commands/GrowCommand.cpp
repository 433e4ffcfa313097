#include <cstdio>
#include <filesystem>
#include <optional>

#include "case/CaseDescription.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "growth/ComputeForecast.h"
#include "growth/GrowthFiles.h"
#include "results/Checkpoint.h"
#include "text/Numbers.h"

namespace squat::commands {

namespace {

struct GrowCommandOptions {
  CaseOptions caseOptions;
  std::string folder = ".", until;
  double tonnage = 0;  // [Mt]
  std::vector<std::string> grind;
  FigureChoice figures;
  growth::GrowthOptions growth;
  growth::ForecastRequest forecast;
};

// "0.2@10Mt"
growth::Grinding grindingFrom(const std::string& words) {
  const auto at = words.find('@');
  const auto depth = text::numberIn(words.substr(0, at), '.');
  std::string when = at == std::string::npos ? "" : words.substr(at + 1);
  if (when.ends_with("Mt")) when.resize(when.size() - 2);
  const auto tonnage = text::numberIn(when, '.');
  if (!depth || !tonnage)
    throw CaseError({{"--grind", words, "DEPTH@TONNAGE in mm and Mt", "Write for example 0.2@10Mt"}});
  return {*depth * 1e-3, *tonnage * growth::kilogramsInMegatonne};
}

// "depth=0.5"
double depthFrom(const std::string& words) {
  const std::string name = "depth=";
  const auto depth = words.starts_with(name) ? text::numberIn(words.substr(name.size()), '.') : std::nullopt;
  if (!depth || *depth <= 0)
    throw CaseError({{"--until", words, "depth=MILLIMETRES, above 0", "Write for example depth=0.5"}});
  return *depth * 1e-3;
}

// A checkpoint is hours of work: it is not replaced unasked.
void keepCheckpoint(const GrowCommandOptions& options, const std::string& path) {
  if (options.growth.resume || !std::filesystem::exists(path)) return;
  throw CaseError({{"-o", path, "a folder without the checkpoint of an unfinished growth or forecast",
                    "Resume it with --resume, choose another folder or --name, or remove the file"}});
}

int cancelled(const std::string& checkpoint) {
  std::fprintf(stderr, std::filesystem::exists(checkpoint) ? "cancelled: resume with --resume\n"
                                                           : "cancelled: nothing was computed that could be resumed\n");
  return kCancelled;
}

int writeForecast(const GrowCommandOptions& options, const growth::ForecastPlan& plan, TerminalMonitor& monitor) {
  const auto forecast = growth::forecastGrowth(plan, monitor);
  monitor.clearLine();
  if (!forecast) return cancelled(options.growth.checkpoint);
  const auto stem = stemOf(options.caseOptions);
  const auto path = growth::forecastFiles(options.folder, stem).table;
  writeDurably(path, growth::forecastTable(*forecast));
  std::printf("\n%s\nwritten:\n  %s\n", growth::forecastText(*forecast).c_str(), path.c_str());
  if (forecast->growths < forecast->asked)
    std::fprintf(stderr, "some growths failed: repeat the call with --resume to compute them again\n");
  if (forecast->growths == 0) return kRunFailed;
  for (const auto& figure : writeForecastFigure(*forecast, stem, options.folder, options.figures))
    std::printf("  %s\n", figure.c_str());
  return forecast->growths < forecast->asked ? kRunFailed : kDone;
}

int grow(GrowCommandOptions options) {
  const auto description = readCase(options.caseOptions);
  auto& growth = options.growth;
  growth.tonnage = options.tonnage * growth::kilogramsInMegatonne;
  for (const auto& words : options.grind) growth.grindings.push_back(grindingFrom(words));
  if (!options.until.empty()) growth.untilDepth = depthFrom(options.until);
  const auto stem = stemOf(options.caseOptions);
  const auto& folder = options.folder;
  keepInputs(cases::filesOfCase(options.caseOptions.name, description), growth::growthFiles(folder, stem));
  std::optional<growth::ForecastPlan> plan;
  if (!options.forecast.uncertain.empty())
    plan = growth::forecastPlan(options.caseOptions.name, caseOverrides(options.caseOptions), options.forecast, growth,
                                growth::forecastFiles(folder, stem).folder);
  growth.checkpoint = growth::growthCheckpoint(folder, stem);
  const OutputFolder output(folder);
  const FolderLock owner(folder, "squat grow " + options.caseOptions.name);
  keepCheckpoint(options, growth.checkpoint);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  growth.finishedStage = [&](const growth::Stage& stage) { monitor.message(growth::stageLine(stage)); };
  const auto grown = growth::grow(description, growth, monitor);
  monitor.clearLine();
  for (const auto& warning : grown.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  std::printf("%s", growth::growthSummary(grown, growth).c_str());
  const auto written = growth::writeGrowthFiles(grown, folder, stem);
  if (!written.empty()) std::printf("\nwritten:\n");
  for (const auto& path : written) std::printf("  %s\n", path.c_str());
  if (!grown.complete) return cancelled(growth.checkpoint);
  for (const auto& path : writeGrowthFigures(grown, stem, folder, options.figures)) std::printf("  %s\n", path.c_str());
  const int code = plan ? writeForecast(options, *plan, monitor) : kDone;
  if (code == kDone) results::removeCheckpoint(growth.checkpoint);
  return code;
}

}  // namespace

void addGrowCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("grow", "Let a defect grow under traffic: wear and plastic flow, block by block");
  auto options = std::make_shared<GrowCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions);
  command->add_option("--tonnage", options->tonnage, "Traffic in millions of tonnes")->required()->type_name("MT");
  command->add_option("--until", options->until, "End once the dip is this deep, in mm")->type_name("depth=MM");
  command
      ->add_option("--grind", options->grind,
                   "Take this many mm off the whole rail after so many millions of tonnes: 0.2@10Mt; repeatable")
      ->allow_extra_args(false)
      ->type_name("MM@MT");
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addThreads(*command, options->growth.threads);
  addInstructionSet(*command, options->growth.isa);
  command->add_flag("--resume", options->growth.resume, "Resume from the checkpoint, if there is one");
  addFigureOptions(*command, options->figures);
  auto* uncertain = command
                        ->add_option("--uncertain", options->forecast.uncertain,
                                     "Forecast: grow again with this key between two limits, KEY=LOW:HIGH; repeatable")
                        ->allow_extra_args(false)
                        ->type_name("KEY=LOW:HIGH");
  command->add_option("--growths", options->forecast.growths, "Number of growths of the forecast (default: 8)")
      ->check(CLI::Range(2, 1000))
      ->type_name("N")
      ->needs(uncertain);
  command->footer(
      "Wear needs nothing but the case; plastic flow needs rail.plastic, for example --set rail.preset=R260.\n"
      "Keys of the traffic and of wear: growth.* (squat describe).");
  command->callback([options, &action] { action = [options] { return grow(*options); }; });
}

}  // namespace squat::commands
