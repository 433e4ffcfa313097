// `squat describe`: the table for people and the JSON that scripts rely on.
#include "case/CaseText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "case/MeshPresets.h"
#include "case/ParameterValue.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

TEST(CaseText, JsonHasARowForEveryParameter) {
  const auto rows = nlohmann::json::parse(describeJson(defaultCase()));
  ASSERT_TRUE(rows.is_array());
  ASSERT_EQ(rows.size(), parameterTable().size());
  for (const auto& row : rows) {
    for (const char* field : {"key", "value", "unit", "default", "min", "max", "doc", "group", "source"})
      EXPECT_TRUE(row.contains(field)) << row["key"] << " lacks " << field;
    const bool isNumber = row["kind"] == "number";
    EXPECT_EQ(row["value"].is_number(), isNumber) << row["key"];
    EXPECT_EQ(row["default"].is_number(), isNumber) << row["key"];
    EXPECT_EQ(row["min"].is_number(), isNumber) << row["key"];
    EXPECT_EQ(row["max"].is_number(), isNumber) << row["key"];
  }
}

TEST(CaseText, JsonHoldsValuesInTheUnitOfTheCaseFile) {
  CaseDescription description = defaultCase();
  setValue(description, "pad.stiffness", "550");
  setValue(description, "title", "A \"name\" with µ");
  setValue(description, "defect.points", "[[0, 0], [5, -0.1]]");
  const auto rows = nlohmann::json::parse(describeJson(description));
  const auto find = [&](const char* key) {
    for (const auto& row : rows)
      if (row["key"] == key) return row;
    return nlohmann::json();
  };
  EXPECT_EQ(find("pad.stiffness")["value"], 550);
  EXPECT_EQ(find("pad.stiffness")["default"], 1300);
  EXPECT_EQ(find("pad.stiffness")["unit"], "MN/m");
  EXPECT_EQ(find("pad.stiffness")["group"], "pad");
  EXPECT_EQ(find("title")["value"], "A \"name\" with µ");
  EXPECT_EQ(find("rail.plastic")["value"], false);
  EXPECT_EQ(find("defect.shape")["choices"].size(), 6u);
  EXPECT_EQ(find("defect.points")["value"], nlohmann::json::parse("[[0.0, 0.0], [5.0, -0.1]]"));
}

TEST(CaseText, TableNamesEveryKeyAndMarksChanges) {
  CaseDescription description = defaultCase();
  setValue(description, "pad.stiffness", "550");
  const std::string table = describeTable(description);
  for (const auto& parameter : parameterTable()) EXPECT_THAT(table, HasSubstr(" " + parameter.key + " "));
  EXPECT_THAT(table, HasSubstr("* pad.stiffness"));
  EXPECT_THAT(table, HasSubstr("550 MN/m"));
  EXPECT_THAT(table, testing::Not(HasSubstr("* pad.damping")));
}

// A value of the preset paper is not one of the preset draft.
TEST(CaseText, MeshValuesAreFromThePresetThatIsChosen) {
  CaseDescription description = defaultCase();
  applyPreset(description, MeshPreset::paper);
  setValue(description, "mesh.far_size", "60");
  const std::string table = describeTable(description);
  EXPECT_THAT(table, HasSubstr("[mesh preset paper]"));
  EXPECT_THAT(table, testing::Not(HasSubstr("[mesh preset draft]")));
  EXPECT_THAT(table, testing::ContainsRegex("mesh.far_size [^\n]*stated in the case"));
  EXPECT_THAT(describeJson(description), HasSubstr("\"mesh preset paper\""));
}

}  // namespace
}  // namespace squat::cases
