// Meshes: sizes and counts that the keys of the mesh promise, and the layer that may yield.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/StableStep.h"
#include "geometry/RailSection.h"
#include "keys/Keys.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::scenarioWith;

// Across the running surface faces are of the contact size within the band, and larger beyond it. They are equal along
// the outline, y is across: 15 mm from the middle it leans by 10/300 + 5/80 rad, so that a face is up to 0.25 %
// narrower or wider than its size.
TEST(MeshKeys, TheBandIsFine) {
  const auto model = modelWith({{"mesh.band_half_width", "15"}, {"mesh.contact_size", "5"}});
  const auto& y = model.surfaces.railY;
  int inside = 0;
  for (std::size_t j = 0; j + 1 < y.size(); ++j) {
    const double size = y[j + 1] - y[j];
    if (std::max(std::abs(y[j]), std::abs(y[j + 1])) < 0.015 + 1e-6) {
      EXPECT_NEAR(size, 0.005, 0.0025 * 0.005) << y[j];
      ++inside;
    } else {
      EXPECT_GT(std::abs(y[j]), 0.9975 * 0.015) << "a face across the edge of the band";
    }
  }
  EXPECT_EQ(inside, 6);
}

TEST(MeshKeys, TheWheelHasItsSectors) {
  for (const int sectors : {32, 48}) {
    const auto model = modelWith({{"mesh.wheel_sectors", std::to_string(sectors)}});
    EXPECT_EQ(model.blocks[model.body].intervals, sectors);
  }
}

// Elements of rail and rim grow to about the size that the key asks for: more than half of it, where parts are larger
// than that, and less than twice it, since thin parts (the foot, the web) have whole numbers of rows that widen with
// them.
TEST(MeshKeys, SectionsGrowToTheirSize) {
  std::size_t quads = 0;
  for (const double size : {24.0, 8.0}) {
    const auto model = modelWith({{"mesh.section_size", std::to_string(size)},
                                  {"mesh.section_growth", "2"},
                                  {"mesh.contact_size", "5"},
                                  {"mesh.rim_depth", "60"}});
    for (const auto which : {model.rail, model.rim}) {
      const auto& section = model.blocks[which].section;
      double largest = 0;
      for (const auto& quad : section.quads)
        for (int i = 0; i < 4; ++i) {
          const auto& a = section.nodes[quad[i]];
          const auto& b = section.nodes[quad[(i + 1) % 4]];
          largest = std::max(largest, 1e3 * std::hypot(a[0] - b[0], a[1] - b[1]));
        }
      EXPECT_GT(largest, 0.5 * size) << model.blocks[which].name;
      EXPECT_LT(largest, 2 * size) << model.blocks[which].name;
    }
    EXPECT_GT(model.blocks[model.rail].section.quads.size(), quads);
    quads = model.blocks[model.rail].section.quads.size();
  }
}

// Rows of the rim from the tread downwards: the first of the contact size, each at most that much larger than the one
// above, and in as few rows as will do.
TEST(MeshKeys, SectionsGrowSlowly) {
  for (const double growth : {1.2, 1.6}) {
    const auto model = modelWith({{"mesh.section_growth", std::to_string(growth)}, {"mesh.rim_depth", "30"}});
    std::vector<double> radii;
    for (const auto& p : model.blocks[model.rim].section.nodes) radii.push_back(p[0]);
    std::sort(radii.begin(), radii.end(), std::greater<>());
    radii.erase(std::unique(radii.begin(), radii.end(), [](double a, double b) { return a - b < 1e-9; }), radii.end());
    EXPECT_NEAR(radii.front() - radii.back(), 0.03, 1e-9);
    ASSERT_GE(radii.size(), 3u);
    for (std::size_t i = 2; i < radii.size(); ++i) {
      const double ratio = (radii[i - 1] - radii[i]) / (radii[i - 2] - radii[i - 1]);
      EXPECT_LE(ratio, growth * (1 + 1e-9)) << growth;
    }
    // The fewest rows of 5, 5 g, 5 g^2 ... mm that reach 30 mm deep.
    std::size_t fewest = 0;
    for (double covered = 0, row = 0.005; covered < 0.03 - 1e-9; row *= growth) covered += row, ++fewest;
    EXPECT_EQ(radii.size() - 1, fewest) << growth;
  }
}

TEST(MeshKeys, PresetSetsTheOthers) {
  const auto tiny = scenarioWith({}),
             paper = cases::loadScenario(tests::fixtureCase("smooth-rail"), {"", {{"mesh.preset", "paper"}}});
  EXPECT_EQ(tiny.mesh.contactSize, 5e-3);
  EXPECT_EQ(paper.mesh.contactSize, 1.3e-3);  // the paper
  EXPECT_EQ(paper.motion.runUp, 1);
}

// The elements whose middle lies less than the depth below the crown, and none else; their plastic modulus is that of a
// bilinear curve with the tangent modulus, E Et / (E - Et).
TEST(LayerKeys, DepthAndTangentModulus) {
  const auto model = modelWith({{"rail.plastic", "true"},
                                {"rail.plastic_depth", "12"},
                                {"rail.tangent_modulus", "30"},
                                {"rail.yield_stress", "0.5"}});
  EXPECT_NEAR(model.layer.law.isotropic, 210e9 * 30e9 / (210e9 - 30e9), 1);
  EXPECT_NEAR(model.layer.law.yieldStress, 0.5e9, 1);
  const auto& section = model.blocks[model.rail].section;
  int inside = 0, below = 0;
  for (std::size_t q = 0; q < section.quads.size(); ++q) {
    geometry::Point2 centre{0, 0};
    for (const int n : section.quads[q]) centre[0] += section.nodes[n][0] / 4, centre[1] += section.nodes[n][1] / 4;
    if (std::abs(centre[0]) > 0.005) continue;  // columns that the wheel touches for certain
    const double depth = geometry::crownHeight54E1(centre[0]) - centre[1];
    if (std::abs(depth - 0.012) < 1e-4) continue;  // faces of the mesh are chords of the crown
    EXPECT_EQ(model.layer.indexOfQuad[q] >= 0, depth < 0.012) << depth;
    ++(depth < 0.012 ? inside : below);
  }
  EXPECT_GT(inside, 2);
  EXPECT_GT(below, 2);
}

// Beta as stated; or from the share of critical damping at the highest frequency w of the mesh, 2 D / w.
TEST(DampingKeys, MakeTheCoefficient) {
  const auto stepOf = [](const tests::Values& values) {
    auto all = values;
    all.push_back({"mesh.selective_inertia", "false"});
    const auto model = modelWith(all);
    ThreadTeam team(1);
    Monitor quiet;
    return dynamics::stableStep(model, elasticity::kernelsFor(""), team, quiet);
  };
  EXPECT_NEAR(stepOf({{"damping.beta", "0.2"}}).beta, 2e-7, 1e-18);
  const auto share = stepOf({{"damping.fraction", "0.04"}});
  EXPECT_NEAR(share.beta * share.highestFrequency / 2, 0.04, 1e-12);
}

}  // namespace
}  // namespace squat
