#include "elasticity/SectionOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace squat::elasticity {
namespace {

constexpr int gridWidth = 15, gridHeight = 13;

// A sheet of nodes, each with its eight neighbours and itself; clusters of 4 x 4 but in the last rows, whose nodes
// stand alone. Numbers are shuffled: 7 is prime to their count.
struct Sheet {
  std::vector<int> rowStart{0}, columns;
  std::vector<std::vector<int>> clusters;

  static int node(int x, int y) { return (x + gridWidth * y) * 7 % (gridWidth * gridHeight); }
  Sheet() {
    std::vector<std::vector<int>> neighbours(gridWidth * gridHeight);
    for (int x = 0; x < gridWidth; ++x)
      for (int y = 0; y < gridHeight; ++y)
        for (int k = std::max(0, x - 1); k < std::min(gridWidth, x + 2); ++k)
          for (int l = std::max(0, y - 1); l < std::min(gridHeight, y + 2); ++l)
            neighbours[node(x, y)].push_back(node(k, l));
    for (auto& own : neighbours) {
      std::sort(own.begin(), own.end());
      columns.insert(columns.end(), own.begin(), own.end());
      rowStart.push_back(static_cast<int>(columns.size()));
    }
    for (int x = 0; x < gridWidth; x += 4)
      for (int y = 0; y < 12; y += 4) {
        clusters.emplace_back();
        for (int k = x; k < std::min(gridWidth, x + 4); ++k)
          for (int l = y; l < y + 4; ++l) clusters.back().push_back(node(k, l));
      }
  }
};

TEST(SectionOrder, EveryNodeHasOneRowAndOnePlace) {
  const Sheet sheet;
  const auto order = sectionOrder(sheet.rowStart, sheet.columns, sheet.clusters);
  for (const auto* list : {&order.nodes, &order.members}) {
    auto sorted = *list;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> all(gridWidth * gridHeight);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
  }
  std::set<std::set<int>> given, found;
  for (const auto& cluster : sheet.clusters) given.emplace(cluster.begin(), cluster.end());
  for (const auto& cluster : order.clusters)
    found.emplace(order.members.begin() + cluster.first, order.members.begin() + cluster.end);
  EXPECT_EQ(found, given);
}

// Neighbours are one front apart, and no front from a corner has more than gridWidth + gridHeight - 1 nodes: two of
// them are enough, whatever the clusters.
TEST(SectionOrder, TheWindowIsThatOfTheSheetNotOfItsClusters) {
  const Sheet sheet;
  const int window = sectionOrder(sheet.rowStart, sheet.columns, sheet.clusters).window;
  EXPECT_EQ(window, sectionOrder(sheet.rowStart, sheet.columns).window);
  EXPECT_LE(window, 2 * (gridWidth + gridHeight - 1));
}

// Goes through the rows as a kernel does: no row may find its column's node missing from the window.
TEST(SectionOrder, ColumnsStandInTheWindowWhenARowNeedsThem) {
  const Sheet sheet;
  const auto order = sectionOrder(sheet.rowStart, sheet.columns, sheet.clusters);
  std::vector<int> standing(order.window, -1);
  int gathered = 0;
  for (std::size_t b = 0; b + 1 < order.bundleStart.size(); ++b)
    for (int pass = 0; pass < 2; ++pass)  // two parts of the stations
      for (int row = order.bundleStart[b]; row < order.bundleStart[b + 1]; ++row) {
        for (; gathered < order.gatherUpTo[row]; ++gathered) standing[gathered % order.window] = order.nodes[gathered];
        for (int p = order.rowStart[row]; p < order.rowStart[row + 1]; ++p)
          ASSERT_EQ(standing[order.slots[p]], sheet.columns[order.pairs[p]]) << row;
      }
}

// The same for the forces that wait: a bundle's rows write theirs part by part, nodes are advanced after the last part,
// advancedPerRow a row; each must find its own force, and all of its cluster's.
TEST(SectionOrder, ForcesStandUntilTheirNodesAreAdvanced) {
  const Sheet sheet;
  const auto order = sectionOrder(sheet.rowStart, sheet.columns, sheet.clusters);
  std::vector<int> standing(order.forceSlots, -1);
  std::size_t cluster = 0;
  int advanced = 0;
  const auto advanceUpTo = [&](int end) {
    for (; advanced < end; ++advanced) ASSERT_EQ(standing[order.memberSlot[advanced]], order.members[advanced]);
  };
  for (std::size_t b = 0; b + 1 < order.bundleStart.size(); ++b) {
    for (int row = order.bundleStart[b]; row < order.bundleStart[b + 1]; ++row) standing[order.rowSlot[row]] = -2;
    for (int row = order.bundleStart[b]; row < order.bundleStart[b + 1]; ++row) {
      standing[order.rowSlot[row]] = order.nodes[row];
      const int ready = order.readyAfter[row];
      for (; cluster < order.clusters.size() && order.clusters[cluster].end <= ready; ++cluster) {
        const auto& own = order.clusters[cluster];
        for (int location = own.first; location < own.end; ++location) {
          EXPECT_EQ(order.memberSlot[location],
                    order.memberSlot[own.first] + location - own.first);  // one piece of memory
          ASSERT_EQ(standing[order.memberSlot[location]], order.members[location]);
        }
      }
      advanceUpTo(std::min(advanced + advancedPerRow, ready));
    }
  }
  EXPECT_EQ(cluster, sheet.clusters.size());
  EXPECT_EQ(order.readyAfter.back(), gridWidth * gridHeight);
  advanceUpTo(gridWidth * gridHeight);
  EXPECT_LT(order.forceSlots, gridWidth * gridHeight);  // slots are used again
}

}  // namespace
}  // namespace squat::elasticity
