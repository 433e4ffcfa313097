#include "calibration/TargetChecks.h"

#include <algorithm>

#include "core/Errors.h"
#include "statements/Judge.h"
#include "statements/Measures.h"

namespace squat::calibration {

namespace {

using statements::Statement;

void checkUnit(const Statement& statement, const std::string& path) {
  const auto unit = statement.against.empty() ? statements::unitOfMeasure(statement.measure) : "ratio";
  const bool isPure = unit == "1" && statement.unit.empty();
  if (statement.unit != unit && !isPure)
    throw FileError(path, "statement '" + statement.name + "'",
                    "unit is '" + statement.unit + "', must be '" + unit + "' for measure '" + statement.measure + "'",
                    "Give the range in this unit");
}

// Whether both are about one number, so that their ranges must overlap.
bool areAboutTheSame(const Statement& a, const Statement& b) {
  return a.run == b.run && a.against == b.against && a.measure == b.measure && a.point == b.point && a.band == b.band &&
         a.near == b.near;
}

void checkPair(const Statement& a, const Statement& b, const std::string& path) {
  if (!areAboutTheSame(a, b) || (a.low <= b.high && b.low <= a.high)) return;
  throw FileError(path, "statements '" + a.name + "' and '" + b.name + "'",
                  "contradict each other: one asks for " + rangeText(a) + ", the other for " + rangeText(b),
                  "Keep one of them");
}

}  // namespace

void checkTargets(const Targets& targets) {
  if (targets.count() == 0)
    throw FileError(
        targets.path, "", "holds no target",
        "List statements, signals, receptance or decay rates; see the page about calibration in the manual");
  for (const auto& signal : targets.signals)
    if (std::none_of(targets.runs.begin(), targets.runs.end(), [&](const auto& run) { return run.name == signal.run; }))
      throw FileError(targets.path, "signals '" + signal.name + "'", "run '" + signal.run + "' is not listed",
                      "Add it to \"runs\", or leave \"run\" out");
  for (const auto& a : targets.runs)
    for (const auto& b : targets.runs)
      if (a.name == b.name && (a.caseName != b.caseName || a.sets != b.sets))
        throw FileError(targets.path, "run '" + a.name + "'", "is given twice with different cases or keys",
                        "Rename one of them");
  const auto& all = targets.statements;
  for (std::size_t i = 0; i < all.size(); ++i) {
    checkUnit(all[i].statement, targets.path);
    for (std::size_t j = 0; j < i; ++j) checkPair(all[j].statement, all[i].statement, targets.path);
  }
}

}  // namespace squat::calibration
