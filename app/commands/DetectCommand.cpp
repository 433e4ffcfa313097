#include <cmath>
#include <cstdio>
#include <numbers>

#include "analysis/OptionText.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/DetectInParts.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/OutputFolder.h"
#include "commands/RoughnessOptions.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "detection/DetectionFiles.h"
#include "detection/DetectionSummary.h"
#include "detection/ExampleSource.h"
#include "detection/RcmDxEvents.h"
#include "roughness/RecordRoughness.h"
#include "studies/Jobs.h"

namespace squat::commands {

namespace {

struct DetectCommandOptions {
  std::vector<std::string> files;
  std::vector<std::string> axles;
  std::string folder, chainage, examples, labels, learned, partition, light, moderate;
  CaseOptions caseOptions;
  SignalOptions signal;
  FigureChoice figures;
  RoughnessOptions roughness;
  detection::DetectOptions detect;
  detection::SeverityLimits limits;
  double diameter = 0;  // [m] of the wheel
  bool json = false, collect = false, consecutive = false, passes = false;
};

std::optional<double> chainageFrom(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return analysis::chainageFromText(text);
}

detection::SourceOptions sourceOf(const DetectCommandOptions& options) {
  detection::SourceOptions source;
  if (!options.caseOptions.name.empty()) source.vehicle = readCase(options.caseOptions);
  source.vehicleName = options.caseOptions.name;
  source.folder = options.folder;
  source.examplesFile = options.examples, source.labelsFile = options.labels;
  source.learnedFile = options.learned;
  source.limits = options.limits;
  source.jobs = studies::coresHere();
  return source;
}

records::Together togetherOf(const DetectCommandOptions& options) {
  return options.consecutive ? records::Together::consecutive
         : options.passes    ? records::Together::passes
                             : records::Together::asTheyFollow;
}

RecordSearch searchOf(const DetectCommandOptions& options) {
  RecordSearch search;
  for (const auto& file : options.files) search.records.push_back(recordFile(file));
  search.records = records::inNumberOrder(std::move(search.records));
  search.folder = options.folder;
  search.read.columns = fileOptions(options.signal);
  search.read.everyAcceleration = true;
  search.read.chainage = chainageFrom(options.chainage);
  search.options = options.detect;
  return search;
}

// Judges the records, combines their passes, and writes the list.
int conclude(const DetectCommandOptions& options, std::vector<detection::RecordDetection> records,
             TerminalMonitor& monitor) {
  const auto source = detection::exampleSource(sourceOf(options), records, monitor);
  const auto judged = source ? detection::judged(std::move(records), *source, options.detect, monitor) : std::nullopt;
  monitor.clearLine();
  if (!judged) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  const auto& report = *judged;
  for (const auto& record : report.records) std::fprintf(stderr, "%s", detection::faultText(record).c_str());
  if (options.json)
    std::printf("%s", detection::detectionJson(report).c_str());
  else
    std::printf("%s", detection::detectionSummary(report).c_str());
  std::FILE* const list = options.json ? stderr : stdout;
  std::fprintf(list, "\nwritten:\n");
  for (const auto& path : detection::writeDetection(report, options.folder)) std::fprintf(list, "  %s\n", path.c_str());
  for (const auto& path : detection::writeRcmDxEvents(report, fileOptions(options.signal), options.folder))
    std::fprintf(list, "  %s\n", path.c_str());
  for (const auto& path : writeDetectionFigures(report, options.folder, options.figures))
    std::fprintf(list, "  %s\n", path.c_str());
  if (options.learned.empty() || options.labels.empty()) return kDone;
  detection::keepLearned(*source, options.learned);
  if (source->learned.empty())
    std::fprintf(stderr, "%s is not written: no labelled event serves as an example (squats need length and depth)\n",
                 options.learned.c_str());
  else
    std::fprintf(list, "  %s (labelled events: %zu)\n", options.learned.c_str(), source->learned.size());
  return kDone;
}

int notWritten(TerminalMonitor& monitor) {
  monitor.clearLine();
  std::fprintf(stderr, "cancelled: no file written\n");
  return kCancelled;
}

int detect(DetectCommandOptions options) {
  if (options.diameter > 0) options.detect.surroundings.circumference = std::numbers::pi * options.diameter;
  if (options.folder.empty()) options.folder = ".";
  options.detect.axles = detection::axleNamesFromText(options.axles);
  options.limits = detection::severityLimitsFromText(options.light, options.moderate);
  const auto search = searchOf(options);
  if (!options.learned.empty() && options.labels.empty()) detection::readExamples(options.learned);  // before the work
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  if (options.roughness.asked()) gaugeOptions(options.roughness);  // what is wrong with it is said before the work
  if (!options.partition.empty()) return searchPart(search, studies::partitionFromText(options.partition), monitor);

  const OutputFolder folder(options.folder);
  const FolderLock owner(options.folder, "squat detect");
  keepInputs(search.records, {options.learned, options.folder + "/squats.csv", options.folder + "/squats.json",
                              options.folder + "/squats.rcmdx"});
  if (options.collect) return conclude(options, collectRecords(search), monitor);
  roughness::TransferFunction transfer;
  if (options.roughness.asked()) {
    transfer = transferFunctionOf(options.roughness, options.detect.threads, monitor);
    if (!transfer.complete) return notWritten(monitor);
  }
  std::vector<roughness::NamedRoughness> rough;
  std::vector<detection::RecordDetection> records;
  for (auto rest = search.records; !rest.empty();) {
    auto stream = records::openRide(rest, search.read, togetherOf(options));
    roughness::GaugedStream* gauged = nullptr;
    if (transfer.complete) {
      auto own =
          std::make_unique<roughness::GaugedStream>(std::move(stream), transfer, gaugeOptions(options.roughness));
      gauged = own.get();
      stream = std::move(own);
    }
    records.push_back(detection::findCandidates(*stream, search.options, monitor));
    if (records.back().cancelled) return notWritten(monitor);
    if (gauged)
      for (auto& each : gauged->finish()) rough.push_back(std::move(each));
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(stream->layout().files.size()));
  }
  const int code = conclude(options, std::move(records), monitor);
  if (code != kDone || rough.empty()) return code;
  std::FILE* const list = options.json ? stderr : stdout;
  printRoughness(rough, list);
  for (const auto& path : writeRoughnessOutput(rough, transfer, options.roughness, options.folder, options.figures))
    std::fprintf(list, "  %s\n", path.c_str());
  return kDone;
}

}  // namespace

void addDetectCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("detect", "Find squats in long records of axle box acceleration");
  auto options = std::make_shared<DetectCommandOptions>();
  command
      ->add_option(
          "records", options->files,
          "Files, or the shipped example-record; those whose times or positions follow on are one ride, others "
          "are passes and combined where they meet")
      ->required()
      ->type_name("RECORD...");
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addSignalOptions(*command, options->signal);
  command->add_option("--chainage", options->chainage, "Of the first sample: metres, \"12.3 km\" or 12+300")
      ->type_name("CHAINAGE");
  command
      ->add_option("--axle", options->axles,
                   "Channels of the left and the right axle box of one wheelset: each event is assigned to a side; a "
                   "name that holds a comma stands in double quotes; repeatable; or none (default: channels whose "
                   "names differ in left and right)")
      ->allow_extra_args(false)
      ->type_name("LEFT,RIGHT");
  auto* vehicle =
      command
          ->add_option("--case", options->caseOptions.name,
                       "Judge kinds and severities by passages of this vehicle and track (default: general thresholds)")
          ->type_name("CASE");
  command->add_option("--mesh", options->caseOptions.mesh, "Mesh of the passages of --case (default: tiny)")
      ->type_name("PRESET")
      ->needs(vehicle);
  command->add_option("--set", options->caseOptions.sets, "Set one key of --case, as in squat run; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE")
      ->needs(vehicle);
  command->add_option("--examples", options->examples, "Table of squat examples (default: the shipped one)")
      ->type_name("FILE")
      ->excludes(vehicle);
  command->add_option("--labels", options->labels, "Events that you know: position, kind, severity or length and depth")
      ->type_name("FILE");
  command
      ->add_option(
          "--learned", options->learned,
          "Labelled events of earlier records of the same train: read if the file exists, extended with --labels")
      ->type_name("FILE");
  command->add_option("--light", options->light, "Longest and deepest light squat in mm (default: 35x0.10)")
      ->type_name("LENGTHxDEPTH");
  command->add_option("--moderate", options->moderate, "The same of a moderate one (default: 60x0.25)")
      ->type_name("LENGTHxDEPTH");
  command
      ->add_option("--wheel-diameter", options->diameter,
                   "Diameter of the wheel in metres, for wheel flats (default: found from the record)")
      ->check(between(0.3, 1.5))
      ->type_name("M");
  command
      ->add_option("--false-alarms", options->detect.falseAlarms,
                   "False alarms a kilometre that are accepted from the background (default: 0.1)")
      ->check(CLI::Range(1e-6, 100.0))
      ->type_name("N");
  command
      ->add_option("--threshold", options->detect.threshold, "Smallest evidence that counts as an event (default: 14)")
      ->check(between(1.0, 1e6))
      ->type_name("N");
  command
      ->add_option("--least-share", options->detect.leastShare,
                   "Share of a record's samples that must be readable (default: 0.9)")
      ->check(between(0.0, 1.0))
      ->type_name("SHARE");
  command->add_option("--threads", options->detect.threads, "Threads (default: all cores)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  auto* partition = command
                        ->add_option("--partition", options->partition,
                                     "Search only the M-th of N parts of the records, and keep what is found in "
                                     "DIR/candidates: slice (every N-th record) or hash (by their names)")
                        ->type_name("KIND:M/N");
  auto* consecutive = command
                          ->add_flag("--consecutive", options->consecutive,
                                     "The files are one ride, in the order of their numbers, else as given")
                          ->excludes(partition);
  command->add_flag("--passes", options->passes, "Every file is a pass by itself")->excludes(consecutive);
  auto* collect =
      command->add_flag("--collect", options->collect, "Search no record: judge and combine what all parts have found")
          ->excludes(partition);
  addRoughnessOptions(*command, options->roughness);
  // Of whole records only: a part keeps candidates, from which no roughness follows.
  command->get_option("--roughness")->excludes(partition)->excludes(collect);
  addFigureOptions(*command, options->figures);
  command->add_flag("--json", options->json, "Print the list as JSON");
  options->caseOptions.mesh = "tiny";
  command->callback([options, &action] { action = [options] { return detect(*options); }; });
}

}  // namespace squat::commands
