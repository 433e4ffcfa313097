// The paper's statements on its shipped cases, as `squat validate` judges them: as many are not met as README and
// manual state, and the runs keep their energy.
#include <gtest/gtest.h>

#include <map>

#include "case/CaseDescription.h"
#include "simulation/RunCase.h"
#include "statements/Judge.h"
#include "statements/RunChecks.h"
#include "verification/Seen.h"

namespace squat::statements {
namespace {

// 0.1 % of the strain energy at the start plus all dissipation, as in tests/simulation/RunCaseTest.cpp.
void judgeOn(const std::string& mesh) {
  const auto paper = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  std::map<std::string, results::RunResult> results;
  for (const auto& run : paper.runs) {
    Monitor quiet;
    const auto& result = results.emplace(run.name, simulation::runCase(run.caseOn(mesh), {}, quiet)).first->second;
    ASSERT_TRUE(result.complete) << run.name;
    const auto error = energyError(result);
    ASSERT_TRUE(error) << run.name << " does not state it";
    EXPECT_LT(*error, 1e-3) << run.name;
  }
  const auto judged = judge(paper, results, mesh);
  const int notMet = countOf(judged, Verdict::notMet);
  EXPECT_EQ(countOf(judged, Verdict::met) + notMet, 20);
  verification::seen("statements on " + mesh, notMet, "not met");
  for (const auto& one : judged)
    if (one.verdict == Verdict::notMet)
      std::printf("not met: %s: %g %s\n", one.statement.name.c_str(), one.value.value_or(0),
                  one.statement.unit.c_str());
}

TEST(PaperStatements, Tiny) { judgeOn("tiny"); }

TEST(PaperStatements, Draft) { judgeOn("draft"); }

}  // namespace
}  // namespace squat::statements
