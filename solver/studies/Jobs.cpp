#include "studies/Jobs.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/ThreadTeam.h"
#include "core/platform/Cores.h"
#include "core/platform/Memory.h"

namespace squat::studies {
namespace {

// Runs for which a supply is enough; without limit where supply or demand is not known.
double runsFor(double supply, double demand) {
  return supply > 0 && demand > 0 ? supply / demand : std::numeric_limits<double>::max();
}

}  // namespace

int coresHere() {
  int cores = threadCount(0);
  if (const int usable = platform::usableCores(); usable > 0) cores = std::min(cores, usable);
  if (const char* given = std::getenv("SLURM_CPUS_PER_TASK")) {  // a batch system without cgroups does not hold it
    int count = 0;
    const auto* end = given + std::string_view(given).size();
    if (std::from_chars(given, end, count).ptr == end && count > 0) cores = std::min(cores, count);
  }
  return std::max(1, cores);
}

// Each core adds two arrays into a third, which together are far beyond its share of any cache; the best of a few
// rounds. A store reads its line first, so that an element moves four numbers.
double memoryBandwidth(int cores) {
  constexpr int fewCores = 4, rounds = 4;
  if (cores <= fewCores) return 0;
  constexpr std::size_t length = std::size_t{1} << 19;  // three arrays of 4 MiB
  ThreadTeam team(cores);
  std::vector<std::vector<double>> arrays(static_cast<std::size_t>(cores));
  team.run([&](int core) { arrays[static_cast<std::size_t>(core)].assign(3 * length, 1.0); });
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    team.run([&](int core) {
      double* a = arrays[static_cast<std::size_t>(core)].data();
      for (std::size_t i = 0; i < length; ++i) a[i] = a[i + length] + 0.5 * a[i + 2 * length];
    });
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return 4.0 * sizeof(double) * length * cores / best;
}

Machine thisMachine() {
  const int cores = coresHere();
  return {cores, platform::availableMemory(), memoryBandwidth(cores), platform::lastLevelCache()};
}

RunDemand demandOnMesh(const std::string& preset) {
  const bool small = preset == "tiny" || preset == "draft";
  constexpr double gibibyte = 1ULL << 30, maximum = 80000, maximumOfLarge = 400000;  // elements
  return {(small ? 0.5 : 2.0) * gibibyte, kTrafficOfAThread, kStateOfAnElement * (small ? maximum : maximumOfLarge)};
}

Sharing shareMachine(const Machine& machine, const RunDemand& demand, Sharing wanted) {
  const int threads = std::max(1, wanted.threads);
  const double held = demand.state > 0 ? 0.8 * machine.cache / demand.state : 0;  // runs whose states stay in the cache
  Sharing sharing = wanted;
  if (wanted.jobs == 0) {
    const double fed = std::max(runsFor(machine.bandwidth, threads * demand.traffic), held);
    const int whole = machine.cores / threads;
    const double jobs = std::min({static_cast<double>(whole), runsFor(0.9 * machine.memory, demand.memory), fed});
    sharing.jobs = std::max(1, static_cast<int>(jobs));
  }
  if (wanted.threads == 0) {
    const double fed = sharing.jobs <= held ? machine.cores : runsFor(machine.bandwidth, demand.traffic);
    sharing.threads = std::max(1, static_cast<int>(std::min<double>(machine.cores, fed)) / sharing.jobs);
  }
  return sharing;
}

}  // namespace squat::studies
