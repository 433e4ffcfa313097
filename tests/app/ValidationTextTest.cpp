// What `squat validate` prints fits a terminal of 100 columns, whatever the results.
#include "case/CaseDescription.h"
#include "commands/ValidationText.h"

#include <gmock/gmock.h>

#include <sstream>

#include "case/CaseFile.h"

namespace squat::commands {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kColumns = 100;

statements::Reference paperReference() {
  return statements::readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
}

// Lines that are longer, counted in signs.
std::string tooLong(const std::string& text) {
  std::string found, line;
  for (std::istringstream stream(text); std::getline(stream, line);) {
    std::size_t signs = 0;
    for (const char c : line) signs += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
    if (signs > kColumns) found += line + "\n";
  }
  return found;
}

// Judged with every verdict in turn; the longest reasons among them.
std::vector<statements::Judged> judgedOf(const statements::Reference& reference) {
  std::vector<statements::Judged> judged;
  for (const auto& statement : reference.statements) {
    statements::Judged one{statement, {}, statements::Verdict::notJudged, statement.reason, {}};
    if (judged.size() % 3 != 0) one.value = -12345.678, one.verdict = statements::Verdict::notMet;
    judged.push_back(one);
  }
  return judged;
}

TEST(ValidationText, StatementsFit) {
  const auto text = statementsText(judgedOf(paperReference()));
  EXPECT_EQ(tooLong(text), "");
  EXPECT_THAT(text, HasSubstr("not judged"));
}

TEST(ValidationText, ParametersAndNumbersFit) {
  const auto reference = paperReference();
  results::RunResult result;  // on tiny, where mesh, run-up and length are not the paper's
  results::setCase(result, cases::loadCase("light-defect", {"tiny", {}}));
  const auto text = parametersText(statements::compareParameters(reference, result));
  EXPECT_EQ(tooLong(text), "");
  EXPECT_THAT(text, HasSubstr("mesh.contact_size"));
  EXPECT_EQ(tooLong(numbersText(reference)), "");
}

TEST(ValidationText, SensitivityFitsWithOneTableForEachInput) {
  const auto reference = paperReference();
  statements::SensitivityTable table;
  for (const auto& statement : reference.statements)
    if (statement.run == reference.sensitivityRun && statement.against.empty()) table.statements.push_back(statement);
  for (const auto& key : reference.sensitivity)
    for (const auto& value : key.values) {
      statements::SensitivityRow row{key.key, key.text, value, "MN/m", value == "1", {}, {}, {}};
      row.numbers.assign(table.statements.size(), -12345.678);
      row.met.assign(table.statements.size(), false);
      if (value == "0.67") row.message = "not run", row.numbers.clear(), row.met.clear();
      table.rows.push_back(row);
    }
  const auto text = sensitivityText(table);
  EXPECT_EQ(tooLong(text), "");
  for (const auto& key : reference.sensitivity) EXPECT_THAT(text, HasSubstr(key.text + " (" + key.key + ")"));
}

}  // namespace
}  // namespace squat::commands
