// solver/project/ReportParts.h - the parts that reportContent() puts together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/ComparisonTable.h"
#include "project/ReportContent.h"

namespace squat::project {

// The numbers that the sentence and the column of a signal share.
struct SignalNumbers {
  std::optional<signals::Features> features;  // none: they cannot be computed
  analysis::NamedNumbers likeness;            // to the reference; empty: the same, or nothing is compared
};

// Of each signal; of a measured one the whole file counts, of which a piece is drawn.
std::vector<SignalNumbers> reportNumbers(const Report& report, std::vector<std::string>& problems);

// "Light defect, 30 m/s, mesh draft: axle box acceleration from -100 to 110 m/s²; strongest lines at 300, 1090 and
// 550 Hz; wavelength behind the defect 26 mm."
std::string signalSentence(const ReportSignal& signal, const SignalNumbers& numbers);
// "Long records: 2 squats (1 moderate, 1 severe) and 5 other events."; empty: no search was made.
std::string eventSentence(const Report& report);

std::vector<ReportTable> summaryTables(const Report& report, const std::vector<SignalNumbers>& numbers);
// Keys that have one value in all runs, and not the default.
ReportTable changedInputs(const Report& report);
std::vector<ReportTable> appendixTables(const Report& report);

ReportTable squatList(const Report& report);
std::vector<ReportSquat> squatPages(const Report& report);
ReportTable otherEvents(const Report& report);

// The value of mesh.preset; empty where no case is known.
std::string meshOf(const ReportSignal& signal);
std::vector<results::Scalar> featuresOf(const results::RunResult& run);   // those of its file, else computed
const cases::CaseDescription* descriptionOf(const ReportSignal& signal);  // null: not known

}  // namespace squat::project
