// solver/studies/EvaluationFiles.h - one run for another program's loop: the files by which Dakota asks and is
// answered.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studies/StudyTable.h"

namespace squat::studies {

struct EvaluationRequest {
  std::vector<std::pair<std::string, std::string>> values;  // key and text in the unit of the case file
  std::vector<std::string> features;                        // as the asking program calls them; may be empty
};

// Dakota's parameters file, standard ("0.15 defect.depth") or for APREPRO ("{ defect.depth = 0.15 }"). A name in which
// two underscores stand for the point of a key is understood as well, for programs that allow none. Throws FileError
// (line), also where gradients are asked for: there are values only.
EvaluationRequest readRequest(const std::string& path);

// A line "value name" for each of `names`, which are features or their words (analysis::featureWord). Throws CaseError
// that names those which a run does not have, RunError for one that has no value in this run.
std::string answerText(const FeatureRow& features, const std::vector<std::string>& names);

inline constexpr const char* kFailedAnswer = "FAIL\n";  // what Dakota looks for

}  // namespace squat::studies
