#include "signals/Anchor.h"

#include <optional>

#include "signals/Alignment.h"
#include "signals/Features.h"

namespace squat::signals {
namespace {

// [s] when position 0 is passed, between the samples before and after it. A position that was made from speed and time
// begins at 0 and says nothing about a defect.
std::optional<double> timeAtZero(const Passage& passage) {
  const auto& x = passage.position;
  if (x.size() != passage.series.values.size()) return std::nullopt;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i - 1] < 0 && x[i] >= 0)) continue;
    const double part = x[i - 1] / (x[i - 1] - x[i]);
    return passage.series.timeAt(i - 1) + passage.series.step * part;
  }
  return std::nullopt;
}

}  // namespace

Anchor anchorOf(const Passage& passage) {
  if (const auto time = timeAtZero(passage)) return {*time, AnchorRule::defect};
  return {passage.series.timeAt(largestSample(passage.series.values)), AnchorRule::largestValue};
}

std::string toText(AnchorRule rule) {
  switch (rule) {
    case AnchorRule::defect:
      return "defect at position 0";
    case AnchorRule::aligned:
      return "beside the first signal's";
    case AnchorRule::largestValue:
      break;
  }
  return "largest absolute value";
}

}  // namespace squat::signals
