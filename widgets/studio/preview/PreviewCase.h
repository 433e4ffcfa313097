// widgets/studio/preview/PreviewCase.h - the case that a preview runs for the one that is open.
#pragma once

#include <string>

#include "case/CaseDescription.h"

namespace squat::studio {

// On the mesh `tiny`, rolled to some 100 mm behind the defect. The mesh is fine over a stretch that is longer than the
// defect, in steps, so that few changes of a profile need another mesh, and at least over `served`: the stretch of a
// mesh that is there already.
cases::CaseDescription previewCase(const cases::CaseDescription& open, const cases::DefectZone& served = {});

// Why this case has no preview, in one sentence; empty: it may have one.
std::string whyNoPreview(const cases::CaseDescription& open);

}  // namespace squat::studio
