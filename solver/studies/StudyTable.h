// solver/studies/StudyTable.h - the one table of a study: a row for each run that has ended.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/Partition.h"
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
  std::optional<Partition> part;  // none: the whole study
  std::vector<StudyRow> rows;     // one for each point of the grid, or of the part, in the grid's order

  std::size_t count(RowState state) const;
};

StudyTable emptyTable(const StudyDefinition& definition, const std::optional<Partition>& part = {});

// FOLDER/study.csv: keys, state, features, message; ended runs only, in the order of the grid. Every feature has its
// column, also where no run has a value for it. The same rows give the same bytes, whatever the order in which they
// ended. FOLDER/study.json says which study it is. A part writes FOLDER/study-slice-3-of-16.csv alone. All durable, and
// under their names whole at every instant; FileError.
void writeTable(const StudyTable& table, const std::string& folder);

// CSV text of the table.
std::string tableText(const StudyTable& table);

// The paths of the table and of the file that says which study it is.
std::vector<std::string> studyFiles(const std::string& folder, const std::optional<Partition>& part = {});

// The ended runs of a table that writeTable() has written, put into the rows of the same `keys` values. FileError for
// one that has no such row (line).
using RowsByValues = std::map<std::vector<std::string>, StudyRow*>;
RowsByValues rowsByValues(StudyTable& table);
void takeRows(const std::string& path, std::size_t keys, const RowsByValues& rows);

// What stands in the folder; nothing where there is no study, or no such part, yet. Throws CaseError where the folder
// holds a study of another case or with other values, or a study.csv of which nothing tells what it is, FileError where
// its files are damaged (line). Of a part, only the table is looked at: claimParts() looks at the rest.
std::optional<StudyTable> readTable(const StudyDefinition& definition, const std::string& folder,
                                    const std::optional<Partition>& part = {});

}  // namespace squat::studies
