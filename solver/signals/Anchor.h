// solver/signals/Anchor.h - the one point of a record that its features refer to.
#pragma once

#include <string>

namespace squat::signals {

struct Passage;

// One rule for every command: where the record passes position 0, the deepest point of the defect, that is the anchor
// (a computed run, or a measured signal whose positions count from the defect); where it does not, the sample with the
// largest absolute value. The second signal of a comparison has its anchor where it lies beside the first's.
enum class AnchorRule { defect, largestValue, aligned };

struct Anchor {
  double time = 0;  // [s]
  AnchorRule rule = AnchorRule::largestValue;
};

// For a passage without positions (or with other than one a sample) the largest absolute value. The signal must not be
// empty.
Anchor anchorOf(const Passage& passage);

// "defect at position 0", "largest absolute value", "beside the first signal's": for the output of every command.
std::string toText(AnchorRule rule);

}  // namespace squat::signals
