// The smallest force of each wheel: values by hand, a sample every 0.1 ms.
#include "analysis/WheelForces.h"

#include <gtest/gtest.h>

namespace squat::analysis {
namespace {

signals::Record recordOf(const std::vector<signals::Channel>& forces) {
  signals::Record record;
  for (std::size_t i = 0; i < forces.at(0).values.size(); ++i) record.time.push_back(1e-4 * static_cast<double>(i));
  record.signals = forces;
  return record;
}

signals::Channel force(const std::string& name, const std::vector<double>& values) { return {name, "N", "", values}; }

TEST(WheelForces, AWheelThatStaysOnTheRailHasASmallestForce) {
  const auto wheels = wheelForces(recordOf({force("contact_force", {9e4, 1.2e5, 300, 9e4})}));
  ASSERT_EQ(wheels.size(), 1U);
  EXPECT_EQ(wheels[0].wheel, "wheel");
  EXPECT_EQ(wheels[0].smallest, 300);  // 2.5 thousandths of the largest
  EXPECT_FALSE(wheels[0].liftOff);
  EXPECT_EQ(wheels[0].aloft, 0);
}

// Twice in the air, three samples in all; what the filter leaves there is no force.
TEST(WheelForces, AWheelThatLiftsOffHasNone) {
  const auto wheels = wheelForces(recordOf({force("contact_force", {9e4, 5e4, 60, -40, 1.2e5, 0, 9e4})}));
  ASSERT_EQ(wheels.size(), 1U);
  EXPECT_EQ(wheels[0].smallest, 0);
  ASSERT_TRUE(wheels[0].liftOff);
  EXPECT_DOUBLE_EQ(*wheels[0].liftOff, 2e-4);
  EXPECT_NEAR(wheels[0].aloft, 3e-4, 1e-12);
}

TEST(WheelForces, WheelsAreNamedByWhatTheRecordHolds) {
  const auto namesOf = [](const signals::Record& record) {
    std::vector<std::string> names;
    for (const auto& each : wheelForces(record)) names.push_back(each.wheel);
    return names;
  };
  using Names = std::vector<std::string>;
  const auto half = force("contact_force", {1, 1}), right = force("contact_force_right", {2, 2});
  const auto second = force("second_contact_force", {3, 3}), secondRight = force("second_contact_force_right", {4, 4});
  EXPECT_EQ(namesOf(recordOf({half, second})), (Names{"wheel", "wheel of the second wheelset"}));
  EXPECT_EQ(namesOf(recordOf({half, right})), (Names{"left wheel", "right wheel"}));
  const auto all = wheelForces(recordOf({half, second, right, secondRight}));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[1].wheel, "right wheel");
  EXPECT_EQ(all[1].smallest, 2);
  EXPECT_EQ(all[2].wheel, "left wheel of the second wheelset");
  EXPECT_EQ(all[2].smallest, 3);
  EXPECT_EQ(all[3].wheel, "right wheel of the second wheelset");
  EXPECT_EQ(all[3].smallest, 4);
  signals::Record none;
  EXPECT_TRUE(wheelForces(none).empty());
}

}  // namespace
}  // namespace squat::analysis
