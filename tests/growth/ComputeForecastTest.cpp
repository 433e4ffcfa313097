// A forecast from its request to its band: what it says are the growths at its points, computed one by one here.
#include "growth/ComputeForecast.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "TemporaryFolder.h"
#include "core/Errors.h"
#include "growth/SmallRail.h"
#include "studies/CaseStudy.h"

namespace squat::growth {
namespace {

using ::testing::HasSubstr;

// Growths that have ended.
struct EndsMonitor : Monitor {
  void message(const std::string& text) override { ends += text.ends_with(": done"); }
  int ends = 0;
};

class ComputeForecast : public ::testing::Test {
 protected:
  ComputeForecast() {
    cases::saveCase(tests::growingDefect(), path_);
    options_.tonnage = 0.0005 * kilogramsInMegatonne, options_.threads = 1;
  }
  const tests::TemporaryFolder folder_;
  const std::string path_ = folder_ / "dip.toml";
  GrowthOptions options_;
};

TEST_F(ComputeForecast, ItsBandIsThatOfTheGrowthsAtItsPoints) {
  const auto plan =
      forecastPlan(path_, {}, {{"growth.wear_coefficient=5e-5:2e-4"}, 2}, options_, folder_ / "dip-forecast");
  EndsMonitor monitor;
  const auto found = forecastGrowth(plan, monitor);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->growths, 2u);
  EXPECT_EQ(monitor.ends, 2);

  auto each = options_;
  each.threads = plan.threads;
  std::vector<std::vector<double>> depths;
  for (const auto& point : studies::gridOf(plan.study)) {
    Monitor nobody;
    depths.push_back(depthsAt(grow(studies::caseAt(plan.study, {}, point), each, nobody), found->points));
  }
  ASSERT_EQ(depths.size(), 2u);
  constexpr double rounding = 1e-15;  // [m] of depths of 0.15 mm that were millimetres in between
  for (std::size_t i = 0; i < found->points.size(); ++i) {
    EXPECT_NEAR(found->lowest[i], std::min(depths[0][i], depths[1][i]), rounding) << i;
    EXPECT_NEAR(found->highest[i], std::max(depths[0][i], depths[1][i]), rounding) << i;
  }
  EXPECT_LT(found->lowest.back(), found->highest.back());  // the coefficients differ

  // Once more: the table has them.
  EndsMonitor again;
  const auto same = forecastGrowth(plan, again);
  ASSERT_TRUE(same);
  EXPECT_EQ(again.ends, 0);
  EXPECT_NEAR(same->highest.back(), found->highest.back(), rounding);

  try {
    forecastPlan(path_, {}, {{"growth.wear_coefficient=5e-5:3e-4"}, 2}, options_, folder_ / "dip-forecast");
    ADD_FAILURE() << "the folder holds other limits";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.problems().front().advice, HasSubstr("another forecast"));
  }
}

TEST_F(ComputeForecast, IsNothingWhereItWasCancelled) {
  const auto plan = forecastPlan(path_, {}, {{"contact.friction=0.2:0.4"}, 2}, options_, folder_ / "dip-forecast");
  struct : Monitor {
    bool cancelled() override { return true; }
  } stopped;
  EXPECT_FALSE(forecastGrowth(plan, stopped));
}

}  // namespace
}  // namespace squat::growth
