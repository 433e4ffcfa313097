#include "growth/Grow.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "growth/GrowthCheckpoint.h"
#include "growth/LayerChange.h"
#include "growth/RollingTraffic.h"
#include "growth/StageFigures.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double shareOfChange = 0.1;                      // of growth.block_change, that the error of a block may have
constexpr double firstStage = 0.001, longestStage = 0.05;  // of the whole tonnage, between two stages
constexpr double longestBlock = 0.25;                      // of the whole tonnage
constexpr double largestFactor = 8, smallestFactor = 0.3, caution = 0.9;

// Passes on cancel and pause; the progress of the many small computations is not reported.
class QuietMonitor : public Monitor {
 public:
  explicit QuietMonitor(Monitor& watcher) : watcher_(watcher) {}
  bool cancelled() override { return watcher_.cancelled(); }
  bool paused() override { return watcher_.paused(); }

 private:
  Monitor& watcher_;
};

class Growing {
 public:
  Growing(const cases::CaseDescription& description, const GrowthOptions& options, Monitor& monitor)
      : bandHalfWidth_(description.mesh.bandHalfWidth),
        options_(options),
        monitor_(monitor),
        quiet_(monitor),
        description_(growingCase(description)),
        traffic_(description_, options.threads, options.isa, quiet_) {}

  Growth run();

 private:
  bool begin();
  void requireAhead(const GrowthState& stored) const;
  bool growOn();
  bool block(double passages);
  bool stage(bool ground);
  double nextEvent() const;
  bool isStage() const;
  double possibleBlock() const;
  void report(const char* phase);
  void reportRelease(double share);
  void keep();
  Growth result(bool complete) const;

  double bandHalfWidth_;
  const GrowthOptions& options_;
  Monitor& monitor_;
  QuietMonitor quiet_;
  cases::CaseDescription description_;
  RollingTraffic traffic_;
  GrowthState rail_;
  bool resumed_ = false;
  Clock::time_point started_ = Clock::now(), reported_ = started_;
  double tonnageReported_ = 0;
};

double largest(const Field& field) {
  double size = 0;
  for (const double value : field) size = std::max(size, std::abs(value));
  return size;
}

// How far a rate goes in `jump` more passages, each of which takes back the share `relaxation` of what it has changed:
// r (q + q^2 + ... + q^jump), q = 1 - relaxation.
double effective(double jump, double relaxation) {
  if (relaxation * jump < 1e-6) return jump;
  const double q = 1 - relaxation;
  return q * (1 - std::pow(q, jump)) / relaxation;
}

// What flow takes back of what the shape has changed by, node by node; nodes that have hardly moved keep what is known.
void learnRelaxation(const Field& changed, const Field& before, const Field& now, Field& relaxation) {
  constexpr double smallestChange = 0.02e-6, kept = 0.8;  // [m]; share of an earlier value that stays at least
  for (std::size_t i = 0; i < relaxation.size(); ++i) {
    const double seen = std::abs(changed[i]) > smallestChange ? std::clamp(-(now[i] - before[i]) / changed[i], 0.0, 1.0)
                                                              : relaxation[i];
    relaxation[i] = std::max(seen, kept * relaxation[i]);
  }
}

// Until `remaining` has rolled, if each block is `factor` times as long as the one before it, which was `last` long.
double blocksLeft(double remaining, double last, double factor) {
  constexpr double steady = 1.01;
  if (remaining <= 0) return 0;
  if (factor < steady) return remaining / (last * factor);
  return std::log1p(remaining * (factor - 1) / (last * factor)) / std::log(factor);
}

void add(Field& to, const Field& rate, double times) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += times * rate[i];
}

// [kg] at which a block has to end.
double Growing::nextEvent() const {
  return rail_.grindings < options_.grindings.size() ? options_.grindings[rail_.grindings].tonnage : options_.tonnage;
}

void Growing::report(const char* phase) {
  Progress progress;
  progress.phase = phase;
  progress.fraction = std::min(1.0, rail_.tonnage / options_.tonnage);
  const std::chrono::duration<double> spent = Clock::now() - reported_;
  if (const double last = rail_.tonnage - tonnageReported_; last > 0)
    progress.remainingSeconds = spent.count() * blocksLeft(options_.tonnage - rail_.tonnage, last,
                                                           possibleBlock() * traffic_.massPerPassage() / last);
  reported_ = Clock::now(), tonnageReported_ = rail_.tonnage;
  monitor_.report(progress);
}

// All wheelsets take about as long.
void Growing::reportRelease(double share) {
  const std::chrono::duration<double> spent = Clock::now() - started_;
  Progress progress;
  progress.phase = "wheelsets";
  progress.fraction = share;
  if (share > 0) progress.remainingSeconds = spent.count() * (1 - share) / share;
  monitor_.report(progress);
}

void Growing::keep() {
  if (!options_.checkpoint.empty()) writeGrowth(options_.checkpoint, description_, options_, rail_);
}

bool Growing::stage(bool ground) {
  const auto passage = traffic_.measure(rail_);
  if (!passage) return false;
  rail_.shapes.push_back(traffic_.heightsOf(rail_));
  auto stage = stageOf(traffic_, rail_, *passage);
  stage.ground = ground;
  rail_.stages.push_back(stage);
  if (options_.finishedStage) options_.finishedStage(stage);
  if (options_.soFar) options_.soFar(result(false));
  return true;
}

// What is asked for must not lie in the past of a stored rail; a round of all wheelsets may go beyond an event.
void Growing::requireAhead(const GrowthState& stored) const {
  const double so = stored.tonnage - static_cast<double>(traffic_.wheelsets().size()) * traffic_.massPerPassage();
  const bool late = stored.grindings < options_.grindings.size() && so > options_.grindings[stored.grindings].tonnage;
  if (so <= options_.tonnage && !late) return;
  throw CaseError({{late ? "--grind" : "--tonnage",
                    text::numberText((late ? options_.grindings[stored.grindings].tonnage : options_.tonnage) /
                                     kilogramsInMegatonne) +
                        " Mt",
                    "at least " + text::fixedText(stored.tonnage / kilogramsInMegatonne, 2) + " Mt",
                    "The rail of the checkpoint has carried that already: choose another folder or name, or remove " +
                        options_.checkpoint}});
}

bool Growing::begin() {
  reportRelease(0);
  if (!traffic_.release([this](double share) { reportRelease(share); })) return false;
  if (options_.resume && !options_.checkpoint.empty())
    if (auto stored = readGrowth(options_.checkpoint, description_, options_)) {
      requireAhead(*stored);
      rail_ = std::move(*stored);
      resumed_ = true;
      traffic_.standOn(rail_);
      if (options_.soFar) options_.soFar(result(false));
      return true;
    }
  rail_ = traffic_.newRail();
  rail_.block = static_cast<double>(traffic_.wheelsets().size());
  report("growth");
  if (!stage(false) || !traffic_.rollOver(rail_)) return false;
  keep();
  return true;
}

// Whether the traffic since the last stage is worth a measuring passage: the first blocks are short and many.
bool Growing::isStage() const {
  const double last = rail_.stages.back().tonnage;
  return rail_.tonnage >= std::min(nextEvent() * (1 - tonnageRounding),
                                   std::max(1.25 * last, last + firstStage * options_.tonnage)) ||
         rail_.tonnage >= last + longestStage * options_.tonnage;
}

// As long as error, largest change and the whole traffic allow.
double Growing::possibleBlock() const {
  const double all = static_cast<double>(traffic_.wheelsets().size());
  const double allowed = description_.growth.blockChange;
  double passages = rail_.block;
  const auto change = [&](double jump) {
    Field by(rail_.rates.wear);
    for (std::size_t i = 0; i < by.size(); ++i)
      by[i] = jump * by[i] + effective(jump, rail_.relaxation[i]) * rail_.rates.flow[i];
    return largest(relativeShape(traffic_.grid(), by));
  };
  while (passages > all && change(passages) > allowed) passages = std::max(all, 0.8 * passages);
  return std::min(std::max(passages, all), longestBlock * options_.tonnage / traffic_.massPerPassage());
}

// One block: what most of its wheelsets do follows from the rates, then those of the traffic roll. False where it was
// cancelled, with the rail as it was.
bool Growing::block(double passages) {
  const double all = static_cast<double>(traffic_.wheelsets().size());
  const double allowed = shareOfChange * description_.growth.blockChange;
  const auto& grid = traffic_.grid();
  for (;;) {
    const double jump = std::max(0.0, passages - all);
    GrowthState next = rail_;
    add(next.wear, rail_.rates.wear, jump);
    Field expected(rail_.rates.flow);  // rate at the end
    for (std::size_t i = 0; i < expected.size(); ++i) {
      next.flow[i] += expected[i] * effective(jump, rail_.relaxation[i]);
      expected[i] *= std::pow(1 - rail_.relaxation[i], jump + 1);
    }
    next.passages += jump, next.tonnage += jump * traffic_.massPerPassage();
    hardenOn(traffic_.model().layer, rail_.layerBefore, jump / all, next.layer);
    if (!traffic_.rollOver(next)) return false;

    Field correction(expected.size());
    for (std::size_t i = 0; i < correction.size(); ++i)
      correction[i] = 0.5 * (jump * (next.rates.wear[i] - rail_.rates.wear[i]) +
                             effective(jump, rail_.relaxation[i]) * (next.rates.flow[i] - expected[i]));
    Field changed = traffic_.changeOf(next);
    const Field before = traffic_.changeOf(rail_);
    for (std::size_t i = 0; i < changed.size(); ++i) changed[i] -= before[i];
    learnRelaxation(changed, relativeShape(grid, rail_.rates.flow), relativeShape(grid, next.rates.flow),
                    next.relaxation);
    const double error = largest(relativeShape(grid, correction));
    const double factor = error > 0 ? std::min(largestFactor, caution * std::sqrt(allowed / error)) : largestFactor;
    if (error > allowed && jump > 0) {
      passages = all + jump * std::clamp(factor, smallestFactor, 0.5);
      if (passages < 1.5 * all) passages = all;
      rail_.relaxation = next.relaxation;
      traffic_.standOn(rail_);
      continue;
    }
    for (std::size_t i = 0; i < correction.size(); ++i) {
      const double ofWear = 0.5 * jump * (next.rates.wear[i] - rail_.rates.wear[i]);
      next.wear[i] += ofWear, next.flow[i] += correction[i] - ofWear;
    }
    next.block = std::max(2 * all, passages * std::max(factor, smallestFactor));
    rail_ = std::move(next);
    return true;
  }
}

bool Growing::growOn() {
  while (rail_.tonnage < options_.tonnage * (1 - tonnageRounding)) {
    if (options_.untilDepth && rail_.stages.back().depth >= *options_.untilDepth) return true;
    report("growth");
    const bool due = rail_.grindings < options_.grindings.size() &&
                     rail_.tonnage >= options_.grindings[rail_.grindings].tonnage * (1 - tonnageRounding);
    if (due) {
      if (!traffic_.grind(rail_, options_.grindings[rail_.grindings].depth)) return false;
      ++rail_.grindings;
      rail_.block = static_cast<double>(traffic_.wheelsets().size());
      if (!stage(true) || !traffic_.rollOver(rail_)) return false;
      reported_ = Clock::now(), tonnageReported_ = rail_.tonnage;
    } else {
      const double untilEvent = (nextEvent() - rail_.tonnage) / traffic_.massPerPassage();
      if (!block(std::min(possibleBlock(), untilEvent)) || (isStage() && !stage(false))) return false;
    }
    keep();
  }
  return true;
}

Growth Growing::result(bool complete) const {
  Growth growth;
  growth.description = description_;
  growth.bandHalfWidth = bandHalfWidth_;
  growth.traffic = traffic_.draws();
  for (const auto& wheelset : traffic_.wheelsets()) {
    growth.speeds.push_back(wheelset->speed());
    growth.wheelLoads.push_back(0.5 * axleMass(wheelset->description()) * description_.motion.gravity);
  }
  growth.x = traffic_.grid().x, growth.y = traffic_.grid().y;
  growth.massPerPassage = traffic_.massPerPassage();
  growth.stages = rail_.stages, growth.shapes = rail_.shapes;
  growth.wear = rail_.wear, growth.flow = rail_.flow;
  growth.warnings = traffic_.own().warnings();
  growth.complete = complete, growth.resumed = resumed_;
  const std::chrono::duration<double> spent = Clock::now() - started_;
  growth.seconds = spent.count();
  if (!growth.x.empty()) growth.line = traffic_.line();
  return growth;
}

Growth Growing::run() {
  const bool begun = begin();
  reported_ = Clock::now(), tonnageReported_ = rail_.tonnage;
  const bool done = begun && growOn();
  if (done) report("growth");
  return result(done);
}

void requireSense(const GrowthOptions& options) {
  std::vector<CaseProblem> problems;
  if (!(options.tonnage > 0))
    problems.push_back(
        {"--tonnage", std::to_string(options.tonnage / kilogramsInMegatonne), "more than 0 Mt", "State the traffic"});
  double last = 0;
  for (const auto& grinding : options.grindings) {
    if (!(grinding.depth > 0) || !(grinding.tonnage > last) || !(grinding.tonnage < options.tonnage))
      problems.push_back(
          {"--grind",
           std::to_string(grinding.depth * 1e3) + "@" + std::to_string(grinding.tonnage / kilogramsInMegatonne) + "Mt",
           "a depth above 0 mm at a tonnage above 0, after the previous grinding and before the end of the traffic",
           "Write for example 0.2@10Mt"});
    last = grinding.tonnage;
  }
  if (!problems.empty()) throw CaseError(problems);
}

}  // namespace

Growth grow(const cases::CaseDescription& description, const GrowthOptions& options, Monitor& monitor) {
  requireSense(options);
  Growing growing(description, options, monitor);
  return growing.run();
}

std::optional<double> lastCleanTonnage(const Growth& growth, double depth) {
  std::optional<double> last;
  double from = 0;
  for (const auto& stage : growth.stages) {
    if (stage.ground) from = stage.tonnage, last.reset();
    if (stage.strainedDepth <= depth) last = stage.tonnage - from;
  }
  return last;
}

}  // namespace squat::growth
