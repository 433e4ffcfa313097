#include "text/DelimitedTable.h"

#include <gmock/gmock.h>

#include <cmath>

namespace squat::text {
namespace {

using ::testing::ElementsAre;

struct LayoutCase {
  const char* text;
  char delimiter, decimal;
  std::size_t columns, rows;
  double last;  // in the last column
};

class Layouts : public testing::TestWithParam<LayoutCase> {};

TEST_P(Layouts, areFound) {
  const auto& c = GetParam();
  const DelimitedTable table = parseDelimitedTable(c.text, "test");
  ASSERT_EQ(table.columns.size(), c.columns) << c.text;
  ASSERT_EQ(table.rows(), c.rows) << c.text;
  const double last = table.columns.back().values.back();
  EXPECT_TRUE(std::isnan(c.last) ? std::isnan(last) : last == c.last) << c.text << " gave " << last;
}

INSTANTIATE_TEST_SUITE_P(Matrix, Layouts,
                         testing::Values(LayoutCase{"1.5,2.5\n3.5,4.5\n", ',', '.', 2, 2, 4.5},
                                         LayoutCase{"t,a\n0,1\n1,2\n", ',', '.', 2, 2, 2},
                                         LayoutCase{"0,5;1,5\n0,6;1,7", ';', ',', 2, 2, 1.7},
                                         LayoutCase{"t;a\r\n0,5;1,5\r\n0,6;1,7\r\n", ';', ',', 2, 2, 1.7},
                                         LayoutCase{"0.5\t-1.5e3\n0.6\t-1.7E-2\n", '\t', '.', 2, 2, -0.017},
                                         LayoutCase{"0,5\t-1,5\n0,6\t-1,7\n", '\t', ',', 2, 2, -1.7},
                                         LayoutCase{"  0.5   1.5\n  0.6   1.75\n", ' ', '.', 2, 2, 1.75},
                                         LayoutCase{"0,001 1,234\n0,002 1,235\n", ' ', ',', 2, 2, 1.235},
                                         LayoutCase{"1.0, 2.0\n2.0, 3.0\n", ',', '.', 2, 2, 3.0},
                                         LayoutCase{"1|2|3\n4|5|6.5\n", '|', '.', 3, 2, 6.5},
                                         LayoutCase{"1.5\n2.5\n3.5", ' ', '.', 1, 3, 3.5},
                                         LayoutCase{"\xEF\xBB\xBFt;a\n1;2\n2;3\n", ';', '.', 2, 2, 3},
                                         LayoutCase{"1;2;\n2;3;\n3;5;\n", ';', '.', 2, 3, 5},
                                         LayoutCase{"# comment\n% another\n1,2\n# inside\n\n3,4\n", ',', '.', 2, 2, 4},
                                         LayoutCase{"time,aba,remark\n0,1,start\n1,2.5,\n2,4,end of run\n", ',', '.', 3,
                                                    3, std::nan("")}),
                         [](const auto& instance) { return "layout" + std::to_string(instance.index); });

TEST(DelimitedTable, preambleHeaderAndUnits) {
  const auto table = parseDelimitedTable(
      "Measuring train 7;;\nDate;2014-01-06;\n\n\"Time\";\"ABA; "
      "left\";Speed\n[s];[m/s2];[km/h]\n0,0;1,5;100\n0,1;2,5;101\n",
      "test");
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.columns[1].name, "ABA; left");
  EXPECT_EQ(table.columns[2].unit, "km/h");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.lines[0], 6u);
  EXPECT_THAT(table.columns[1].values, ElementsAre(1.5, 2.5));
}

// A delimiter before the units as well; a remark below the heading that happens to have as many fields.
TEST(DelimitedTable, headingsOfOtherMakes) {
  for (const char* text : {"time, ms, aba, g\n0,1\n1,2\n", "time [ms],aba [g]\n# cleaned,3 March\n0,1\n1,2\n",
                           "# by hand,3 March\n# time [ms],aba [g]\n0,1\n1,2\n"}) {
    const auto table = parseDelimitedTable(text, "test");
    ASSERT_EQ(table.columns.size(), 2U) << text;
    EXPECT_EQ(table.columns[0].name, "time") << text;
    EXPECT_EQ(table.columns[0].unit, "ms") << text;
    EXPECT_EQ(table.columns[1].name, "aba") << text;
    EXPECT_EQ(table.columns[1].unit, "g") << text;
  }
  // Without units, the remark nearest to the numbers stays the heading.
  EXPECT_EQ(parseDelimitedTable("# made,today\n# time,aba\n0,1\n1,2\n", "test").columns[1].name, "aba");
}

TEST(DelimitedTable, unitsInTheHeader) {
  const auto table = parseDelimitedTable("time [ms], aba (g), km\n0,1,12+000.0\n1,2,12+000.5\n", "test");
  EXPECT_EQ(table.columns[0].name, "time");
  EXPECT_EQ(table.columns[0].unit, "ms");
  EXPECT_EQ(table.columns[1].unit, "g");
  EXPECT_TRUE(table.columns[2].kilometresAndMetres);
  EXPECT_DOUBLE_EQ(table.columns[2].values[1], 12000.5);
}

}  // namespace
}  // namespace squat::text
