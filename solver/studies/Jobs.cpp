#include "studies/Jobs.h"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <thread>

namespace squat::studies {

double freeMemory() {
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

int coresHere() {
  int cores = static_cast<int>(std::thread::hardware_concurrency());
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) cores = CPU_COUNT(&allowed);
  if (const char* given = std::getenv("SLURM_CPUS_PER_TASK")) {  // a batch system without cgroups does not hold it
    int count = 0;
    const auto* end = given + std::string_view(given).size();
    if (std::from_chars(given, end, count).ptr == end && count > 0) cores = std::min(cores, count);
  }
  return std::max(1, cores);
}

int jobsThatFit(int threadsPerRun, double bytesPerRun) {
  double jobs = std::numeric_limits<int>::max();
  if (threadsPerRun > 0) {
    const int sharing = coresHere() / threadsPerRun;  // whole runs
    jobs = std::min(jobs, static_cast<double>(sharing));
  }
  const double memory = freeMemory();
  if (bytesPerRun > 0 && memory > 0) jobs = std::min(jobs, 0.9 * memory / bytesPerRun);
  if (jobs >= std::numeric_limits<int>::max()) return 1;
  return std::max(1, static_cast<int>(jobs));
}

}  // namespace squat::studies
