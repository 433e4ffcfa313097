// Colour maps must be readable in grey: luminance rises all the way.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "colours/ColourTables.h"
#include "plots/Style.h"

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

// CIE 1976 L*a*b* under D65 (IEC 61966-2-1 and CIE 15), as the header states its distance.
std::array<double, 3> lab(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double r = linear(colour.redF()), g = linear(colour.greenF()), b = linear(colour.blueF());
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047), y = f(0.2126 * r + 0.7152 * g + 0.0722 * b),
               z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const QColor& one, const QColor& other) {
  const auto a = lab(one), b = lab(other);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Axle box, wheel centre, six overlaid runs and the ground they are drawn on, light and dark.
TEST(ColourTables, overlaidRunsAreToldFromTheShownOneAndFromEachOther) {
  for (const auto& style : {plots::lightStyle(), plots::darkStyle()}) {
    std::vector<QColor> all{style.background, style.curve(0), style.curve(1)};
    for (std::size_t i = 0; i < colours::overlayColours; ++i) all.push_back(style.overlay(i));
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i < 3 ? 3 : i + 1; j < all.size(); ++j)
        EXPECT_GT(distance(all[i], all[j]), 40) << all[i].name().toStdString() << ' ' << all[j].name().toStdString();
  }
}

}  // namespace
}  // namespace squat
