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
    for (const char* field : {"key", "value", "unit", "default", "min", "max", "doc", "group", "source",
                              "default_source", "applies", "applies_if"})
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
  EXPECT_THAT(table, testing::ContainsRegex("mesh.rolling_size [^\n]*\\[mesh preset paper; paper, section 2: 5 mm\\]"));
  EXPECT_THAT(table, testing::Not(HasSubstr("mesh preset draft")));
  EXPECT_THAT(
      table, testing::ContainsRegex("mesh.far_size [^\n]*\\[set in the case; default 75 mm: mesh preset paper; paper"));
  EXPECT_THAT(describeJson(description), HasSubstr("\"mesh preset paper; "));
}

// A value that the call sets is neither the paper's nor the case's; what it replaces stays in sight.
TEST(CaseText, ASetValueIsSaidToBeSetHereAndKeepsItsDefault) {
  CaseDescription description = defaultCase();
  setValue(description, "motion.speed", "25");
  setValue(description, "pad.stiffness", "550");
  setValue(description, "track.length", "12");
  const std::string table = describeTable(description, {"motion.speed", "track.length", "contact.friction"});
  EXPECT_THAT(
      table, testing::ContainsRegex("\\* motion.speed +25 m/s [^\n]*\\[set here; default 30 m/s: paper, section 2\\]"));
  EXPECT_THAT(table, testing::ContainsRegex(
                         "pad.stiffness +550 MN/m [^\n]*\\[set in the case; default 1300 MN/m: paper, Table 1\\]"));
  EXPECT_THAT(table,
              testing::ContainsRegex("track.length +12 m [^\n]*\\[set here; default 10 m: mesh preset draft; paper"));
  EXPECT_THAT(table,
              testing::ContainsRegex("contact.friction +0.3 [^\n]*\\[set here; default 0.3: paper, section 2\\]"));
  const auto rows = nlohmann::json::parse(describeJson(description, {"motion.speed"}));
  for (const auto& row : rows)
    if (row["key"] == "motion.speed") {
      EXPECT_EQ(row["source"], "set here; default 30 m/s: paper, section 2");
      EXPECT_EQ(row["default_source"], "paper, section 2");
      EXPECT_EQ(row["default"], 30);
    }
}

// The paper states 1:40 for rail and tread, a bilinear surface layer, a run-up of 1 m, a torque and moved nodes
// (sections 2 and 3); the defaults differ, and their source says so.
TEST(CaseText, ASourceSaysWhereThePaperDiffersFromTheDefault) {
  const std::pair<const char*, const char*> stated[] = {
      {"rail.inclination", "paper, section 2: 0.025"},     {"wheelset.cone", "paper, section 2: 0.025"},
      {"rail.plastic", "paper, section 2: elastoplastic"}, {"motion.run_up", "paper, section 2: 1 m"},
      {"motion.torque", "paper, section 2: 12450.49 N m"}, {"mesh.contact_size", "1.3 mm"}};
  for (const auto& [key, words] : stated) EXPECT_THAT(findParameter(key)->source, HasSubstr(words)) << key;
}

TEST(CaseText, AKeyWithoutEffectIsMarked) {
  CaseDescription description = defaultCase();  // a cosine dip
  EXPECT_THAT(describeTable(description),
              testing::ContainsRegex("defect.ramp [^\n]*applies if defect.shape is cut \\[no effect here"));
  setValue(description, "defect.shape", "cut");
  EXPECT_THAT(describeTable(description), testing::Not(testing::ContainsRegex("defect.ramp [^\n]*no effect here")));
  for (const auto& row : nlohmann::json::parse(describeJson(description))) {
    if (row["key"] == "defect.middle_height") {
      EXPECT_EQ(row["applies_if"], "defect.shape is w-shape");
      EXPECT_EQ(row["applies"], false);
    }
    if (row["key"] == "pad.stiffness") {
      EXPECT_TRUE(row["applies_if"].is_null());
      EXPECT_EQ(row["applies"], true);
    }
  }
}

}  // namespace
}  // namespace squat::cases
