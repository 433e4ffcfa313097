// How many runs at once: on this machine, and on paper on one of 64 cores.
#include "studies/Jobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/CostEstimate.h"

namespace squat::studies {
namespace {

// Two processors of 32 cores, eight channels of DDR4-3200 each (25.6 GB/s a channel by its standard), of which three
// quarters are reached; 256 MiB of last cache in all, 256 GiB of memory.
constexpr Machine kLarge{64, 256.0 * (1ULL << 30), 0.75 * 16 * 25.6e9, 4.0 * (1 << 20)};

TEST(Jobs, fitTheMachine) {
  EXPECT_GT(freeMemory(), 0);
  EXPECT_EQ(jobsThatFit(1, 1e18), 1);
  EXPECT_EQ(jobsThatFit(100000, 0), 1);
  EXPECT_GE(jobsThatFit(1, 1e6), 1);
  EXPECT_EQ(jobsThatFit(0, 0), 1);
}

// What several threads move together is below what their arrays would take from a first cache (some 100 GB/s a core),
// and above a spinning disk's; a build without optimisation reaches a fraction.
TEST(Jobs, theBandwidthIsThatOfAMemory) {
  const double bandwidth = memoryBandwidth(2);
  EXPECT_GT(bandwidth, 2e8);
  EXPECT_LT(bandwidth, 1e12);
}

TEST(Jobs, eachLimitCounts) {
  EXPECT_EQ(runsAtOnce(kLarge, {1, 0, 0, 0}), 64);
  EXPECT_EQ(runsAtOnce(kLarge, {3, 0, 0, 0}), 21) << "whole runs";
  EXPECT_EQ(runsAtOnce(kLarge, {1, 50.0 * (1ULL << 30), 0, 0}), 4) << "0.9 of 256 GiB";
  EXPECT_EQ(runsAtOnce(kLarge, {1, 0, 1e9, 20e9}), 15) << "307 GB/s";
  EXPECT_EQ(runsAtOnce(kLarge, {4, 0, 1e9, 20e9}), 3) << "four threads move four times as much";
  EXPECT_EQ(runsAtOnce(kLarge, {1, 0, 3e6, 20e9}), 64) << "the state stays in the cache";
  EXPECT_EQ(runsAtOnce({1, 0, 1, 0}, {1, 0, 1e9, 1e9}), 1) << "never none";
}

// Simulated: runs share the bandwidth, so that each slows down once they ask for more than there is. With as many runs
// as the rule gives, no run waits for memory; one more per cent of throughput is not to be had with any other number.
TEST(Jobs, onALargeMachineNoRunWaitsForMemory) {
  for (const double elements : {14e3, 79e3, 300e3, 365e3, 920e3}) {
    const auto demand = demandOf(elements, 1);
    const auto throughput = [&](int runs) {
      const double asked = demand.state <= kLarge.cache ? 0 : runs * demand.traffic;
      return runs * std::min(1.0, asked > 0 ? kLarge.bandwidth / asked : 1.0);
    };
    const int chosen = runsAtOnce(kLarge, demand);
    double best = 0;
    for (int runs = 1; runs <= kLarge.cores; ++runs) best = std::max(best, throughput(runs));
    EXPECT_EQ(throughput(chosen), chosen) << elements << ": each at its own speed";
    EXPECT_GT(throughput(chosen), 0.98 * best) << elements;
  }
}

}  // namespace
}  // namespace squat::studies
