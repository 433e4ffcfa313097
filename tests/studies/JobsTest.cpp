// Runs and threads chosen for a machine: machines on paper, and a simulation of one with 64 cores.
#include "studies/Jobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squat::studies {
namespace {

constexpr double kGB = 1e9;

TEST(Jobs, onTwoCoresEachHasARun) {
  const auto sharing = shareMachine({2, 20 * kGB, 0}, {0.2 * kGB, kTrafficOfAThread});
  EXPECT_EQ(sharing.jobs, 2);
  EXPECT_EQ(sharing.threads, 1);
}

TEST(Jobs, whatTheUserSaysStands) {
  const Machine machine{8, 20 * kGB, 10 * kGB};
  const RunDemand demand{0.2 * kGB, 5 * kGB};
  EXPECT_EQ(shareMachine(machine, demand, {8, 4}).jobs, 8);
  EXPECT_EQ(shareMachine(machine, demand, {8, 4}).threads, 4);
  EXPECT_EQ(shareMachine(machine, demand, {1, 0}).threads, 2);  // the bandwidth feeds two
  EXPECT_EQ(shareMachine(machine, demand, {0, 2}).jobs, 1);
}

TEST(Jobs, memoryLimitsTheRunsAndThreadsTakeTheOtherCores) {
  const auto sharing = shareMachine({16, 4 * kGB, 0}, {0.9 * kGB, 0});
  EXPECT_EQ(sharing.jobs, 4);  // nine tenths of 4 GB hold four runs of 0.9 GB
  EXPECT_EQ(sharing.threads, 4);
  EXPECT_EQ(shareMachine({16, 0.5 * kGB, 0}, {0.9 * kGB, 0}).jobs, 1);
}

// States of 24 MB: ten of them stay in a cache of 300 MB, where the memory would feed three.
TEST(Jobs, runsWhoseStatesStayInTheCacheNeedNoMemory) {
  const Machine machine{64, 256 * kGB, 40 * kGB, 0.3 * kGB};
  const auto sharing = shareMachine(machine, {0.3 * kGB, 13 * kGB, 24e6});
  EXPECT_EQ(sharing.jobs, 10);
  EXPECT_EQ(sharing.threads, 6);
  const auto large = shareMachine(machine, {0.3 * kGB, 13 * kGB, 100e6});
  EXPECT_EQ(large.jobs * large.threads, 3);
}

TEST(Jobs, whatIsNotKnownDoesNotLimit) {
  EXPECT_EQ(shareMachine({16, 0, 0}, {kGB, kGB}).jobs, 16);
  EXPECT_EQ(shareMachine({16, kGB, kGB}, {0, 0}).jobs, 16);
}

// Seconds that 640 runs of 60 s take on 64 cores where all threads that compute share the bandwidth evenly: in small
// steps of time, each thread gets on as fast as its core and its share of the bandwidth let it.
double simulatedTime(const Machine& machine, double traffic, Sharing sharing) {
  constexpr double work = 60, step = 0.5;  // [s] of one thread for a run; [s]
  int waiting = 640;
  std::vector<double> running;
  double time = 0;
  while (waiting > 0 || !running.empty()) {
    while (waiting > 0 && static_cast<int>(running.size()) < sharing.jobs) running.push_back(work), --waiting;
    const double threads = static_cast<double>(running.size()) * sharing.threads;
    const double cores = std::min(1.0, machine.cores / threads);
    const double fed = std::min(1.0, machine.bandwidth / (threads * cores * traffic));
    for (double& left : running) left -= step * sharing.threads * cores * fed;
    std::erase_if(running, [](double left) { return left <= 0; });
    time += step;
  }
  return time;
}

// Eight channels of DDR4-3200 give 160 of their 205 GB/s; a desktop's memory behind as many cores is the other case.
TEST(Jobs, sixtyFourCoresAreNotPromisedMoreThanTheMemoryFeeds) {
  for (const double bandwidth : {40.0, 160.0, 1000.0}) {
    const Machine machine{64, 256 * kGB, bandwidth * kGB};
    for (const double perThread : {2.0, 5.0, 10.0}) {
      const double traffic = perThread * kGB;
      const auto chosen = shareMachine(machine, {0.3 * kGB, traffic});
      const int threads = chosen.jobs * chosen.threads;
      EXPECT_LE(threads, 64);
      EXPECT_LE(threads * traffic, machine.bandwidth) << bandwidth << ' ' << perThread;
      double best = simulatedTime(machine, traffic, {64, 1});
      for (const int jobs : {1, 2, 4, 8, 12, 16, 24, 32, 48})
        for (const int each : {1, 2, 4, 8}) best = std::min(best, simulatedTime(machine, traffic, {jobs, each}));
      // One run more than the rule allows would use what is left of the bandwidth, at most a part in `jobs`; the last
      // round of runs may be shorter than the others.
      EXPECT_LT(simulatedTime(machine, traffic, chosen), best * (1 + 1.0 / chosen.jobs) + 60) << bandwidth;
    }
  }
}

// Against a copy of one large array: no machine moves a hundred times as much with all cores.
TEST(Jobs, thisMachineIsMeasuredWhereItMayMatter) {
  EXPECT_EQ(memoryBandwidth(2), 0);
  const double bandwidth = memoryBandwidth(6);
  EXPECT_GT(bandwidth, 0.5 * kGB);
  EXPECT_LT(bandwidth, 10000 * kGB);
  const auto machine = thisMachine();
  EXPECT_GT(machine.memory, 0);
  EXPECT_GE(machine.cache, 0);
  EXPECT_GE(machine.cores, 1);
}

}  // namespace
}  // namespace squat::studies
