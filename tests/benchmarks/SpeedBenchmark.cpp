// Speed of the element work, on each mesh and with one thread and two. Besides times, each row tells what does not
// depend on the machine: the share of the multiply-add peak that the same program measures, element updates a second.
// .ci/benchmarks turns the rows into ratios.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "dynamics/Rolling.h"
#include "dynamics/StableStep.h"
#include "model/Model.h"
#include "simulation/WarmState.h"
#include "statics/SteadyRollingStart.h"

namespace squat {
namespace {

const char* const meshes[] = {"tiny", "draft", "standard", "paper"};

// `selective`: with more inertia for short waves, as runs have it, or without.
model::Model& modelOf(int mesh, bool selective = true) {
  static std::map<std::pair<int, bool>, model::Model> models;
  const auto [it, isNew] = models.try_emplace({mesh, selective});
  if (isNew)
    it->second = model::buildModel(cases::loadScenario(
        "light-defect", {meshes[mesh], {{"mesh.selective_inertia", selective ? "true" : "false"}}}));
  return it->second;
}

// The paper's mesh with more and more track, at last with finer sections too: cost per element and step should not
// change.
model::Model& longTrack(int metres, bool fineSections) {
  static std::map<std::pair<int, bool>, model::Model> models;
  const auto [it, isNew] = models.try_emplace({metres, fineSections});
  if (isNew)
    it->second =
        model::buildModel(cases::loadScenario("light-defect", {"paper",
                                                               {{"track.length", std::to_string(metres)},
                                                                {"mesh.section_size", fineSections ? "6" : "10"},
                                                                {"mesh.section_growth", "1.33"}}}));
  return it->second;
}

double multiplyAdds(const model::Model& model) {
  double sum = 0;
  for (const auto& block : model.blocks) sum += 18.0 * static_cast<double>(block.columns.size()) * block.intervals;
  return sum;
}

std::vector<std::vector<elasticity::Segment>> shares(const model::Model& model, int threads) {
  std::vector<int> all;
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) all.push_back(b);
  return elasticity::partition(model.blocks, all, threads);
}

// A wheel in its equilibrium on the rail, with the velocities of steady rolling.
struct Start {
  dynamics::StableStep stable;
  statics::SteadyRollingStart steady;
};

const Start& startOf(const model::Model& model, const elasticity::KernelSet& kernels) {
  static std::map<const model::Model*, Start> starts;
  const auto [it, isNew] = starts.try_emplace(&model);
  if (!isNew) return it->second;
  ThreadTeam team(threadCount(0));
  Monitor silent;
  it->second.stable = dynamics::stableStep(model, kernels, team, silent);
  it->second.steady = statics::prepareSteadyRollingStart(model, kernels, team, silent);
  return it->second;
}

// Best of the rounds, what the machine does when nothing else disturbs it, and their median.
template <typename Round>
void measure(benchmark::State& state, const model::Model& model, int steps, double peakShare, const Round& round) {
  std::vector<double> rounds;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    round();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
    state.SetIterationTime(seconds);
    rounds.push_back(seconds);
  }
  std::sort(rounds.begin(), rounds.end());
  const double best = rounds.front();
  state.counters["elements"] = static_cast<double>(model.elements());
  state.counters["best_ms"] = 1e3 * best;
  state.counters["median_ms"] = 1e3 * rounds[rounds.size() / 2];
  state.counters["Mupdates"] = 1e-6 * static_cast<double>(model.elements()) / best;
  state.counters["peak_share"] = peakShare / best;
  state.counters["closed_points"] = 0;  // the table has the columns of its first row alone
}

void bareOperator(benchmark::State& state, const model::Model& model, int threads) {
  ThreadTeam team(threads);
  const auto kernels = elasticity::kernelsFor("");
  state.SetLabel(kernels.name);
  const auto work = shares(model, threads);
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch;
  for (int i = 0; i < threads; ++i) scratch.push_back(std::make_unique<elasticity::KernelScratch>(model.blocks));
  AlignedVector u(model.stateSize, 1e-6), f(model.stateSize, 0.0);
  double peak = 0;
  for (int i = 0; i < 5; ++i) peak = std::max(peak, kernels.multiplyAddPeak(0.02));
  measure(state, model, 1, 2 * multiplyAdds(model) / (peak * threads), [&] {
    team.run([&](int index) {
      elasticity::applySegments(work[index], model.blocks, kernels, u.data(), f.data(), *scratch[index]);
    });
  });
}

void wholeStep(benchmark::State& state, model::Model& model, int threads, scenario::ElementPrecision precision) {
  model.scenario.mesh.precision = precision;
  constexpr int steps = 5;
  ThreadTeam team(threads);
  const auto kernels = elasticity::kernelsFor("");
  state.SetLabel(kernels.name);
  const auto& start = startOf(model, kernels);
  dynamics::Rolling rolling(model, kernels, team, start.stable.step, start.stable.beta);
  rolling.start(start.steady.equilibrium.displacement, start.steady.velocity,
                model.scenario.motion.speed / model.surfaces.radius);
  rolling.advance(200, [](const dynamics::StepView&) {});
  measure(state, model, steps, 0, [&] { rolling.advance(steps, [](const dynamics::StepView&) {}); });
  state.counters["closed_points"] = rolling.view().patch.points;
}

// A run from a warm state that has been rolled on to the defect, up to a place behind its deepest point: what a preview
// of a changed profile computes.
struct Passage : Monitor {
  explicit Passage(double to) : end(to) {}
  bool cancelled() override { return position > end; }
  double end, position = -1;  // [m]
};

const std::shared_ptr<const simulation::WarmState>& warmState(int mesh) {
  static std::map<int, std::shared_ptr<const simulation::WarmState>> states;
  auto& state = states[mesh];
  if (state) return state;
  const auto description = cases::loadCase(
      "light-defect",
      {meshes[mesh], {{"mesh.zone_before", "40"}, {"mesh.zone_behind", "40"}, {"motion.beyond", "0.1"}}});
  simulation::RunOptions options;
  options.wheelsetModes = options.snapshots = false;
  Monitor silent;
  const auto first =
      std::make_shared<const simulation::WarmState>(*simulation::makeWarmState(description, options, silent));
  state =
      std::make_shared<const simulation::WarmState>(*simulation::rollOn(first, description, 0.015, options, silent));
  return state;
}

void warmRun(benchmark::State& state, int mesh, int threads, double to) {
  const auto warm = warmState(mesh);
  state.SetLabel(elasticity::kernelsFor("").name);
  auto description = warm->description;
  simulation::RunOptions options;
  options.threads = threads, options.wheelsetModes = options.snapshots = false, options.warm = warm;
  measure(state, *warm->model, 1, 0, [&] {
    description.defect.depth *= 0.99;
    Passage passage(to);
    options.sampled = [&](double position, double) { passage.position = position; };
    simulation::runCase(description, options, passage);
  });
}

void addRow(const std::string& name, int rounds, const std::function<void(benchmark::State&)>& body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Iterations(rounds)->UseManualTime()->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace squat

int main(int argc, char** argv) {
  using namespace squat;
  benchmark::Initialize(&argc, argv);
  for (int mesh = 0; mesh < 4; ++mesh)
    for (const int threads : {1, 2}) {
      const std::string tail = std::string("/") + meshes[mesh] + "/threads:" + std::to_string(threads);
      const int rounds = mesh < 2 ? 400 : 120;
      addRow("operator" + tail, rounds, [=](benchmark::State& state) { bareOperator(state, modelOf(mesh), threads); });
      for (const auto precision : {scenario::ElementPrecision::full, scenario::ElementPrecision::single})
        addRow((precision == scenario::ElementPrecision::full ? "step" : "single_step") + tail, rounds / 4,
               [=](benchmark::State& state) { wholeStep(state, modelOf(mesh), threads, precision); });
      addRow("bare_step" + tail, rounds / 4, [=](benchmark::State& state) {
        wholeStep(state, modelOf(mesh, false), threads, scenario::ElementPrecision::full);
      });
    }
  for (const auto& track : {std::pair{10, false}, {40, false}, {60, true}})
    for (const auto precision : {scenario::ElementPrecision::full, scenario::ElementPrecision::single})
      addRow((precision == scenario::ElementPrecision::full ? "long_track/metres:" : "single_long_track/metres:") +
                 std::to_string(track.first),
             30,
             [=](benchmark::State& state) { wholeStep(state, longTrack(track.first, track.second), 2, precision); });
  constexpr double begin = -1, bottom = 0, end = 1;  // [m]: first sample, first one behind the bottom, whole run
  for (int mesh = 0; mesh < 2; ++mesh)
    for (const int threads : {1, 2})
      for (const auto& [name, to] : {std::pair{"warm_begin", begin}, {"warm_bottom", bottom}, {"warm_whole", end}})
        addRow(std::string(name) + "/" + meshes[mesh] + "/threads:" + std::to_string(threads), mesh == 0 ? 20 : 5,
               [=, to = to](benchmark::State& state) { warmRun(state, mesh, threads, to); });
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
