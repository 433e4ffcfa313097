#include "studio/preview/PreviewStart.h"

#include <algorithm>
#include <cmath>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "studio/preview/PreviewCase.h"

namespace squat::studio {
namespace {

constexpr double nearStep = 0.005;  // [m]: a slider that lengthens the defect needs another state now and then only
constexpr double roundOff = 1e-9;

// Where the defect begins, in steps [m].
double beforeOf(const cases::CaseDescription& description) {
  const double own = -cases::surfaceOf(description).first();
  return nearStep * std::ceil(own / nearStep - roundOff);
}

}  // namespace

cases::CaseDescription PreviewStart::caseOf(const cases::CaseDescription& open) const {
  if (first_) {
    const auto& mesh = first_->description.mesh;
    auto description = previewCase(open, {mesh.zoneBefore, mesh.zoneBehind});
    if (simulation::fits(*first_, description)) return description;
  }
  return previewCase(open);
}

bool PreviewStart::serves(const cases::CaseDescription& description) const {
  return first_ && simulation::fits(*first_, description);
}

bool PreviewStart::isNearFor(double before) const { return near_ && before <= nearBefore_ + roundOff; }

std::shared_ptr<const simulation::WarmState> PreviewStart::stateFor(const cases::CaseDescription& description,
                                                                    Monitor& monitor) {
  if (!serves(description)) {
    forget();
    auto made = solver_.makeStart(description, options_, monitor);
    if (!made) return nullptr;
    first_ = std::make_shared<const simulation::WarmState>(*std::move(made));
  }
  const double before = beforeOf(description);
  if (before + nearStep > description.mesh.zoneBefore) return first_;
  if (isNearFor(before)) return near_;
  near_.reset();
  try {
    auto made = solver_.rollOn(first_, description, before, options_, monitor);
    if (!made) return nullptr;
    near_ = std::make_shared<const simulation::WarmState>(*std::move(made));
    nearBefore_ = before;
  } catch (const RunError&) {  // a profile that rises so high that the wheel touches it earlier
    return first_;
  }
  return near_;
}

}  // namespace squat::studio
