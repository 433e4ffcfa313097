// Meshes: sizes and counts that the keys of the mesh promise, where the sleepers are, and the layer that may yield.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dynamics/StableStep.h"
#include "geometry/RailSection.h"
#include "geometry/Stations.h"
#include "keys/Keys.h"

namespace squat {
namespace {

using tests::modelWith;
using tests::scenarioWith;

// A run with room for elements of every length: the wheel starts at -0.5 m.
model::Model longerRun(const tests::Values& values) {
  tests::Values all{{"motion.run_up", "0.5"}, {"motion.beyond", "0.3"}};
  all.insert(all.end(), values.begin(), values.end());
  return modelWith(all);
}

// Rail elements of the contact size reach from `from` to `to` [m] at least. Their number is rounded up to a multiple of
// eight, so that they reach less than eight elements further in all. Tolerances: round-off of positions.
void expectFine(const model::Model& model, double from, double to) {
  const auto& x = model.blocks[model.rail].positions;
  const double size = model.scenario.mesh.contactSize;
  const auto isFine = [&](std::size_t i) { return i + 1 < x.size() && x[i + 1] - x[i] < size * (1 + 1e-6); };
  auto first = static_cast<std::size_t>(geometry::intervalOf(x, 0.5 * (from + to)).first);
  ASSERT_TRUE(isFine(first)) << from << " to " << to;
  auto behind = first;
  while (first > 0 && isFine(first - 1)) --first;
  while (isFine(behind)) ++behind;
  EXPECT_LE(x[first], from + 1e-9);
  EXPECT_GE(x[behind], to - 1e-9);
  EXPECT_LT(x[behind] - x[first], to - from + 8 * size);
}

TEST(MeshKeys, TheStartIsFineOnBothSides) {
  for (const double side : {25.0, 65.0})
    expectFine(longerRun({{"mesh.fine_start", std::to_string(side)}}), -0.5 - 1e-3 * side, -0.5 + 1e-3 * side);
}

// A dip of 60 mm reaches 30 mm to both sides of its deepest point.
TEST(MeshKeys, TheDefectIsFineBeyondItsEnds) {
  for (const double beyond : {25.0, 65.0})
    expectFine(longerRun({{"defect.shape", "cosine"},
                          {"defect.length", "60"},
                          {"defect.depth", "0.1"},
                          {"mesh.fine_before", std::to_string(beyond)}}),
               -0.030 - 1e-3 * beyond, 0.030 + 1e-3 * beyond);
}

// A dip that ends 30 mm behind its deepest point gets the mesh of those that end up to 150 mm behind; in front of it
// nothing changes.
TEST(MeshKeys, TheZoneReachesBehindTheDefect) {
  for (const auto& [zone, behind] : {std::pair{"0", 0.030}, std::pair{"20", 0.030}, std::pair{"150", 0.150}})
    expectFine(longerRun({{"defect.shape", "cosine"},
                          {"defect.length", "60"},
                          {"defect.depth", "0.1"},
                          {"mesh.fine_before", "10"},
                          {"mesh.zone_behind", zone}}),
               -0.040, behind + 0.010);
}

// Between the fine elements of start and defect, which end 55 mm from -0.5 m and 46 mm from 0 at most, all are as long
// as may be: the fewest multiple of eight that the size allows. At 0.39 m and more, and 10 mm or less, these are five
// eights: with one eight fewer they would be longer than the size, so they are longer than four fifths of it.
TEST(MeshKeys, RolledElementsHaveTheirSize) {
  for (const double size : {0.006, 0.010}) {
    const auto model = longerRun({{"mesh.rolling_size", std::to_string(1e3 * size)}});
    const auto& x = model.blocks[model.rail].positions;
    int between = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      if (x[i] < -0.445 || x[i + 1] > -0.046) continue;
      EXPECT_LE(x[i + 1] - x[i], size * (1 + 1e-9)) << x[i];
      EXPECT_GT(x[i + 1] - x[i], 0.8 * size) << x[i];
      ++between;
    }
    EXPECT_GT(between, 0);
  }
}

// Half a band of three columns has one left below the upper head, down to the base: four nodes fewer there in all, and
// none fewer on the running surface. Four columns have no three to merge. The base is 159 mm below (EN 13674-1).
TEST(MeshKeys, TheWebIsCoarse) {
  const auto nodesOf = [](const char* halfWidth, const char* coarse) {
    const auto model =
        modelWith({{"mesh.contact_size", "2"}, {"mesh.band_half_width", halfWidth}, {"mesh.coarse_web", coarse}});
    const auto& nodes = model.blocks[model.rail].section.nodes;
    const auto base = std::count_if(nodes.begin(), nodes.end(), [](const auto& p) { return p[1] < -0.159 + 1e-9; });
    return std::pair{model.surfaces.railY.size(), base};
  };
  const auto three = nodesOf("6", "false"), merged = nodesOf("6", "true");
  EXPECT_EQ(merged.first, three.first);
  EXPECT_EQ(merged.second, three.second - 2 * (3 - 1));
  EXPECT_EQ(nodesOf("8", "true"), nodesOf("8", "false"));
}

// One sleeper is below the defect; a rail of 4 m has room for two more on each side, a third would be beyond its ends.
// 1e-12 m: round-off of positions of some metres.
TEST(TrackKeys, SleepersStandTheirSpacingApart) {
  const auto model = modelWith({{"track.length", "4"}, {"track.sleeper_spacing", "0.7"}});
  ASSERT_EQ(model.sleepers, 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(model.sleeperPositions[static_cast<std::size_t>(i)], 0.7 * (i - 2), 1e-12);
    EXPECT_NEAR(model.blocks[static_cast<std::size_t>(model.firstSleeper + i)].origin[0], 0.7 * (i - 2), 1e-12);
  }
}

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
    const double depth = geometry::crownHeight(geometry::RailSection::rail54E1, centre[0]) - centre[1];
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
