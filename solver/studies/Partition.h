// solver/studies/Partition.h - a share of a command's work (points of a study, records, passages), for one of several
// processes.
#pragma once

#include <cstddef>
#include <string>

#include "studies/StudyGrid.h"

namespace squat::studies {

// slice: every n-th point, so that shares differ by one point at most. hash: by the point's keys and values alone, so
// that a point keeps its part when others are added to the study.
struct Partition {
  enum class Kind { slice, hash };
  Kind kind = Kind::slice;
  std::size_t part = 1, parts = 1;  // 1 <= part <= parts

  bool operator==(const Partition&) const = default;
};

inline constexpr std::size_t kMaximumParts = 10000;

// "slice:3/16" or "hash:3/16". Throws CaseError.
Partition partitionFromText(const std::string& text);
std::string toText(const Partition& partition);

// The kind and the number of parts, which all parts of a study have in common: "slice:16".
std::string familyOf(const Partition& partition);
Partition familyFromText(const std::string& text);  // its first part; throws CaseError

// Name of the part's files without ending: "study-slice-3-of-16".
std::string stemOf(const Partition& partition, const std::string& command = "study");

// The same for an item of any list; `name` is what stays the same when others are added to the list.
std::size_t partOf(const Partition& family, std::size_t index, const std::string& name);

// The part that computes a point, of a family.
std::size_t partOf(const Partition& family, const StudyDefinition& definition, const StudyPoint& point);
bool isInPart(const Partition& partition, const StudyDefinition& definition, const StudyPoint& point);

}  // namespace squat::studies
