// solver/records/FaultList.h - what is wrong in a record, in the order in which it is found; a bounded list.
#pragma once

#include <array>
#include <vector>

#include "records/RecordStream.h"

namespace squat::records {

class FaultList {
 public:
  static constexpr std::size_t maximumOfAKind = 1000;

  // A fault that begins where the last one of its kind and channel ends continues it. Beyond `maximumOfAKind` the last
  // one grows and counts, so that a broken record takes no more memory than a good one. Returns its index.
  std::size_t add(RecordFault fault);
  void extend(std::size_t index, std::size_t end) { list_[index].end = end; }
  const std::vector<RecordFault>& list() const { return list_; }

 private:
  static constexpr std::size_t kinds = static_cast<std::size_t>(FaultKind::unit) + 1;
  struct OfAKind {
    std::size_t count = 0, last = 0, more = 0;
    std::string text;  // of the last, without what is counted behind it
  };
  std::vector<RecordFault> list_;
  std::array<OfAKind, kinds> kinds_;
};

}  // namespace squat::records
