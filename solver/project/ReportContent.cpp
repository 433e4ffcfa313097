#include "project/ReportContent.h"

#include <algorithm>

#include "analysis/FeatureTable.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "project/ReportParts.h"

namespace squat::project {

const cases::CaseDescription* descriptionOf(const ReportSignal& signal) {
  return signal.result && signal.result->resolvedCase ? &signal.result->resolvedCase->description : nullptr;
}

std::string meshOf(const ReportSignal& signal) {
  const auto* description = descriptionOf(signal);
  return description ? cases::valueText(*description, *cases::findParameter("mesh.preset")) : std::string();
}

std::vector<results::Scalar> featuresOf(const results::RunResult& run) {
  return run.features.empty() ? analysis::featureScalars(run) : run.features;
}

std::vector<SignalNumbers> reportNumbers(const Report& report, std::vector<std::string>& problems) {
  const auto whole = [](const ReportSignal& signal) {
    return signal.result ? *signal.record : wholeRecord({signal.record, signal.reading});
  };
  const bool compares = report.reference >= 0 && report.signals.size() > 1;
  std::vector<SignalNumbers> numbers(report.signals.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) try {
      const signals::Record record = whole(report.signals[i]);
      numbers[i].features = analysis::comparedFeatures(record);
      if (compares)
        numbers[i].likeness =
            analysis::likenessNumbers(record, whole(report.signals[static_cast<std::size_t>(report.reference)]));
    } catch (const std::exception& error) {
      problems.push_back(report.signals[i].name + ": " + error.what());
    }
  return numbers;
}

ReportContent reportContent(const Report& report, std::vector<std::string>& problems) {
  const auto numbers = reportNumbers(report, problems);
  ReportContent content;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    content.sentences.push_back(signalSentence(report.signals[i], numbers[i]));
  if (auto sentence = eventSentence(report); !sentence.empty()) content.sentences.push_back(std::move(sentence));
  content.body = summaryTables(report, numbers);
  if (auto inputs = changedInputs(report); !inputs.rows.empty()) content.body.push_back(std::move(inputs));
  content.squatList = squatList(report);
  content.squats = squatPages(report);
  content.appendix = appendixTables(report);
  return content;
}

}  // namespace squat::project
