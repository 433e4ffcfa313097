// app/commands/Study.h - many runs of one case with keys varied over a grid: the plan, and the table that comes of it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/RunResult.h"

namespace squat::commands {

struct Variation {
  std::string key;
  std::vector<std::string> values;  // in the unit of the case file
};

// "key=a:b:n" (n values from a to b, both included) or "key=v,w,..." (values or names). Throws CaseError for a key that
// does not exist, for what is neither, and for more than 10,000 values.
Variation variationFromText(const std::string& text);

struct StudyRun {
  std::string name;                                       // "001", "002", ...
  std::vector<std::pair<std::string, std::string>> sets;  // key and value
};

// Every combination; the last variation runs fastest. Throws CaseError for more than 10,000 runs or a key given twice.
std::vector<StudyRun> studyRuns(const std::vector<Variation>& variations);

struct StudyOutcome {
  StudyRun run;
  std::string status;  // "done", "failed: ..."
  std::vector<std::pair<std::string, double>> features;
};

// Features of a finished run, those of the signal laboratory and extremes of the contact force. Where the signal cannot
// be judged (no impact, too short) those that can be had.
std::vector<std::pair<std::string, double>> studyFeatures(const results::RunResult& result);

// One row a run: run, varied keys with unit, status, features; fields of failed runs stay empty.
std::string studyCsv(const std::vector<StudyOutcome>& outcomes);

}  // namespace squat::commands
