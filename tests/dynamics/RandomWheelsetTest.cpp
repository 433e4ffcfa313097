// The step does not depend on how radii and widths happen to lie: of any wheelset within the table's ranges it is near
// that of the default one.
#include <gtest/gtest.h>

#include <cstdio>

#include "RandomWheelsets.h"
#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "dynamics/StableStep.h"

namespace squat::dynamics {
namespace {

model::Model modelOf(const tests::KeyValues& values) {
  return model::buildModel(cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", values}));
}

StableStep stepOfModel(const model::Model& model) {
  ThreadTeam team(2);
  Monitor quiet;
  return stableStep(model, elasticity::kernelsFor(""), team, quiet);
}

StableStep stepOf(const tests::KeyValues& values) { return stepOfModel(modelOf(values)); }

// The next drawing that the mesh does not refuse: chords of the tread must stay outside the wheel body.
std::pair<tests::KeyValues, model::Model> nextModel(tests::RandomWheelsets& wheelsets) {
  for (;;) {
    auto values = wheelsets.next();
    try {
      return {values, modelOf(values)};
    } catch (const CaseError&) {
    }
  }
}

// What is thin by the drawing itself (a wall, a skew web) may cost more; the message then names the keys that size it.
// One in five of the drawings at most: uniform lengths make many tubes.
TEST(RandomWheelsets, StepIsTheDefaultsOrAnInputIsNamed) {
  const auto usual = stepOf({});
  tests::RandomWheelsets wheelsets(20261123);
  int thin = 0;
  for (int i = 0; i < 200; ++i) {
    const auto [values, model] = nextModel(wheelsets);
    const auto stable = stepOfModel(model);
    if (stable.step >= 0.7 * usual.step) continue;
    ++thin;
    std::string text;
    for (const auto& [key, value] : values) text += " " + key.substr(9) + "=" + value.substr(0, 5);
    std::printf("%3d %.3f %s:%s\n", i, stable.step / usual.step, stable.location.c_str(), text.c_str());
    EXPECT_NE(stable.location.find("(wheelset."), std::string::npos) << stable.location;
  }
  std::printf("%d of 200 below 0.7 of the default's %.3f us\n", thin, 1e6 * usual.step);
  EXPECT_LT(thin, 40);
}

// A seat, a shoulder and a journal that nearly meet, as drawings have them, cost nothing.
TEST(RandomWheelsets, RadiiThatNearlyMeetCostNothing) {
  const auto usual = stepOf({});
  for (const char* radius : {"80.1", "83", "91", "92.4", "95"}) {
    const auto stable = stepOf({{"wheelset.shoulder_radius", radius}});
    EXPECT_GT(stable.step, 0.95 * usual.step) << radius << ": " << stable.location;
  }
  for (const char* width : {"100", "134", "136", "172"}) {  // [mm] near the rim's 135 and the hub's 175
    const auto stable = stepOf({{"wheelset.hub_width", width}});
    EXPECT_GT(stable.step, 0.95 * usual.step) << width << ": " << stable.location;
  }
  for (const char* bore : {"5", "15"})
    EXPECT_GT(stepOf({{"wheelset.bore_radius", bore}}).step, 0.9 * usual.step) << bore;
}

TEST(RandomWheelsets, AThinWallIsNamed) {
  const auto thin = stepOf({{"wheelset.bore_radius", "50"}, {"wheelset.axle_radius", "53"}});
  EXPECT_NE(thin.location.find("wheelset.axle_radius, wheelset.bore_radius"), std::string::npos) << thin.location;
}

}  // namespace
}  // namespace squat::dynamics
