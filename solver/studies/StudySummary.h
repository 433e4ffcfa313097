// solver/studies/StudySummary.h - a study's table as text: the keys and a few of the features.
#pragma once

#include <span>
#include <string>

#include "studies/StudyTable.h"

namespace squat::studies {

// A feature of the summary.
struct SummaryFeature {
  const char *name, *head;  // in the table; of its column, with the unit
  double factor;            // to that unit
};
// A hundred columns of text hold these beside two keys.
std::span<const SummaryFeature> summaryFeatures();
// In the unit of the head; NaN where the run has none.
double valueOf(const StudyRow& row, const SummaryFeature& feature);

// One row a run that has ended, at most 40 of them; the anchor of the features in the line above. Empty where no run
// has ended.
std::string studySummary(const StudyTable& table);

}  // namespace squat::studies
