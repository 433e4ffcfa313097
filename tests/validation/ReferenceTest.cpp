#include "validation/Reference.h"

#include <gmock/gmock.h>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::validation {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  writeDurably(folder / "paper.json", text);
  try {
    readReference(folder / "paper.json");
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

std::string with(const std::string& statement) {
  return R"({"schema": "squat-reference", "schema_version": 1, "source": "s", "runs": [{"name": "a", "case": "a",
          "set": []}], "statements": [)" +
         statement + "]}";
}

TEST(Reference, EveryRunOfThePapersStatementsIsACaseThatCanBeRead) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  EXPECT_GE(reference.statements.size(), 20U);
  for (const auto& run : reference.runs)
    for (const char* preset : {"tiny", "draft", "standard", "paper"}) {
      cases::CaseOverrides overrides;
      overrides.preset = preset;
      overrides.values = run.sets;
      EXPECT_NO_THROW(cases::loadCase(run.caseName, overrides)) << run.name << " " << preset;
    }
  for (const auto& statement : reference.statements) EXPECT_FALSE(statement.reason.empty()) << statement.text;
}

TEST(Reference, MistakesAreNamed) {
  EXPECT_THAT(refusal("{"), HasSubstr("paper.json"));
  EXPECT_THAT(refusal(R"({"schema": "other"})"), HasSubstr("no reference"));
  EXPECT_THAT(refusal(R"({"schema": "squat-reference", "schema_version": 2})"), HasSubstr("newer"));
  const std::string head = R"({"section": "1", "statement": "t", "unit": "1", "reason": "r", )";
  EXPECT_EQ(refusal(with(head + R"("run": "a", "measure": "maximum", "low": 1, "high": 2})")), "accepted");
  EXPECT_THAT(refusal(with(head + R"("run": "b", "measure": "maximum", "low": 1, "high": 2})")),
              HasSubstr("statement 1: run 'b' is not listed"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "beauty", "low": 1, "high": 2})")), HasSubstr("'beauty'"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum", "low": 3, "high": 2})")),
              HasSubstr("upside down"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum", "high": 2})")), HasSubstr("low"));
}

}  // namespace
}  // namespace squat::validation
