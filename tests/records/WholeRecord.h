// All blocks of a record put together, for tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/Errors.h"
#include "records/RecordStream.h"

namespace squat::records {

struct WholeRecord {
  RecordLayout layout;
  std::vector<RecordBlock> stretches;  // joined where they follow
  std::vector<RecordFault> faults;

  std::vector<RecordFault> faultsOf(FaultKind kind) const {
    std::vector<RecordFault> list;
    for (const auto& fault : faults)
      if (fault.kind == kind) list.push_back(fault);
    return list;
  }
};

inline void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

inline WholeRecord readWhole(const std::string& path, const RecordOptions& options = {}) {
  WholeRecord whole;
  const auto stream = openRecord(path, options);
  RecordBlock block;
  while (stream->next(block)) {
    if (!block.follows) {
      whole.stretches.push_back(block);
      continue;
    }
    auto& last = whole.stretches.back();
    for (std::size_t c = 0; c < last.values.size(); ++c) append(last.values[c], block.values[c]);
    append(last.position, block.position);
    append(last.speed, block.speed);
    append(last.latitude, block.latitude);
    append(last.longitude, block.longitude);
  }
  whole.layout = stream->layout();  // notes come to the end
  whole.faults = stream->faults();
  return whole;
}

// What is said about a file that cannot be read; empty where it can.
inline std::string complaintAbout(const std::string& path, const RecordOptions& options = {}) {
  try {
    readWhole(path, options);
  } catch (const FileError& error) {
    return error.what();
  } catch (const CaseError& error) {
    return error.what();
  }
  return {};
}

}  // namespace squat::records
