// Names of arrays that only references reach, as in files of MATLAB 7.3.
#include "readers/ArrayItems.h"

#include <gmock/gmock.h>

#include <cmath>

#include "readers/ArraySignals.h"
#include "results/Hdf5.h"

namespace squat::readers {
namespace {

using ::testing::ElementsAre;

results::Array& addCell(results::ArrayTree& tree, const std::string& path, std::vector<std::string> targets) {
  auto& cell = tree.add(path, std::move(targets), "");
  setAttribute(cell.attributes, "MATLAB_class", std::string("cell"));
  setAttribute(cell.attributes, results::referencesAttribute, std::uint8_t{1});
  return cell;
}

std::vector<std::string> pathsOf(const results::ArrayTree& tree) {
  std::vector<std::string> paths;
  for (const auto& item : itemsOf(tree)) paths.push_back(item.path);
  return paths;
}

TEST(ArrayItems, CellsWithinCellsAreNamedFromOutsideIn) {
  results::ArrayTree tree;
  tree.add("/#refs#/left", std::vector<double>{1, 2}, "");
  tree.add("/#refs#/right", std::vector<double>{3, 4}, "");
  tree.add("/#refs#/unused", std::vector<double>{5, 6}, "");
  addCell(tree, "/#refs#/inner", {"/#refs#/left", "/#refs#/right"});
  addCell(tree, "/data", {"/#refs#/inner"});
  EXPECT_THAT(pathsOf(tree), ElementsAre("/data{1}{1}", "/data{1}{2}"));
}

TEST(ArrayItems, ACellThatHoldsItselfHasNoName) {
  results::ArrayTree tree;
  tree.add("/aba", std::vector<double>{1, 2}, "");
  tree.add("/#refs#/lost", std::vector<double>{1, 2}, "");
  addCell(tree, "/#refs#/a", {"/#refs#/b", "/#refs#/lost"});
  addCell(tree, "/#refs#/b", {"/#refs#/a"});
  EXPECT_THAT(pathsOf(tree), ElementsAre("/aba"));
}

// The rate of a group counts for the channels that are groups within it; that of one channel does not count for
// another.
TEST(ArrayItems, ARateAboveTheChannelsCounts) {
  results::ArrayTree tree;
  for (const char* channel : {"left", "right"})
    tree.add("/train/" + std::string(channel) + "/data", std::vector<double>{1, 2, 3}, "g");
  setAttribute(tree.addGroup("/train").attributes, "sampling_rate", 25000.0);
  EXPECT_EQ(columnsOf("made.h5", tree, {}).options.rate, 25000);
  SignalFileOptions right;
  right.object = "/train/right/data";
  EXPECT_EQ(columnsOf("made.h5", tree, right).options.rate, 25000);
  tree.addScalar("/train/left/fs", 5000, "Hz");
  EXPECT_EQ(columnsOf("made.h5", tree, right).options.rate, 25000);
}

// CF conventions: number = scale_factor * stored + add_offset, and none where _FillValue is stored.
TEST(ArrayItems, PackedNumbersAndMissingOnes) {
  results::ArrayTree tree;
  auto& packed = tree.add("/box", std::vector<std::int32_t>{100, -32768}, "m/s2");
  setAttribute(packed.attributes, "scale_factor", 0.5);
  setAttribute(packed.attributes, "add_offset", 7.0);
  setAttribute(packed.attributes, "_FillValue", std::int64_t{-32768});
  const auto values = columnsOf("made.nc", tree, {}).table.columns.at(0).values;
  EXPECT_EQ(values.at(0), 57);
  EXPECT_TRUE(std::isnan(values.at(1)));
}

// Fields of an array of structures, one of which is such an array itself.
TEST(ArrayItems, StructuresWithinStructures) {
  results::ArrayTree tree;
  tree.add("/#refs#/x", std::vector<double>{1, 2}, "");
  auto& inner = addCell(tree, "/#refs#/g/values", {"/#refs#/x"});
  setAttribute(inner.attributes, "MATLAB_class", std::string());
  auto& outer = addCell(tree, "/run/box", {"/#refs#/g"});
  setAttribute(outer.attributes, "MATLAB_class", std::string());
  EXPECT_THAT(pathsOf(tree), ElementsAre("/run(1)/box(1)/values"));
}

}  // namespace
}  // namespace squat::readers
