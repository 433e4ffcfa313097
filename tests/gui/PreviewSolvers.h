// tests/gui/PreviewSolvers.h - solvers of previews: the real one, and one without mechanics that counts its calls.
#pragma once

#include <atomic>
#include <memory>

#include "studio/preview/Preview.h"

namespace squat::tests {

studio::PreviewSolver realPreviewSolver();

struct PreviewCalls {
  std::atomic<int> started{0}, made{0}, rolledOn{0}, begun{0}, complete{0}, cancelled{0};
};

// A state takes about `startMilliseconds`, a run about `runMilliseconds`; both obey cancelling. What comes out is the
// made-up result of the tests, for the case that was asked for. A run fails where the case's title is "fails".
studio::PreviewSolver madeUpPreviewSolver(const std::shared_ptr<PreviewCalls>& calls, int startMilliseconds,
                                          int runMilliseconds);

}  // namespace squat::tests
