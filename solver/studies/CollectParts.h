// solver/studies/CollectParts.h - the parts of a study put together.
#pragma once

#include <string>
#include <vector>

#include "studies/StudyTable.h"

namespace squat::studies {

struct PartState {
  Partition part;
  bool hasStarted = false;
  std::size_t done = 0, failed = 0;
  std::vector<std::size_t> open;  // rows of the whole table

  bool isComplete() const { return open.empty(); }
};

struct CollectedStudy {
  StudyTable table;  // whole; rows of which no part knows the outcome are open
  std::vector<PartState> parts;

  std::size_t missing() const { return table.count(RowState::open); }
};

// Reads the tables of all parts; writes nothing. May be called while parts are computed. CaseError where the folder
// holds parts of another study or version, FileError where no part has started there or a table is damaged.
CollectedStudy collectParts(const StudyDefinition& definition, const std::string& folder);

// The same, written as study.csv and study.json: the bytes of a study by one process. FileError that names the missing
// points by part, with nothing written, where the study is not complete.
StudyTable writeCollected(const StudyDefinition& definition, const std::string& folder);

}  // namespace squat::studies
