// Colour maps must be readable in grey: luminance rises all the way.
#include <gtest/gtest.h>

#include <cmath>

#include "colours/ColourTables.h"

namespace squat {
namespace {

TEST(ColourTables, defaultMapsRiseInLuminance) {
  for (const char* map : {"viridis", "cividis"}) {
    double before = -1;
    for (int i = 0; i <= 255; ++i) {
      const double now = colours::luminance(colours::colourAt(map, i / 255.0));
      EXPECT_GT(now, before) << map << " at " << i;
      before = now;
    }
    EXPECT_GT(before, 0.6) << map;
  }
}

TEST(ColourTables, jetDoesNot) {
  EXPECT_GT(colours::luminance(colours::colourAt("jet", 0.4)), colours::luminance(colours::colourAt("jet", 1.0)));
}

TEST(ColourTables, endsAndNonsenseAreClamped) {
  EXPECT_EQ(colours::colourAt("viridis", -3).red, colours::colourAt("viridis", 0).red);
  EXPECT_EQ(colours::colourAt("viridis", 7).blue, colours::colourAt("viridis", 1).blue);
  EXPECT_EQ(colours::colourAt("viridis", NAN).green, colours::colourAt("viridis", 0).green);
}

TEST(ColourTables, curvesAreDistinctInLuminanceOrHue) {
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = colours::curveColour(i), b = colours::curveColour(j);
      EXPECT_GT(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue), 0.3);
    }
}

}  // namespace
}  // namespace squat
