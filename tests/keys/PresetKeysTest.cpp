// Presets: what the model is made of with them.
#include <gtest/gtest.h>

#include <cmath>

#include "keys/Keys.h"
#include "scenario/WheelsetMass.h"

namespace squat {
namespace {

// By hand: solids of revolution of the preset's dimensions (rim 183.9, web 93.6, hub 81.4, axle between the
// wheels 93.7, shoulder 8.8, journal 15.9 kg), axle box 120 kg, one disc of 90 kg.
TEST(PresetKeys, TheTrailerWheelsetWeighsWhatItsPartsDo) {
  const auto model = tests::modelWith({{"wheelset.preset", "trailer"}});
  EXPECT_NEAR(model.wheelset.mass, 183.9 + 93.6 + 81.4 + 93.7 + 8.8 + 15.9 + 120 + 90, 0.5);  // roundings
  EXPECT_EQ(model.scenario.wheelset.brakeDiscs, 1);
  EXPECT_EQ(model.scenario.suspension.sprungMass, 5525);
}

// Springs of a pad and of the ballast under a half sleeper add up to what the preset says.
TEST(PresetKeys, SoftPadsAreSoft) {
  const auto model = tests::modelWith({{"track.preset", "soft-pads"}});
  const auto sum = [&](forces::Kind kind) {
    double stiffness = 0, damping = 0;
    for (const auto& set : model.forceElements)
      for (std::size_t i = 0; set.kind == kind && i < set.size(); ++i)
        stiffness += set.stiffness[i], damping += set.damping[i];
    return std::pair{stiffness / model.sleepers, damping / model.sleepers};
  };
  const auto [pads, padDamping] = sum(forces::Kind::railPad);
  EXPECT_NEAR(pads, 200e6 + 20e6 + 20e6, 1);
  EXPECT_NEAR(padDamping, 28e3 + 2.8e3 + 2.8e3, 1e-3);
  const auto [ballast, ballastDamping] = sum(forces::Kind::ballast);
  EXPECT_NEAR(ballast, 40e6 + 18e6 + 18e6, 1);
  EXPECT_NEAR(ballastDamping, 47e3 + 21e3 + 21e3, 1e-3);
}

}  // namespace
}  // namespace squat
