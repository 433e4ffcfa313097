// widgets/studio/ShownCase.h - whether the result that is shown was computed from the case that is open.
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "case/CaseDescription.h"
#include "results/RunResult.h"

namespace squat::studio {

class ShownCase {
 public:
  // "motion.speed, defect.depth and 3 more differ"; empty where all that counts is the same, or there is no result.
  QString difference(const std::shared_ptr<const results::RunResult>& result, const cases::CaseDescription& open);

 private:
  std::weak_ptr<const results::RunResult> of_;
  std::optional<cases::CaseDescription> case_;  // of that result, read once
};

}  // namespace squat::studio
