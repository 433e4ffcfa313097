// The loop: observers see the steps they ask for, in their order, and a monitor can stop it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "simulation/RollingLoop.h"

namespace squat::simulation {
namespace {

using testing::ElementsAre;

class Every : public StepObserver {
 public:
  Every(long interval, std::vector<std::string>& calls, std::string name)
      : interval_(interval), calls_(calls), name_(std::move(name)) {}
  long nextStep(long done) const override { return done + interval_ - done % interval_; }
  void onStart(const dynamics::Rolling&) override { calls_.push_back(name_ + " start"); }
  void onEveryStep(const dynamics::Rolling&) override { ++steps; }
  void onStep(const dynamics::Rolling& rolling) override {
    calls_.push_back(name_ + " " + std::to_string(rolling.state().step));
  }
  int steps = 0;

 private:
  long interval_;
  std::vector<std::string>& calls_;
  std::string name_;
};

struct StopAt : Monitor {
  explicit StopAt(int looks) : left(looks) {}
  bool cancelled() override { return --left < 0; }
  int left;
};

class RollingLoopTest : public testing::Test {
 protected:
  RollingLoopTest() { rolling_.start(AlignedVector(model_.stateSize, 0.0), AlignedVector(model_.stateSize, 0.0), 65); }
  model::Model model_ =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"motion.torque", "0"}}}));
  ThreadTeam team_{1};
  dynamics::Rolling rolling_{model_, elasticity::kernelsFor(""), team_, 1e-7, 0};
  RunClock clock_;
};

TEST_F(RollingLoopTest, ObserversSeeTheStepsOfAllInTheirOrder) {
  std::vector<std::string> calls;
  Every third(3, calls, "third"), fifth(5, calls, "fifth");
  Monitor quiet;
  EXPECT_EQ(roll(rolling_, 7, {&third, &fifth}, quiet, clock_), LoopEnd::done);
  EXPECT_THAT(calls, ElementsAre("third start", "fifth start", "third 3", "fifth 3", "third 5", "fifth 5", "third 6",
                                 "fifth 6", "third 7", "fifth 7"));
  EXPECT_EQ(third.steps, 7);
  // Resumed: no second start.
  calls.clear();
  EXPECT_EQ(roll(rolling_, 9, {&fifth}, quiet, clock_), LoopEnd::done);
  EXPECT_THAT(calls, ElementsAre("fifth 9"));
}

TEST_F(RollingLoopTest, CancelsBetweenSteps) {
  std::vector<std::string> calls;
  Every third(3, calls, "third");
  StopAt monitor(1);
  EXPECT_EQ(roll(rolling_, 100, {&third}, monitor, clock_), LoopEnd::cancelled);
  EXPECT_EQ(rolling_.state().step, 6);
}

}  // namespace
}  // namespace squat::simulation
