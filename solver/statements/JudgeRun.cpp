#include "statements/JudgeRun.h"

#include "core/Errors.h"

namespace squat::statements {

RunJudgement judgeRun(const Reference& reference, const results::RunResult& result) {
  RunJudgement run{paperCaseOf(result), {}};
  if (run.nearest && run.nearest->isThePapers() && result.complete)
    run.judged = judgeAlone(reference, run.nearest->name, result, meshPresetOf(result));
  return run;
}

Reference installedReference() {
  try {
    return readReference(paperReferencePath());
  } catch (const FileError&) {
    return {};
  }
}

}  // namespace squat::statements
