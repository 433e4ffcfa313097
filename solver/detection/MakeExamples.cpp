#include "detection/MakeExamples.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/RightSide.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "detection/ExampleDefects.h"
#include "detection/SegmentEvents.h"
#include "signals/Record.h"
#include "signals/SignalCatalogue.h"
#include "simulation/WarmState.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

using Clock = std::chrono::steady_clock;

// Hands on whether to stop or pause; each run's own progress is not reported.
class QuietMonitor : public Monitor {
 public:
  explicit QuietMonitor(Monitor& outer) : outer_(outer) {}
  bool cancelled() override { return outer_.cancelled(); }
  bool paused() override { return outer_.paused(); }

 private:
  Monitor& outer_;
};

// What the example does not state has its default. Where the wheel has a flat, the rail is smooth.
scenario::Defect defectOf(const ExampleDefect& example) {
  const auto& own = example.defect;
  auto defect = cases::defaultCase().defect;
  if (example.kind == Kind::flat) {
    defect.shape = scenario::DefectShape::none;
    return defect;
  }
  defect.shape = own.shape;
  defect.points = own.points;
  if (own.shape == scenario::DefectShape::profile) return defect;
  defect.length = own.length, defect.depth = own.depth;
  if (own.shape == scenario::DefectShape::wshape) defect.middleHeight = own.middleHeight;
  if (own.shape == scenario::DefectShape::dipWithWave)
    defect.waveLength = own.waveLength, defect.waveDepth = own.waveDepth, defect.waveCount = own.waveCount;
  return defect;
}

// The other axle box of a whole model tells of the other rail only where that has no defect.
bool isOnLeftAlone(const cases::CaseDescription& description) {
  return cases::rightOf(description).defect.shape == scenario::DefectShape::none;
}

// A flat is on the wheel; crushed ballast lies below the two sleepers between which the defect is.
void takeExample(cases::CaseDescription& description, const ExampleDefect& example) {
  description.defect = defectOf(example);
  if (example.kind == Kind::flat) description.tread.points = example.defect.points;
  if (!(example.support < 1)) return;
  auto& seats = description.track.seats;
  for (const int sleeper : {0, description.track.defectFromSleeper < 0 ? -1 : 1}) {
    auto seat = std::find_if(seats.begin(), seats.end(), [&](const auto& each) { return each.sleeper == sleeper; });
    if (seat == seats.end()) seat = seats.insert(seats.end(), cases::Seat{sleeper, {}, {}, {}, {}, {}});
    seat->ballastStiffness = example.support * seat->ballastStiffness.value_or(description.ballast.stiffness);
  }
}

// One case for all of the group: zone of the mesh, and room ahead of the longest and behind.
cases::CaseDescription baseOf(cases::CaseDescription description, const std::vector<ExampleDefect>& group,
                              double beyond) {
  double before = 0, behind = 0;
  for (const auto& example : group)
    before = std::max(before, example.before), behind = std::max(behind, example.behind);
  description.mesh.zoneBefore = before, description.mesh.zoneBehind = behind;
  description.motion.runUp = std::max(description.motion.runUp, before + 0.1);
  description.motion.beyond = std::max({description.motion.beyond, beyond, behind + 0.2});
  description.track.length =
      std::max(description.track.length, description.motion.runUp + description.motion.beyond + 2.5);
  description.rail.plastic = false;
  description.tread = {};
  description.defect = defectOf(group.front());
  return description;
}

class Runs {
 public:
  Runs(const ExampleOptions& options, std::size_t planned, Monitor& monitor)
      : options_(options), planned_(planned), monitor_(monitor) {}

  // False: cancelled.
  bool add(const cases::CaseDescription& description, const std::vector<ExampleDefect>& group, double beyond) {
    if (group.empty()) return true;
    const auto base = baseOf(description, group, beyond);
    simulation::RunOptions run;
    run.isa = options_.isa, run.wheelsetModes = false, run.snapshots = false;
    if (group.front().kind != Kind::flat) {  // the wheels of flats differ
      run.threads = std::max(1, options_.jobs);
      QuietMonitor quiet(monitor_);
      auto made = simulation::makeWarmState(base, run, quiet);
      if (!made) return false;
      run.warm = std::make_shared<const simulation::WarmState>(*std::move(made));
    }
    run.threads = 1;
    std::atomic<std::size_t> next{0};
    std::vector<std::optional<Example>> found(group.size());
    const auto work = [&] {
      for (std::size_t i = next++; i < group.size(); i = next++) found[i] = passage(base, group[i], i, run);
    };
    {
      std::vector<std::jthread> workers;
      for (int job = 0; job < std::max(1, options_.jobs); ++job) workers.emplace_back(work);
    }
    for (auto& example : found)
      if (example) examples.push_back(*std::move(example));
    return !monitor_.cancelled();
  }

  std::vector<Example> examples;
  std::string failure;  // of the run that failed last

 private:
  std::optional<Example> passage(cases::CaseDescription description, const ExampleDefect& defect, std::size_t index,
                                 const simulation::RunOptions& run) {
    takeExample(description, defect);
    QuietMonitor quiet(monitor_);
    std::optional<Example> example;
    try {
      auto result = resultOf(description, run, quiet);
      if (result.complete) {
        example = exampleOf(result, defect.kind, defect.length, defect.depth);
        example->form = defect.form();
        if (defect.kind == Kind::flat || defect.support < 1 || !isOnLeftAlone(description)) example->arrival.reset();
        if (!options_.passages.empty()) keepPassage(result, *example, index);
      }
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      failure = error.what();
    }
    report();
    return example;
  }

  void keepPassage(const results::RunResult& result, const Example& example, std::size_t index) const {
    const auto passage = signals::passageOf(result, signals::names::axleBox);
    std::vector<double> time;
    for (std::size_t i = 0; i < passage.series.values.size(); ++i) time.push_back(passage.series.timeAt(i));
    std::vector<std::string> names{"time [s]", "position [m]", "aba [m/s2]"};
    std::vector<const std::vector<double>*> columns{&time, &passage.position, &passage.series.values};
    if (const auto* right = result.signal(signals::names::axleBoxRight))
      names.emplace_back("aba_right [m/s2]"), columns.push_back(right);
    const std::string kind = toText(example.kind), number = std::to_string(index + 1);
    writeDurably(options_.passages + "/" + kind + "-" + std::string(3 - std::min<std::size_t>(3, number.size()), '0') +
                     number + ".csv",
                 "# " + kind + ", " + text::fixedText(example.length * 1e3, 2) + " mm x " +
                     text::fixedText(example.depth * 1e3, 4) + " mm, " + text::fixedText(example.speed, 3) + " m/s\n" +
                     text::csvColumns(names, columns));
  }

  // Another track or wheel is not that of the warm state, and a hump may be felt ahead of it: such a case runs whole.
  static results::RunResult resultOf(const cases::CaseDescription& description, const simulation::RunOptions& run,
                                     Monitor& monitor) {
    if (!run.warm || !simulation::fits(*run.warm, description)) return whole(description, run, monitor);
    try {
      return simulation::runCase(description, run, monitor);
    } catch (const CaseError&) {
      return whole(description, run, monitor);
    }
  }
  static results::RunResult whole(const cases::CaseDescription& description, simulation::RunOptions run,
                                  Monitor& monitor) {
    run.warm.reset();
    return simulation::runCase(description, run, monitor);
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    Progress progress;
    progress.phase = "examples";
    progress.fraction = static_cast<double>(done_) / static_cast<double>(planned_);
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    progress.remainingSeconds = seconds * (1 / progress.fraction - 1);
    monitor_.report(progress);
  }

  const ExampleOptions& options_;
  std::size_t planned_, done_ = 0;
  Monitor& monitor_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
};

}  // namespace

Example exampleOf(const results::RunResult& result, Kind kind, double length, double depth) {
  const auto passage = signals::passageOf(result, signals::names::axleBox);
  Example example;
  example.kind = kind;
  example.length = length, example.depth = depth;
  std::optional<signals::TimeSeries> right;
  if (result.signal(signals::names::axleBoxRight)) right = signals::seriesOf(result, signals::names::axleBoxRight);
  const auto found = passageFeatures(passage.series, passage.position, right ? &*right : nullptr);
  const auto& features = found.features;
  example.offset = found.offset;
  if (found.arrival) example.arrival = found.arrival->energy;
  example.speed = features.speed;
  example.energy = features.energy;
  example.before = features.before, example.reach = features.reach;
  return example;
}

std::optional<std::vector<Example>> makeExamples(const cases::CaseDescription& description,
                                                 const ExampleOptions& options, Monitor& monitor) {
  const auto squats = exampleSquats(options.squats, options.seed);
  const auto others = exampleOthers(options.others, options.seed + 1);
  const auto flats = exampleFlats(options.flats, options.seed + 2);
  Runs runs(options, squats.size() + others.size() + flats.size(), monitor);
  if (!runs.add(description, squats, 0.4) || !runs.add(description, others, 0.6) || !runs.add(description, flats, 0.6))
    return std::nullopt;
  if (runs.examples.empty()) throw RunError("no example came to its end: " + runs.failure, 0, 0, "");
  const auto vehicle = cases::caseHash(description);
  for (auto& example : runs.examples) example.vehicle = vehicle;
  return std::move(runs.examples);
}

}  // namespace squat::detection
