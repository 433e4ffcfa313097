// solver/validation/Judge.h - the paper's statements beside ours.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"
#include "validation/Reference.h"

namespace squat::validation {

enum class Verdict { met, notMet, notJudged };

struct Judged {
  Statement statement;
  std::optional<double> value;  // in the statement's unit
  Verdict verdict = Verdict::notJudged;
  std::string why;  // where not judged
};

// Every statement on the results by name of run; a run that is not there (failed, cancelled) leaves its statements not
// judged. `mesh` is the preset that the runs were made with.
std::vector<Judged> judge(const Reference& reference, const std::map<std::string, results::RunResult>& results,
                          const std::string& mesh);

std::string toText(Verdict verdict);  // "met", "not met", "not judged"

// section, statement, run, against, value, low, high, unit, verdict, reason
std::string judgedCsv(const std::vector<Judged>& judged);

}  // namespace squat::validation
