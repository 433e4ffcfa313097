// Timings of a step: no time of a thread is lost or counted twice.
#include "dynamics/StepTimings.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "dynamics/Rolling.h"

namespace squat::dynamics {
namespace {

double allPhases(const StepTimings& timings, int thread) {
  double sum = 0;
  for (std::size_t p = 0; p < stepPhases; ++p) sum += timings.seconds(thread, static_cast<StepPhase>(p));
  return sum;
}

TEST(StepTimings, EachPhaseHasAName) {
  std::set<std::string> names;
  for (std::size_t p = 0; p < stepPhases; ++p) names.insert(nameOf(static_cast<StepPhase>(p)));
  EXPECT_EQ(names.size(), stepPhases);
}

TEST(StepTimings, OfARollingWheelCoverItsWholeTime) {
  using Clock = std::chrono::steady_clock;
  const auto model =
      model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {{"motion.torque", "0"}}}));
  ThreadTeam team(2);
  Rolling rolling(model, elasticity::kernelsFor(""), team, 1e-7, 0);
  rolling.start(AlignedVector(model.stateSize, 0.0), AlignedVector(model.stateSize, 0.0), 65);
  const auto before = Clock::now();
  StepTimings timings(2);
  const auto begun = Clock::now();
  rolling.setTimings(&timings);
  auto seen = begun;
  for (int k = 0; k < 3; ++k) rolling.advance(10, [&](const StepView&) { seen = Clock::now(); });
  const auto ended = Clock::now();
  EXPECT_EQ(timings.steps(), 30);
  // The first thread's last phase ends between the last look at a step and the end.
  EXPECT_GE(allPhases(timings, 0), std::chrono::duration<double>(seen - begun).count());
  EXPECT_LE(allPhases(timings, 0), std::chrono::duration<double>(ended - before).count());
  EXPECT_LE(allPhases(timings, 1), std::chrono::duration<double>(ended - before).count());
  for (const auto phase : {StepPhase::wheelset, StepPhase::stations, StepPhase::motion})
    EXPECT_GT(timings.seconds(0, phase), 0) << nameOf(phase);
  EXPECT_GT(timings.seconds(1, StepPhase::masters), 0);
  EXPECT_EQ(timings.seconds(1, StepPhase::wheelset), 0) << "the contact is the first thread's";
  rolling.setTimings(nullptr);
  rolling.advance(5, [](const StepView&) {});
  EXPECT_EQ(timings.steps(), 30);
}

}  // namespace
}  // namespace squat::dynamics
