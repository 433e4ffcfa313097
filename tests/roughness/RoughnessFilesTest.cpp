// Roughness as tables.
#include "roughness/RoughnessFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace squat::roughness {
namespace {

using testing::HasSubstr;

RecordRoughness someRoughness() {
  RecordRoughness roughness;
  for (const auto& band : wavelengthBands(0.04, 0.05)) {
    RoughnessLevel level;
    level.band = band, level.level = 3.25, level.lowest = 1, level.highest = 6, level.waves = 12;
    roughness.levels.push_back(level);
  }
  roughness.levels.back().level = std::nan("");
  roughness.corrugation.push_back({corrugationBands()[1], 1e-6, 1e-6, 2e-6, 3e-6, 4.5, 7});
  roughness.length = 10, roughness.speed = 20, roughness.left = 2.5;
  return roughness;
}

TEST(RoughnessFiles, TablesHaveTheLimitBesideTheLevels) {
  EXPECT_THAT(roughnessCsv(someRoughness()), HasSubstr("\n39.810717055349734,3.25,1,6,-3.2,"));
  const auto json = roughnessJson({{"aba", someRoughness()}}, {}, "some-case");
  EXPECT_THAT(json, HasSubstr("\"schema\": \"squat-roughness\""));
  EXPECT_THAT(json, HasSubstr("\"iso_3095_db\": -3.2"));
  EXPECT_THAT(json, HasSubstr("\"level_db\": null"));
  EXPECT_THAT(json, HasSubstr("\"largest_um\": 3.0"));
}

TEST(RoughnessFiles, TheSummarySaysWhatIsLeftOut) {
  const auto text = roughnessSummary({"aba", someRoughness()});
  EXPECT_THAT(text, HasSubstr("10 m at 20 m/s"));
  EXPECT_THAT(text, HasSubstr("39.8 mm"));
  EXPECT_THAT(text, testing::Not(HasSubstr("50.1 mm")));
  EXPECT_THAT(text, HasSubstr("2.5 m left out"));
}

TEST(RoughnessFiles, HaveNamesOfTheirOwn) {
  EXPECT_EQ(fileStem({{"aba", {}}}, 0), "aba_roughness");
  EXPECT_EQ(fileStem({{"aba", {}}, {"aba", {}}}, 1), "2-aba_roughness");
}

}  // namespace
}  // namespace squat::roughness
