// tests/render/SyntheticResult.h - a made-up but plausible run for tests of pictures and windows; no mechanics in it.
#pragma once

#include <memory>

#include "results/RunResult.h"

namespace squat::tests {

// 0.5 m of rolling at 30 m/s over a 50 mm dip: an impact that rings at 300 Hz and 1 kHz, spectra from closed forms, a
// rail, sleepers and a wheel as coarse surfaces with a made-up stress around the contact.
results::RunResult syntheticResult();
// The same as a whole model: what the surface holds has its mirror image at the track centre, y = -0.75 m, with stress
// and contact pressure times `rightStress`. Inner faces are those of the left side alone.
results::RunResult syntheticWhole(double rightStress);
// Without the inner faces of cuts, which the right side of a whole model does not have.
results::RunResult withoutCutFaces(results::RunResult result);
inline std::shared_ptr<const results::RunResult> sharedSyntheticResult() {
  return std::make_shared<const results::RunResult>(syntheticResult());
}

}  // namespace squat::tests
