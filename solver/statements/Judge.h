// solver/statements/Judge.h - the paper's statements beside ours.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"
#include "statements/Reference.h"

namespace squat::statements {

enum class Verdict { met, notMet, notJudged };

struct Judged {
  Statement statement;
  std::optional<double> value;  // in the statement's unit, at the statement's point
  Verdict verdict = Verdict::notJudged;
  std::string why;                  // where not judged, or where there is nothing to judge
  std::optional<double> elsewhere;  // the same measure at the wheel centre, for the reader; it does not count
};

// Every statement on the results by name of run; a run that is not there (failed, cancelled) leaves its statements not
// judged. `mesh` is the preset that the runs were made with. A line of a spectrum serves one statement only: of all
// pairs of a run's statements and lines the nearest (by ratio) go together first, and a line that the window cannot
// part from one that is taken is taken too. A statement that is left without a line is not met.
std::vector<Judged> judge(const Reference& reference, const std::map<std::string, results::RunResult>& results,
                          const std::string& mesh);

// The statements about one run that need no other, as judge() has them.
std::vector<Judged> judgeAlone(const Reference& reference, const std::string& run, const results::RunResult& result,
                               const std::string& mesh);

std::string toText(Verdict verdict);                // "met", "not met", "not judged"
std::string rangeText(const Statement& statement);  // "250 to 400 Hz", "at least 1.05"; empty for "none"
int countOf(const std::vector<Judged>& judged, Verdict verdict);

// A parameter of the paper beside the one that a run was made with; both in the unit of the case file.
struct ComparedParameter {
  PaperParameter parameter;
  std::string ours, unit;
  bool same = false;
};
std::vector<ComparedParameter> compareParameters(const Reference& reference, const results::RunResult& result);

// section, statement, run, against, at, expected, low, high, value, unit, verdict, at the wheel centre, reason
std::string judgedCsv(const std::vector<Judged>& judged);
// section, parameter, key, paper, ours, unit, same
std::string parametersCsv(const std::vector<ComparedParameter>& parameters);

}  // namespace squat::statements
