#include "detection/ExampleSource.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "core/DurableFile.h"
#include "detection/ChannelNotes.h"
#include "detection/MakeExamples.h"
#include "detection/Sides.h"
#include "detection/Stretches.h"

namespace squat::detection {

namespace {

// Where the vehicle is the one at hand: less of each.
constexpr double kOwnSpread = 0.12, kOwnCommonSpread = 0.05, kOwnSizeSpread = 0.2;
constexpr double kLabelWeight = 5;

std::string generalExamples() { return (cases::resourcesFolder() / "detection/examples.csv").string(); }

// Median speed of the records' events, or 0: what examples are computed at.
double typicalSpeed(const std::vector<RecordDetection>& records) {
  std::vector<double> speeds;
  for (const auto& record : records)
    for (const auto& channel : record.channels)
      for (const auto& event : channel.events) speeds.push_back(event.features.speed);
  if (speeds.empty()) return 0;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return std::round(*middle);  // so that the next record of this train finds them again
}

bool isOfOneVehicle(const std::vector<Example>& examples) {
  return std::all_of(examples.begin(), examples.end(),
                     [&](const Example& each) { return each.vehicle == examples.front().vehicle; });
}

std::optional<std::vector<Example>> ownExamples(const SourceOptions& options, double speed, Monitor& monitor) {
  auto description = *options.vehicle;
  if (speed > 0) description.motion.speed = speed, description.motion.angularVelocity = 0;
  const auto file = options.folder + "/" + cases::caseStem(options.vehicleName) + "-" + cases::caseHash(description) +
                    ".examples.csv";
  if (std::filesystem::exists(file)) return readExamples(file);
  monitor.message("computing the examples of this vehicle and track, kept in " + file);
  ExampleOptions make;
  make.jobs = options.jobs;
  auto made = makeExamples(description, make, monitor);
  if (made) writeDurably(file, examplesText(*made));
  return made;
}

// Squats tell something where their size is known, all else by its kind.
void learn(Example example, ExampleSource& source) {
  const bool isSquat = example.kind == Kind::squat;
  if (isSquat && !hasSize(example)) return;
  source.learned.push_back(example);
  if (isSquat) source.own.push_back(example), ++source.ownFromLabels;
  source.examples.push_back(std::move(example)), ++source.fromLabels;
}

// Whether a list has the example already, as from a record that is searched once more.
bool holds(const std::vector<Example>& examples, const Example& example) {
  return std::any_of(examples.begin(), examples.end(),
                     [&](const Example& each) { return each.speed == example.speed && each.energy == example.energy; });
}

// Records of one location share their labels, whose positions are those of the first; records of other locations do
// not: a label is missed where no record has its event.
// `earlier`: examples learned before; those of the same events give way.
void addLabels(const std::vector<Label>& labels, const std::string& file, std::vector<RecordDetection>& records,
               std::vector<Example>& earlier, ExampleSource& source) {
  std::vector<bool> isFound(labels.size(), false);
  const auto shifts = shiftsOntoFirst(records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    auto& record = records[r];
    const auto isHere = attachLabels(record, labels, shifts[r]);
    for (std::size_t i = 0; i < labels.size(); ++i) isFound[i] = isFound[i] || isHere[i];
    for (auto& example : labelledExamples(record, kLabelWeight)) {
      std::erase_if(earlier, [&](const Example& each) { return holds({example}, each); });
      learn(std::move(example), source);
    }
  }
  source.words += ", and " + std::to_string(labels.size()) + (labels.size() == 1 ? " label of " : " labels of ") + file;
  const auto missed = std::count(isFound.begin(), isFound.end(), false);
  if (missed > 0) source.words += " (" + std::to_string(missed) + " without an event within 0.5 m)";
}

// What concerns more than a metre, and what is to be said of each channel.
void addStretchesAndNotes(DetectionReport& report, const DetectOptions& options) {
  for (auto& record : report.records)
    for (const auto& channel : record.channels)
      for (auto& note : channelNotes(channel, options)) record.notes.push_back(std::move(note));
  for (auto& stretch : combinedStretches(report.records, shiftsOntoFirst(report.records)))
    report.events.push_back(std::move(stretch));
  std::stable_sort(report.events.begin(), report.events.end(),
                   [](const CombinedEvent& a, const CombinedEvent& b) { return a.event.position < b.event.position; });
}

// As if there were no labels: the events keep theirs, which decide nothing for others then.
std::optional<std::vector<RecordDetection>> judgedWithoutLabels(std::vector<RecordDetection> records,
                                                                const ExampleSource& source,
                                                                const DetectOptions& options, Monitor& monitor) {
  auto examples = source.examples, own = source.own;
  examples.resize(examples.size() - source.fromLabels), own.resize(own.size() - source.ownFromLabels);
  for (auto& record : records)
    for (auto& channel : record.channels)
      for (auto& event : channel.events) event.label.reset();
  const Judge judge(std::move(examples), source.judgement, source.sizes, std::move(own));
  for (auto& record : records)
    if (!judgeCandidates(record, judge, options, monitor)) return std::nullopt;
  return records;
}

bool hasLabels(const std::vector<RecordDetection>& records) {
  for (const auto& record : records)
    for (const auto& channel : record.channels)
      for (const auto& event : channel.events)
        if (event.label) return true;
  return false;
}

struct Changes {
  std::size_t events = 0, kinds = 0, severities = 0;  // of those without a label
};

Changes changesBetween(const std::vector<RecordDetection>& before, const std::vector<RecordDetection>& after) {
  Changes changes;
  for (std::size_t r = 0; r < after.size(); ++r)
    for (std::size_t c = 0; c < after[r].channels.size(); ++c) {
      std::map<double, const Event*> all;
      for (const auto& event : before[r].channels[c].events) all.emplace(event.time, &event);
      for (const auto& event : after[r].channels[c].events) {
        if (event.label) continue;
        ++changes.events;
        const auto same = all.find(event.time);
        if (same == all.end() || same->second->kind != event.kind)
          ++changes.kinds;
        else if (event.kind == Kind::squat && same->second->judgement.severity != event.judgement.severity)
          ++changes.severities;
      }
    }
  return changes;
}

std::string changesText(const Changes& changes) {
  return "of the " + std::to_string(changes.events) + " events without a label, labels changed the kind of " +
         std::to_string(changes.kinds) + " and the severity of " + std::to_string(changes.severities);
}

}  // namespace

std::optional<ExampleSource> exampleSource(const SourceOptions& options, std::vector<RecordDetection>& records,
                                           Monitor& monitor) {
  ExampleSource source;
  source.judgement.limits = options.limits;
  if (options.vehicle) {
    auto own = ownExamples(options, typicalSpeed(records), monitor);
    if (!own) return std::nullopt;
    source.examples = *std::move(own);
    source.words = "passages of the case " + options.vehicleName;
    source.judgement.spread = kOwnSpread, source.judgement.commonSpread = kOwnCommonSpread;
    source.judgement.sizeSpread = kOwnSizeSpread;
  } else {
    source.examples = readExamples(options.examplesFile.empty() ? generalExamples() : options.examplesFile);
    source.words = options.examplesFile.empty()
                       ? "passages of other vehicles and tracks: severities are uncertain, --case narrows them"
                       : options.examplesFile;
  }
  source.sizes = SizeModel(source.examples);
  if (isOfOneVehicle(source.examples)) source.own = source.examples;
  const bool hasAxles =
      std::any_of(records.begin(), records.end(), [](const auto& record) { return !record.axles.empty(); });
  if (hasAxles || !source.sizes.isKnown()) {
    const auto general = readExamples(generalExamples());
    if (hasAxles) source.sides = AxleSides(general);
    if (!source.sizes.isKnown()) source.sizes = SizeModel(general);
  }
  std::vector<Example> earlier;
  const bool mayBeNew = !options.labelsFile.empty();
  if (!options.learnedFile.empty() && (!mayBeNew || std::filesystem::exists(options.learnedFile)))
    earlier = readExamples(options.learnedFile);
  if (!options.labelsFile.empty())
    addLabels(readLabels(options.labelsFile), options.labelsFile, records, earlier, source);
  if (!earlier.empty())
    source.words += ", and " + std::to_string(earlier.size()) + " learned earlier (" + options.learnedFile + ")";
  for (auto& example : earlier) learn(std::move(example), source);
  return source;
}

void keepLearned(const ExampleSource& source, const std::string& path) {
  if (!source.learned.empty()) writeDurably(path, examplesText(source.learned));
}

std::optional<DetectionReport> judged(std::vector<RecordDetection> records, const ExampleSource& source,
                                      const DetectOptions& options, Monitor& monitor) {
  DetectionReport report;
  std::optional<std::vector<RecordDetection>> before;
  if (hasLabels(records) || source.fromLabels > 0) {
    before = judgedWithoutLabels(records, source, options, monitor);
    if (!before) return std::nullopt;
  }
  report.records = std::move(records);
  report.examples = source.words;
  report.limits = source.judgement.limits;
  const Judge judge(source.examples, source.judgement, source.sizes, source.own);
  for (auto& record : report.records)
    if (!judgeCandidates(record, judge, options, monitor)) return std::nullopt;
  for (auto& record : report.records) judgeSides(record, source.sides);
  if (before) report.notes.push_back(changesText(changesBetween(*before, report.records)));
  report.events = combine(report.records);
  addStretchesAndNotes(report, options);
  return report;
}

}  // namespace squat::detection
