#include "records/FaultList.h"

#include <algorithm>
#include <utility>

namespace squat::records {

std::size_t FaultList::add(RecordFault fault) {
  auto& kind = kinds_[static_cast<std::size_t>(fault.kind)];
  if (kind.count > 0) {
    auto& last = list_[kind.last];
    if (fault.end > fault.first && last.end == fault.first && last.channel == fault.channel && last.end > last.first) {
      last.end = fault.end;
      return kind.last;
    }
    if (kind.count >= maximumOfAKind) {
      last.end = std::max(last.end, fault.end);
      last.channel = last.channel == fault.channel ? last.channel : -1;
      last.text = kind.text + "; " + std::to_string(++kind.more) + " more of this kind up to here are not listed";
      return kind.last;
    }
  }
  ++kind.count;
  kind.last = list_.size();
  kind.text = fault.text;
  list_.push_back(std::move(fault));
  return kind.last;
}

}  // namespace squat::records
