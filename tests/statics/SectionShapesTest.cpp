// The softest shapes of a slender section are those of a free beam.
#include "statics/SectionShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "elasticity/SweptSamples.h"

namespace squat::statics {
namespace {

// Of a strip 20 times as long as thick, c along it. Free beams have their nodes at 0.2242 and 0.7758 of the length in
// the first shape, at 0.1321, 0.5 and 0.8679 in the second (Young and Felgar 1949). Shear and the elements' size move
// them by less than a hundredth of the length at this slenderness.
TEST(SectionShapes, SlenderStripBendsAsAFreeBeam) {
  constexpr double length = 0.2, thickness = 0.01;
  elasticity::SweptBlock block;
  block.section = elasticity::gridSection(elasticity::evenly(0, thickness, 2), elasticity::evenly(0, length, 80), 0);
  block.stations = {0, false, {{8, 0.05}}};
  block.material = elasticity::steel;
  std::vector<elasticity::SweptBlock> blocks{block};
  elasticity::layOut(blocks);
  const auto shapes = softestShapes(blocks[0], 2);
  ASSERT_EQ(shapes.size(), 2u);
  // Deflection (b) of the node nearest to a place along the strip, on its lower face.
  const auto deflectionAt = [&](const SectionShape& shape, double place) {
    std::size_t nearest = 0;
    double best = 1;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const auto& p = blocks[0].section.nodes[i];
      const double away = std::abs(p[1] - place * length) + std::abs(p[0]);
      if (away < best) best = away, nearest = i;
    }
    return shape[nearest][0];
  };
  const auto zeroNear = [&](const SectionShape& shape, double place) {
    double previous = deflectionAt(shape, place - 0.05);
    for (double at = place - 0.05 + 1 / 80.0; at < place + 0.06; at += 1 / 80.0) {
      const double here = deflectionAt(shape, at);
      if (previous * here <= 0) return at - here / (here - previous) / 80;
      previous = here;
    }
    return -1.0;
  };
  for (const double place : {0.2242, 0.7758}) EXPECT_NEAR(zeroNear(shapes[0], place), place, 0.01);
  for (const double place : {0.1321, 0.5, 0.8679}) EXPECT_NEAR(zeroNear(shapes[1], place), place, 0.01);
  for (const auto& shape : shapes) {
    double largest = 0;
    for (const auto& displacement : shape)
      largest = std::max({largest, std::abs(displacement[0]), std::abs(displacement[1])});
    EXPECT_DOUBLE_EQ(largest, 1);
  }
}

}  // namespace
}  // namespace squat::statics
