// solver/statements/Sensitivity.h - what the statements' numbers do when one input of the model changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statements/Reference.h"
#include "studies/CaseStudy.h"

namespace squat::statements {

struct SensitivityRow {
  std::string key, text, value, unit;          // the input and its value in the unit of the case file
  bool base = false;                           // the value of the run that the statements are judged on
  std::vector<std::optional<double>> numbers;  // one a statement; none where there is nothing to measure
  std::vector<bool> met;
  std::string message;  // why there are no numbers
};

struct SensitivityTable {
  std::vector<Statement> statements;  // those about the run alone
  std::vector<SensitivityRow> rows;
};

// One study a key (folder/KEY, resumed where it stopped), each run judged as the paper's own. `overrides` holds the
// mesh preset. Throws what studies throw; a run that fails is a row with its message.
SensitivityTable sensitivity(const Reference& reference, const cases::CaseOverrides& overrides,
                             const studies::CaseRunner& run, const studies::StudyOptions& options, Monitor& monitor);

std::string sensitivityCsv(const SensitivityTable& table);

}  // namespace squat::statements
