// One judge for the table of a run and for `squat validate`: the same result has the same numbers, ranges and verdicts.
#include <gmock/gmock.h>

#include <algorithm>

#include "app/MadeUpPaperRun.h"
#include "commands/PaperTable.h"
#include "commands/ValidationText.h"
#include "statements/Judge.h"
#include "statements/RunChecks.h"

namespace squat::commands {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const statements::Reference& paper() {
  static const auto reference = statements::readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  return reference;
}

class PaperVerdicts : public ::testing::TestWithParam<const char*> {
 protected:
  results::RunResult result_ = tests::madeUpPaperRun(GetParam(), {{45, 240}, {30, 620}, {35, 1075}});
};

TEST_P(PaperVerdicts, AreThoseOfTheJudgeValueByValue) {
  const auto rows = paperRows(result_);
  int judgedRows = 0;
  for (const auto& one : statements::judge(paper(), {{GetParam(), result_}}, "tiny")) {
    const auto& statement = one.statement;
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const PaperRow& each) { return each.what == statement.name; });
    const bool isOwn = statement.run == GetParam() && statement.against.empty();
    ASSERT_EQ(row != rows.end(), isOwn) << statement.name;
    if (!isOwn) continue;
    ++judgedRows;
    EXPECT_EQ(row->ours, valueText(one)) << statement.name;
    EXPECT_EQ(row->paper, statements::rangeText(statement)) << statement.name;
    EXPECT_EQ(row->verdict, statements::toText(one.verdict)) << statement.name;
  }
  // No other row has a verdict of the paper.
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(),
                          [](const PaperRow& row) {
                            return row.verdict == "met" || row.verdict == "not met" || row.verdict == "not judged";
                          }),
            judgedRows);
  EXPECT_GT(judgedRows, 0);
}

TEST_P(PaperVerdicts, WhatHasNoNumberSaysWhyBelowTheTable) {
  const auto judged = statements::judgeAlone(paper(), GetParam(), result_, "tiny");
  EXPECT_THAT(paperTable(result_), HasSubstr(reasonsText(judged)));
  for (const auto& one : judged) {
    if (one.value) continue;
    EXPECT_THAT(reasonsText(judged), HasSubstr(one.statement.name + ": "));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, PaperVerdicts,
                         ::testing::Values("light-defect", "class-c-squat", "class-c-squat-modified", "smooth-rail"));

// The statement about the smooth rail and the row that every run has are one number with one limit.
TEST(ResidualVibration, IsOneNumberWithOneLimit) {
  auto result = tests::madeUpPaperRun("smooth-rail", {{40, 300}});
  result.signals[0].values[166] = 7;  // at x = -0.1 m
  PaperRow statement, check;
  for (const auto& row : paperRows(result)) {
    if (row.what == "smooth rail: residual vibration") statement = row;
    if (row.what.rfind("residual vibration before", 0) == 0) check = row;
  }
  EXPECT_THAT(check.ours, StartsWith("6.95"));  // 7 less the mean of 167 samples, 7/167 = 0.04
  EXPECT_EQ(check.ours, statement.ours);
  EXPECT_EQ(statement.verdict, "not met");
  EXPECT_EQ(check.verdict, "failed");
  EXPECT_EQ(statement.paper, "at most 5 m/s²");
  EXPECT_EQ(check.paper, "limit 5 m/s²");
}

}  // namespace
}  // namespace squat::commands
