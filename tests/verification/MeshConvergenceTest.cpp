// The light defect on `tiny` and with contact elements half as long: what the coarsest mesh leaves to its elements, in
// seconds. The finer meshes against the paper's: MeshConvergenceLongTest.cpp.
// Tolerance: 5 % of the peak of the filtered axle box acceleration, as there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "simulation/RunCase.h"
#include "verification/Seen.h"

namespace squat::simulation {
namespace {

// Axle box acceleration from 50 mm before the deepest point, where the peak lies, to 20 mm behind it. Half as long, so
// that each coarse element is two fine ones and both see the defect at the same nodes.
std::vector<double> accelerationWith(const std::string& contactSize) {
  RunOptions options;
  options.threads = 1;
  options.wheelsetModes = options.snapshots = false;
  Monitor quiet;
  const auto description = cases::loadCase(
      tests::fixtureCase("light-defect"),
      {"tiny", {{"motion.run_up", "0.05"}, {"motion.beyond", "0.02"}, {"mesh.contact_size", contactSize}}});
  return *runCase(description, options, quiet).signal("aba_filtered");
}

TEST(MeshConvergence, TinyIsThatOfElementsHalfAsLong) {
  const auto coarse = accelerationWith("5"), fine = accelerationWith("2.5");
  ASSERT_EQ(coarse.size(), fine.size());
  double peak = 0, difference = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    peak = std::max(peak, std::abs(fine[i]));
    difference = std::max(difference, std::abs(coarse[i] - fine[i]));
  }
  EXPECT_GT(difference, 0);  // the meshes are two
  EXPECT_LT(difference, 0.05 * peak);
  verification::seen("difference", 100 * difference / peak, "%");
}

}  // namespace
}  // namespace squat::simulation
