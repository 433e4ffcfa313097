// solver/project/LinkedRun.h - the result or measured signal that an entry of a project links to.
#pragma once

#include <memory>
#include <string>

#include "project/MeasuredRecords.h"
#include "project/Project.h"
#include "results/ResultFile.h"

namespace squat::project {

struct LinkedRun {
  std::shared_ptr<const results::RunResult> result;  // null: missing, `problem` says why
  std::string problem;                               // also: the file holds another result than it did; empty: neither
};

// Throws nothing: what cannot be read is missing.
LinkedRun openRun(const Entry& entry, results::ResultContent content = results::ResultContent::everything);

struct LinkedSignal {
  MeasuredRecord measured;  // its record null: missing, `problem` says why
  std::string problem;      // as above
};

// Throws nothing.
LinkedSignal openSignal(const Entry& entry);

// As of a file (FileDigest.h): by all values of the record.
std::string changeOf(const Entry& entry, const signals::Record& record);

}  // namespace squat::project
