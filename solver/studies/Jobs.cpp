#include "studies/Jobs.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
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

int jobsThatFit(int threadsPerRun, double bytesPerRun) {
  double jobs = std::numeric_limits<int>::max();
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  if (threadsPerRun > 0 && cores > 0) {
    const int sharing = cores / threadsPerRun;  // whole runs
    jobs = std::min(jobs, static_cast<double>(sharing));
  }
  const double memory = freeMemory();
  if (bytesPerRun > 0 && memory > 0) jobs = std::min(jobs, 0.9 * memory / bytesPerRun);
  if (jobs >= std::numeric_limits<int>::max()) return 1;
  return std::max(1, static_cast<int>(jobs));
}

}  // namespace squat::studies
