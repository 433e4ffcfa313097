// widgets/studio/common/ErrorText.h - what failed, in one sentence for the window.
#pragma once

#include <QString>
#include <exception>
#include <vector>

#include "core/Errors.h"

namespace squat::studio {

struct ErrorText {
  QString sentence, details;          // details for those who ask
  std::vector<CaseProblem> problems;  // of the case, where it is that
};

// `what` has failed: "The run", "The study".
ErrorText errorText(const std::exception_ptr& error, const QString& what);

}  // namespace squat::studio
