// Tables for a terminal.
#include "text/TextTable.h"

#include <gtest/gtest.h>

namespace squat::text {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
  TextTable table({"key", "value"});
  table.add({"speed", "30 m/s²"});
  EXPECT_EQ(table.text(), "key    value\n--------------\nspeed  30 m/s²\n");
}

TEST(TextTable, TheWidestColumnIsWrappedBetweenWords) {
  TextTable table({"what", "text"});
  table.add({"a", "one two three"});
  table.add({"b", "four"});
  EXPECT_EQ(table.text(15), "what  text\n---------------\na     one two\n      three\nb     four\n");
}

TEST(TextTable, AWordThatIsTooLongStaysWhole) {
  TextTable table({"a", "b"});
  table.add({"1", "incompressible"});
  EXPECT_EQ(table.text(8), "a  b\n-----------------\n1  incompressible\n");
}

}  // namespace
}  // namespace squat::text
