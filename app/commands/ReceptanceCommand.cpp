#include <cstdio>
#include <map>
#include <optional>

#include "case/Resolve.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "receptance/DecayFiles.h"
#include "receptance/ReceptanceFiles.h"
#include "receptance/ReceptanceSummary.h"
#include "text/Numbers.h"

namespace squat::commands {

namespace {

struct ReceptanceCommandOptions {
  CaseOptions caseOptions;
  std::string folder = ".";
  receptance::ReceptanceOptions receptance;
  receptance::ReceptanceQuantity quantity = receptance::ReceptanceQuantity::receptance;
  std::vector<double> at;
  double struck = 0;
  bool between = false, lateral = false, oneRail = false, decay = false, sleeper = false;
  std::string measured;
  FigureChoice figures;
};

// One place for each position that is asked for; without any, over a sleeper and at midspan.
std::vector<receptance::ReceptancePlace> placesOf(const ReceptanceCommandOptions& options, double spacing) {
  const auto direction = options.lateral ? receptance::RailDirection::lateral : receptance::RailDirection::vertical;
  const std::string way = options.lateral ? "lateral, " : "";
  std::vector<receptance::ReceptancePlace> places;
  for (const double x : options.at) {
    const auto position = text::numberText(x) + " m";
    if (options.between)
      places.push_back({way + "at " + position + " struck at " + text::numberText(options.struck) + " m",
                        options.struck, x, direction});
    else
      places.push_back({way + "at " + position, x, x, direction});
  }
  if (places.empty()) {
    const double midspan = -spacing / 2;
    for (const auto& [name, x] : {std::pair{"over a sleeper", 0.0}, std::pair{"midspan", midspan}})
      places.push_back({way + name, options.between ? options.struck : x, x, direction});
  }
  return places;
}

void printReceptanceFiles(const std::vector<std::string>& files) {
  std::printf("\nwritten:\n");
  for (const auto& path : files) std::printf("  %s\n", path.c_str());
}

int receptanceCancelled() {
  std::fprintf(stderr, "cancelled: no file written\n");
  return kCancelled;
}

int computeDecay(const ReceptanceCommandOptions& options) {
  const auto description = readCase(options.caseOptions);
  const auto name = stemOf(options.caseOptions) + "-decay-rate";
  const std::string table = options.folder + "/" + name + ".csv";
  std::optional<receptance::MeasuredDecayRates> measured;
  if (!options.measured.empty()) measured = receptance::readMeasuredDecayRates(options.measured);
  auto inputs = cases::filesOfCase(options.caseOptions.name, description);
  if (measured) inputs.push_back(options.measured);
  keepInputs(inputs, {table});
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  receptance::DecayOptions decay;
  decay.track.threads = options.receptance.threads;
  const auto rates = receptance::trackDecayRates(cases::resolve(description), decay, monitor);
  monitor.clearLine();
  if (!rates.complete) return receptanceCancelled();
  const auto* beside = measured ? &*measured : nullptr;
  std::printf("%s", receptance::decaySummary(rates, beside).c_str());
  writeDurably(table, std::string_view(receptance::decayCsv(rates, beside)));
  std::vector<std::string> files{table};
  for (const auto& path : writeDecayFigure(rates, beside, name, description.title, cases::caseHash(description),
                                           options.folder, options.figures))
    files.push_back(path);
  printReceptanceFiles(files);
  return kDone;
}

int computeReceptance(const ReceptanceCommandOptions& options) {
  if (options.decay) return computeDecay(options);
  const auto description = readCase(options.caseOptions);
  const auto name = stemOf(options.caseOptions), stem = options.folder + "/" + name;
  const auto tables = receptance::receptanceFiles(stem);
  keepInputs(cases::filesOfCase(options.caseOptions.name, description), tables);
  const OutputFolder folder(options.folder);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  auto asked = options.receptance;
  asked.places = placesOf(options, description.track.sleeperSpacing);
  asked.rails = options.oneRail ? receptance::StruckRails::one : receptance::StruckRails::both;
  const auto scenario = cases::resolve(description);
  const auto result = options.sleeper ? receptance::sleeperByItself(scenario, asked, monitor)
                                      : receptance::trackReceptance(scenario, asked, monitor);
  monitor.clearLine();
  if (!result.complete) return receptanceCancelled();
  std::printf("%s", receptance::receptanceSummary(result, options.quantity).c_str());
  receptance::writeReceptanceFiles(stem, result, cases::writeCase(description), options.quantity);
  auto files = tables;
  for (const auto& path :
       writeReceptanceFigure(result, name + "-receptance", description.title, cases::caseHash(description),
                             options.quantity, options.folder, options.figures))
    files.push_back(path);
  printReceptanceFiles(files);
  return kDone;
}

void addPlaces(CLI::App& command, ReceptanceCommandOptions& options) {
  auto* at = command.add_option("--at", options.at,
                                "Positions [m] from the sleeper in the middle of the track (default: over it and at "
                                "midspan)");
  at->type_name("X")->delimiter(',');
  auto* struck = command.add_option("--struck", options.struck,
                                    "Strike the rail at this position [m] and read it at those of --at (default: "
                                    "strike where it is read)");
  struck->type_name("X")->each([&options](const std::string&) { options.between = true; });
  command.add_flag("--lateral", options.lateral, "Strike and read the rail's head sideways, not downwards");
  command.add_flag("--one-rail", options.oneRail,
                   "Strike one rail, as a hammer does (default: both alike, as in a rolling run)");
  command.add_flag("--endless", options.receptance.endless,
                   "Take an endless track of equal bays in place of the case's length, whose ends reflect waves");
}

void addFrequencies(CLI::App& command, ReceptanceCommandOptions& options) {
  auto& asked = options.receptance;
  command.add_option("--from", asked.lowest, "Lowest frequency [Hz] (default: 50)")
      ->type_name("HZ")
      ->check(CLI::Range(1.0, 5000.0));
  command.add_option("--to", asked.highest, "Highest frequency [Hz] (default: 2000)")
      ->type_name("HZ")
      ->check(CLI::Range(10.0, 10000.0));
  command
      .add_option("--step", asked.frequencyStep,
                  "Step [Hz] (default: 1); an endless track has 24 frequencies in each third octave instead")
      ->type_name("HZ")
      ->check(CLI::Range(0.01, 1000.0));
  const std::map<std::string, receptance::ReceptanceQuantity> quantities{
      {"receptance", receptance::ReceptanceQuantity::receptance},
      {"mobility", receptance::ReceptanceQuantity::mobility},
      {"accelerance", receptance::ReceptanceQuantity::accelerance}};
  CLI::CheckedTransformer named(quantities);
  named.description("");  // the help has the names in its own words
  command
      .add_option("--quantity", options.quantity,
                  "Displacement, velocity or acceleration over force: receptance (default), mobility or accelerance")
      ->type_name("NAME")
      ->transform(named);
}

}  // namespace

void addReceptanceCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "receptance", "Compute the track receptance, its decay rates and the natural modes of the wheelset");
  auto options = std::make_shared<ReceptanceCommandOptions>();
  addCaseOptions(*command, options->caseOptions);
  addName(*command, options->caseOptions);
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addPlaces(*command, *options);
  addFrequencies(*command, *options);
  auto* decay = command->add_flag(
      "--decay", options->decay,
      "Compute the track decay rates after EN 15461 instead, vertical and lateral, 100 to 5000 Hz, one rail struck");
  command
      ->add_option("--measured", options->measured,
                   "With --decay: table of measured decay rates to stand beside the computed ones")
      ->type_name("FILE")
      ->needs(decay);
  auto* sleeper =
      command
          ->add_flag("--sleeper", options->sleeper,
                     "Compute the receptance of a sleeper by itself on its ballast at the rail seat instead")
          ->excludes(decay);
  // What has no effect is refused.
  for (const char* name : {"--at", "--struck", "--lateral", "--endless", "--step"})
    command->get_option(name)->excludes(decay)->excludes(sleeper);
  for (const char* name : {"--one-rail", "--from", "--to", "--quantity"}) command->get_option(name)->excludes(decay);
  command->get_option("--step")->excludes(command->get_option("--endless"));
  addThreads(*command, options->receptance.threads);
  addFigureOptions(*command, options->figures);
  command->callback([options, &action] {
    if (!(options->receptance.lowest < options->receptance.highest))
      throw CLI::ValidationError("--to", "must be above --from");
    action = [options] { return computeReceptance(*options); };
  });
}

}  // namespace squat::commands
