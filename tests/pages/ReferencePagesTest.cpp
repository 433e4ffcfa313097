// The two pages of the manual that are made from the program: nothing of the tables is missing in them.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "case/MeshPresets.h"
#include "case/ParameterTable.h"
#include "pages/CommandPage.h"
#include "pages/Markdown.h"
#include "pages/ParameterPage.h"
#include "pages/Program.h"

namespace squat::pages {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> rowsBeginning(const std::string& page, const std::string& beginning) {
  std::vector<std::string> rows;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(beginning)) rows.push_back(line);
  return rows;
}

TEST(ParameterPage, HasARowForEachKey) {
  const auto page = parameterPage();
  for (const auto& parameter : cases::parameterTable()) {
    const auto rows = rowsBeginning(page, "| `" + parameter.key + "` | ");
    const bool ofAMesh = std::any_of(cases::presetTable().begin(), cases::presetTable().end(),
                                     [&](const auto& row) { return row.key == parameter.key; });
    ASSERT_EQ(rows.size(), ofAMesh ? 2U : 1U) << parameter.key;
    EXPECT_THAT(rows[0], HasSubstr(plainText(parameter.doc)));
    EXPECT_THAT(rows[0], HasSubstr(plainText(parameter.source)));
    EXPECT_THAT(rows[0], HasSubstr(parameter.unit == "-" ? "" : parameter.unit));
    EXPECT_THAT(page,
                HasSubstr(parameter.group == "case" ? "\n## Above all tables\n" : "\n## " + parameter.group + "\n"));
  }
  // Values typed by hand from the table: default, range and source of one number, the names of one choice.
  EXPECT_THAT(page,
              HasSubstr("| `rail.young_modulus` | 210 GPa | 10 to 2000 GPa | Young's modulus of the rail | paper, "
                        "Table 1 |\n"));
  EXPECT_THAT(page, HasSubstr("| `track.rail_ends` | `free` | one of free, clamped, absorbing | "));
  EXPECT_THAT(page, HasSubstr("| `mesh.contact_size` | 5 mm | 2.6 mm | 1.3 mm | 1.3 mm |\n"));
}

TEST(CommandPage, HasEveryCommandAndOption) {
  const auto calls = callsOf(SQUAT_PROGRAM);
  const auto page = commandPage(calls);
  for (const auto& [call, help] : calls) {
    EXPECT_EQ(rowsBeginning(page, "## " + call).empty(), false) << call;
    EXPECT_THAT(page, HasSubstr("\n    " + call + " " + argumentsOf(help) + "\n"));
    for (const auto& entry : help.of("Options")) {
      std::string names;
      for (const auto& name : entry.names) names += (names.empty() ? "" : ", ") + ("`" + name + "`");
      const auto rows = rowsBeginning(page, "| " + names + " ");
      ASSERT_FALSE(rows.empty()) << call << " " << names;
      const bool said = std::any_of(rows.begin(), rows.end(), [&](const std::string& row) {
        return row.find(plainText(entry.text)) != std::string::npos;
      });
      EXPECT_TRUE(said) << call << " " << names;
    }
  }
  EXPECT_THAT(page, HasSubstr("| [`squat run`](#squat-run) | "));
  EXPECT_THAT(page, HasSubstr("Exit codes: 0 success, 2 invalid case or call, 3 run failed, 4 invalid file"));
}

// By hand, after the Markdown that GitHub reads.
TEST(Markdown, KeepsTextPlain) {
  EXPECT_EQ(plainText("a|b <x2> [[seats]] 2*3"), "a\\|b \\<x2\\> \\[\\[seats\\]\\] 2\\*3");
  EXPECT_EQ(codeText("a_b"), "`a_b`");
  EXPECT_EQ(tableHead({"a", "b"}), "| a | b |\n|---|---|\n");
}

}  // namespace
}  // namespace squat::pages
