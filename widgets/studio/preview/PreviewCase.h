// widgets/studio/preview/PreviewCase.h - the case that a preview runs for the one that is open.
#pragma once

#include <string>

#include "case/CaseDescription.h"

namespace squat::studio {

// It depends on the open case alone, not on what was previewed before. A case on the mesh `tiny` is run as it stands,
// so that its preview is its run; where its run-up leaves less than 30 mm before the defect, with a longer one. Any
// other is put on that mesh and rolled to some 100 mm behind the defect; the mesh is fine over a stretch that is longer
// than the defect, in steps, so that few changes of a profile need another mesh.
cases::CaseDescription previewCase(const cases::CaseDescription& open);

// Why this case has no preview, in one sentence; empty: it may have one.
std::string whyNoPreview(const cases::CaseDescription& open);

}  // namespace squat::studio
