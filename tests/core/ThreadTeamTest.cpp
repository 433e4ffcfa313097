// Threads that work in step: nobody passes a barrier early, failures come through, and a machine that is busy with
// other programs slows a team but does not stop it.
#include "core/ThreadTeam.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "core/OrderedSum.h"

namespace squat {
namespace {

// Each thread counts its phase before it comes to the barrier: behind it all have.
void expectInStep(ThreadTeam& team, int phases) {
  std::vector<std::atomic<int>> done(static_cast<std::size_t>(team.size()));
  std::atomic<int> early{0};
  team.runInStep([&](int index) {
    for (int k = 1; k <= phases; ++k) {
      done[static_cast<std::size_t>(index)] = k;
      team.barrier();
      for (const auto& other : done) early += other < k;
      team.barrier();
    }
  });
  EXPECT_EQ(early, 0);
}

TEST(ThreadTeam, NobodyPassesABarrierEarly) {
  for (const int threads : {1, 2, 3, 5}) {
    ThreadTeam team(threads);
    expectInStep(team, 200);
  }
}

TEST(ThreadTeam, StaysInStepBesideABusyProgram) {
  std::atomic<bool> stop{false};
  std::vector<std::thread> busy;
  for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
    busy.emplace_back([&] {
      while (!stop) {
      }
    });
  ThreadTeam team(2);
  for (int k = 0; k < 20; ++k) expectInStep(team, 20);
  stop = true;
  for (auto& thread : busy) thread.join();
}

// A phase sees what the one before it has done on every thread.
void expectInOrder(ThreadTeam& team, std::chrono::milliseconds atLeast) {
  std::atomic<int> first{0}, second{0}, wrong{0};
  const auto until = std::chrono::steady_clock::now() + atLeast;
  int rounds = 0;
  for (; rounds < 1000 || std::chrono::steady_clock::now() < until; ++rounds)
    team.runInOrder({[&](int) { ++first; },
                     [&](int) {
                       wrong += first != team.size() * (rounds + 1);
                       ++second;
                     },
                     [&](int) { wrong += second != team.size() * (rounds + 1); }});
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(first, team.size() * rounds);
}

TEST(ThreadTeam, PhasesComeInOrder) {
  for (const int threads : {1, 2, 3}) {
    ThreadTeam team(threads);
    expectInOrder(team, std::chrono::milliseconds(0));
  }
}

// Long enough for the team to fall back on one thread and to try all again.
TEST(ThreadTeam, PhasesComeInOrderBesideBusyPrograms) {
  std::atomic<bool> stop{false};
  std::vector<std::thread> busy;
  for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i)
    busy.emplace_back([&] {
      while (!stop) {
      }
    });
  ThreadTeam team(2);
  expectInOrder(team, std::chrono::milliseconds(400));
  stop = true;
  for (auto& thread : busy) thread.join();
}

using std::chrono::milliseconds;

// Two threads that work 10 ms each and take 25 ms for it: one alone needs 20.
TEST(SerialFallback, IsTakenWhereAllTogetherTakeLongerThanOneWould) {
  SerialFallback fallback;
  SerialFallback::Clock::time_point now;
  EXPECT_FALSE(fallback.isOn(now));
  fallback.note(milliseconds(25), milliseconds(20), now);
  EXPECT_TRUE(fallback.isOn(now));
  now += milliseconds(110);
  EXPECT_FALSE(fallback.isOn(now)) << "all are tried again after a tenth of a second";
  fallback.note(milliseconds(25), milliseconds(20), now);
  now += milliseconds(110);
  EXPECT_TRUE(fallback.isOn(now)) << "in vain: for twice as long";
  fallback.note(milliseconds(25), milliseconds(48), now);
  EXPECT_FALSE(fallback.isOn(now));
}

TEST(SerialFallback, IsDecidedOverSomeTurnsOfOtherPrograms) {
  SerialFallback fallback;
  fallback.note(milliseconds(8), milliseconds(1));
  EXPECT_FALSE(fallback.isOn()) << "one stall says nothing yet";
  fallback.note(milliseconds(16), milliseconds(31));
  EXPECT_FALSE(fallback.isOn());
}

TEST(ThreadTeam, ForEachDoesEachOnce) {
  ThreadTeam team(3);
  std::vector<std::atomic<int>> times(1000);
  team.forEach(times.size(), [&](std::size_t i) { ++times[i]; });
  for (const auto& count : times) EXPECT_EQ(count, 1);
}

TEST(ThreadTeam, AFailureInAnyThreadComesThrough) {
  ThreadTeam team(2);
  for (const int failing : {0, 1})
    EXPECT_THROW(team.run([&](int index) {
      if (index == failing) throw std::runtime_error("this thread fails");
    }),
                 std::runtime_error);
  expectInStep(team, 3);
}

// 1 + 2 + ... + n, with the few that no eight lanes hold; and bits that do not depend on the threads.
TEST(OrderedSum, LanesHoldEveryTerm) {
  for (const std::size_t n : {0, 1, 7, 8, 9, 1000, 1003})
    EXPECT_EQ(sumInLanes(0, n, [](std::size_t i) { return static_cast<double>(i + 1); }),
              static_cast<double>(n * (n + 1)) / 2);
  EXPECT_EQ(sumInLanes(3, 6, [](std::size_t i) { return static_cast<double>(i); }), 3 + 4 + 5);
}

TEST(OrderedSum, SameBitsForAnyNumberOfThreads) {
  const auto third = [](std::size_t i) { return 1 / (3.0 + static_cast<double>(i)); };
  std::vector<double> sums;
  for (const int threads : {1, 2, 3}) {
    ThreadTeam team(threads);
    sums.push_back(
        orderedSum(team, 10007, [&](std::size_t begin, std::size_t end) { return sumInLanes(begin, end, third); }));
  }
  EXPECT_EQ(sums[0], sums[1]);
  EXPECT_EQ(sums[0], sums[2]);
}

}  // namespace
}  // namespace squat
