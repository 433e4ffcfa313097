// solver/statements/JudgeRun.h - one run beside the paper, by the judge of all of them.
#pragma once

#include <optional>
#include <vector>

#include "statements/Judge.h"
#include "statements/PaperCase.h"

namespace squat::statements {

struct RunJudgement {
  std::optional<PaperCase> nearest;  // the paper's case that the run is, or nearly is
  std::vector<Judged> judged;        // empty unless it is that case unchanged and the run is complete
};

// The statements about the run of that name which need no other run: numbers, ranges and verdicts are those of judge()
// on the same result.
RunJudgement judgeRun(const Reference& reference, const results::RunResult& result);

// The paper's statements; none where they are not installed.
Reference installedReference();

}  // namespace squat::statements
