#include "text/Cells.h"

#include <gtest/gtest.h>

namespace squat::text {
namespace {

using Rows = std::vector<std::vector<std::string>>;

TEST(Cells, AreThoseOfAnyDelimiter) {
  const Rows expected{{"a", "b"}, {"1.5", "squat"}, {"-2", ""}};
  EXPECT_EQ(cellsOf("a,b\n1.5,squat\n-2,\n", "test").rows, expected);
  EXPECT_EQ(cellsOf("\xEF\xBB\xBF"
                    "a;b\r\n1,5;squat\r\n-2;\r\n",
                    "test")
                .rows,
            expected);
  EXPECT_EQ(cellsOf("# by hand\na\tb\n\n1,5\tsquat\n-2\t\n", "test").rows, expected);
}

TEST(Cells, KeepCommasThatAreNoDecimalOnes) {
  const Rows expected{{"a", "b"}, {"1.5", "2,5 or so"}, {"1,250", "x"}};
  EXPECT_EQ(cellsOf("a;b\n1.5;2,5 or so\n1,250;x\n", "test").rows, expected) << "points are decimal: commas are not";
}

TEST(Cells, MayHoldLineBreaksInQuotes) {
  const auto cells = cellsOf("a,b\n\"x\ny\",2\n3,4\n", "test");
  EXPECT_EQ(cells.rows, (Rows{{"a", "b"}, {"x\ny", "2"}, {"3", "4"}}));
  EXPECT_EQ(cells.lines, (std::vector<std::size_t>{1, 2, 4}));
}

}  // namespace
}  // namespace squat::text
