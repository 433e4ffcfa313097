#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "analysis/OptionText.h"
#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/DetectInParts.h"
#include "commands/DetectionSummary.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/OutputFolder.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "detection/DetectionFiles.h"
#include "detection/MakeExamples.h"
#include "studies/Jobs.h"

namespace squat::commands {

namespace {

struct DetectCommandOptions {
  std::vector<std::string> files;
  std::string folder, chainage, examples, labels, partition;
  CaseOptions caseOptions;
  SignalOptions signal;
  FigureChoice figures;
  detection::DetectOptions detect;
  detection::JudgementOptions judgement;
  double diameter = 0;  // [m] of the wheel
  bool json = false, collect = false;
};

// Where the vehicle is the one at hand: less of each.
constexpr double ownSpread = 0.12, ownCommonSpread = 0.05, ownSizeSpread = 0.2;
constexpr double labelWeight = 5;

std::string generalExamples() { return (cases::resourcesFolder() / "detection/examples.csv").string(); }

// A path, or the name of a shipped record.
std::string recordFile(const std::string& nameOrPath) {
  if (std::filesystem::exists(nameOrPath) || nameOrPath.find('/') != std::string::npos) return nameOrPath;
  const auto shipped = cases::resourcesFolder() / "records" / (nameOrPath + ".csv");
  return std::filesystem::exists(shipped) ? shipped.string() : nameOrPath;
}

// Median speed of the records' events, or of the call: what examples are computed at.
double typicalSpeed(const std::vector<detection::RecordDetection>& records) {
  std::vector<double> speeds;
  for (const auto& record : records)
    for (const auto& channel : record.channels)
      for (const auto& event : channel.events) speeds.push_back(event.features.speed);
  if (speeds.empty()) return 0;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return std::round(*middle);  // so that the next record of this train finds them again
}

// --case: computed once and kept beside the other files. Nothing where it was cancelled.
std::optional<std::vector<detection::Example>> ownExamples(const DetectCommandOptions& options, double speed,
                                                           Monitor& monitor) {
  auto description = readCase(options.caseOptions);
  if (speed > 0) description.motion.speed = speed, description.motion.angularVelocity = 0;
  const auto file = options.folder + "/" + cases::caseStem(options.caseOptions.name) + "-" +
                    cases::caseHash(description) + ".examples.csv";
  if (std::filesystem::exists(file)) return detection::readExamples(file);
  monitor.message("computing the examples of this vehicle and track, kept in " + file);
  detection::ExampleOptions make;
  make.jobs = studies::coresHere();
  auto made = detection::makeExamples(description, make, monitor);
  if (made) writeDurably(file, detection::examplesText(*made));
  return made;
}

std::optional<double> chainageFrom(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return analysis::chainageFromText(text);
}

// Examples, where they come from, and how wide they scatter.
struct Source {
  std::vector<detection::Example> examples;
  std::string words;
};

std::optional<Source> sourceOf(DetectCommandOptions& options, const std::vector<detection::RecordDetection>& records,
                               Monitor& monitor) {
  Source source;
  if (!options.caseOptions.name.empty()) {
    auto own = ownExamples(options, typicalSpeed(records), monitor);
    if (!own) return std::nullopt;
    source.examples = *std::move(own);
    source.words = "passages of the case " + options.caseOptions.name;
    options.judgement.spread = ownSpread, options.judgement.commonSpread = ownCommonSpread;
    options.judgement.sizeSpread = ownSizeSpread;
  } else {
    const auto file = options.examples.empty() ? generalExamples() : options.examples;
    source.examples = detection::readExamples(file);
    source.words = options.examples.empty()
                       ? "passages of other vehicles and tracks: severities are uncertain, --case narrows them"
                       : file;
  }
  if (options.labels.empty()) return source;
  const auto labels = detection::readLabels(options.labels);
  std::size_t missed = 0;
  for (const auto& record : records)
    for (auto& example : detection::labelled(record, labels, labelWeight, missed)) source.examples.push_back(example);
  source.words += ", and " + std::to_string(labels.size()) + " labels of " + options.labels;
  return source;
}

RecordSearch searchOf(const DetectCommandOptions& options) {
  RecordSearch search;
  for (const auto& file : options.files) search.records.push_back(recordFile(file));
  search.folder = options.folder;
  search.read.columns = fileOptions(options.signal);
  if (search.read.columns.column.empty()) search.read.columns.column = "all";
  search.read.chainage = chainageFrom(options.chainage);
  search.options = options.detect;
  return search;
}

// Judges the records, combines their passes, and writes the list.
int conclude(DetectCommandOptions& options, std::vector<detection::RecordDetection> records, TerminalMonitor& monitor) {
  const auto source = sourceOf(options, records, monitor);
  monitor.clearLine();
  if (!source) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  detection::DetectionReport report;
  report.records = std::move(records);
  report.examples = source->words;
  const detection::Judge judge(source->examples, options.judgement);
  for (auto& record : report.records) {
    detection::judgeCandidates(record, judge, options.detect);
    printFaults(record);
  }
  report.events = detection::combine(report.records);
  if (options.json)
    std::printf("%s", detection::detectionJson(report).c_str());
  else
    printEvents(report);
  std::FILE* const list = options.json ? stderr : stdout;
  std::fprintf(list, "\nwritten:\n");
  for (const auto& path : detection::writeDetection(report, options.folder)) std::fprintf(list, "  %s\n", path.c_str());
  for (const auto& path : writeDetectionFigures(report, options.folder, options.figures))
    std::fprintf(list, "  %s\n", path.c_str());
  return kDone;
}

int detect(DetectCommandOptions options) {
  if (options.diameter > 0) options.detect.surroundings.circumference = M_PI * options.diameter;
  if (options.folder.empty()) options.folder = ".";
  const auto search = searchOf(options);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr, ::isatty(STDERR_FILENO) != 0);
  if (!options.partition.empty()) return searchPart(search, studies::partitionFromText(options.partition), monitor);

  const OutputFolder folder(options.folder);
  const FolderLock owner(options.folder, "squat detect");
  squat::keepInputs(search.records, {options.folder + "/squats.csv", options.folder + "/squats.json"});
  if (options.collect) return conclude(options, collectRecords(search), monitor);
  std::vector<detection::RecordDetection> records;
  for (const auto& file : search.records) {
    const auto stream = records::openRecord(file, search.read);
    records.push_back(detection::findCandidates(*stream, search.options, monitor));
    if (!records.back().cancelled) continue;
    monitor.clearLine();
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  return conclude(options, std::move(records), monitor);
}

}  // namespace

void addDetectCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("detect", "Find squats in long records of axle box acceleration");
  auto options = std::make_shared<DetectCommandOptions>();
  command
      ->add_option("records", options->files, "Files, or the shipped example-record; several of one place are combined")
      ->required()
      ->type_name("RECORD...");
  command->add_option("-o,--output", options->folder, "Output folder (default: current folder)")->type_name("DIR");
  addSignalOptions(*command, options->signal);
  command->add_option("--chainage", options->chainage, "Of the first sample: metres, \"12.3 km\" or 12+300")
      ->type_name("PLACE");
  command
      ->add_option("--case", options->caseOptions.name,
                   "Judge kinds and severities by passages of this vehicle and track (default: general thresholds)")
      ->type_name("CASE");
  command->add_option("--mesh", options->caseOptions.mesh, "Mesh of the passages of --case (default: tiny)")
      ->type_name("PRESET");
  command->add_option("--set", options->caseOptions.sets, "Set one key of --case, as in squat run; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--examples", options->examples, "Table of squat examples (default: the shipped one)")
      ->type_name("FILE");
  command->add_option("--labels", options->labels, "Events that you know: position, kind, severity or length and depth")
      ->type_name("FILE");
  command
      ->add_option("--wheel-diameter", options->diameter,
                   "Diameter of the wheel in metres, for wheel flats (default: found from the record)")
      ->check(between(0.3, 1.5))
      ->type_name("M");
  command->add_option("--threshold", options->detect.threshold, "Evidence that makes an event (default: 14)")
      ->check(between(1.0, 1e6))
      ->type_name("N");
  command->add_option("--threads", options->detect.threads, "Threads (default: all cores)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  auto* partition = command
                        ->add_option("--partition", options->partition,
                                     "Search only the M-th of N parts of the records, and keep what is found in "
                                     "DIR/candidates: slice (every N-th record) or hash (by their names)")
                        ->type_name("KIND:M/N");
  command->add_flag("--collect", options->collect, "Search no record: judge and combine what all parts have found")
      ->excludes(partition);
  addFigureOptions(*command, options->figures);
  command->add_flag("--json", options->json, "Print the list as JSON");
  options->caseOptions.mesh = "tiny";
  command->callback([options, &action] { action = [options] { return detect(*options); }; });
}

}  // namespace squat::commands
