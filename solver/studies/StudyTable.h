// solver/studies/StudyTable.h - the one table of a study: a row for each run that has ended.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/StudyGrid.h"

namespace squat::studies {

using FeatureRow = std::vector<std::pair<std::string, double>>;  // names with unit, values

// Each run of a study ends behind the defect.
inline constexpr const char* kStudyAnchor = "defect at position 0";

enum class RowState { open, done, failed };

struct StudyRow {
  StudyPoint point;
  RowState state = RowState::open;
  FeatureRow features;  // where done
  std::string message;  // where failed: one line
};

struct StudyTable {
  StudyDefinition definition;
  std::vector<StudyRow> rows;  // one for each point of the grid, in its order

  std::size_t count(RowState state) const;
};

StudyTable emptyTable(const StudyDefinition& definition);

// FOLDER/study.csv: keys, state, features, message; ended runs only, in the order of the grid. Every feature has its
// column, also where no run has a value for it. The same rows give the
// same bytes, whatever the order in which they ended. FOLDER/study.json says which study it is. Both durable;
// FileError.
void writeTable(const StudyTable& table, const std::string& folder);

// CSV text of the table.
std::string tableText(const StudyTable& table);

// The paths of both.
std::vector<std::string> studyFiles(const std::string& folder);

// What stands in the folder; nothing where there is no study yet. Throws CaseError where the folder holds a study of
// another case or with other values, or a study.csv of which nothing tells what it is, FileError where its files are
// damaged (line).
std::optional<StudyTable> readTable(const StudyDefinition& definition, const std::string& folder);

}  // namespace squat::studies
