// The sentences of a report.
#include <algorithm>
#include <array>
#include <cmath>

#include "project/ReportParts.h"
#include "signals/SignalCatalogue.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::project {
namespace {

constexpr std::size_t saidLines = 3;

// Three digits, as a sentence has room for, without an exponent from 1e-4 up: "1090", "26.1".
std::string saidNumber(double value) { return text::formatted(std::abs(value) >= 100 ? "%.0f" : "%.3g", value); }

// "300, 1090 and 550"
std::string listed(const std::vector<std::string>& parts) {
  std::string all;
  for (std::size_t i = 0; i < parts.size(); ++i)
    all += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return all;
}

std::string plainWords(const std::string& name) {
  std::string words = text::lowerCase(name);
  std::replace_if(
      words.begin(), words.end(), [](char letter) { return letter == '-' || letter == '_'; }, ' ');
  return words;
}

// The name in the legend, with the title of its case where that says more: "deep (Light defect)".
std::string saidName(const ReportSignal& signal) {
  const std::string title = signal.result ? signal.result->title : std::string();
  if (title.empty()) return signal.name;
  return plainWords(title) == plainWords(signal.name) ? title : signal.name + " (" + title + ")";
}

std::string accelerationWords(const signals::Features& features) {
  return " from " + saidNumber(features.minimum) + " to " + saidNumber(features.maximum) +
         (features.unit.empty() ? "" : " " + text::printedUnit(features.unit));
}

std::string lineWords(const signals::Features& features) {
  std::vector<std::string> lines;
  for (const auto& line : signals::namedLines(features.spectrum))
    if (lines.size() < saidLines) lines.push_back(text::formatted("%.0f", line.frequency));
  if (lines.empty()) return {};
  return (lines.size() == 1 ? "; strongest line at " : "; strongest lines at ") + listed(lines) + " Hz";
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return (count == 0 ? "no" : std::to_string(count)) + " " + (count == 1 ? one : many);
}

}  // namespace

std::string signalSentence(const ReportSignal& signal, const SignalNumbers& numbers) {
  std::string sentence = saidName(signal) + (signal.result ? "" : ", measured");
  const auto& features = numbers.features;
  const double speed = signal.record->speed > 0 ? signal.record->speed : features ? features->speed : 0;
  if (speed > 0) sentence += ", " + saidNumber(speed) + " m/s";
  if (const auto mesh = meshOf(signal); !mesh.empty()) sentence += ", mesh " + mesh;
  if (signal.result && !signal.result->complete) sentence += ", stopped before its end";
  const std::string box = signals::hasRightSide(*signal.record) ? "left axle box" : "axle box";
  if (!features) return sentence + ": no " + box + " acceleration that can be analysed.";
  sentence += ": " + box + " acceleration" + accelerationWords(*features) + lineWords(*features);
  if (std::isfinite(features->wavelengthByCrossings))
    sentence += "; wavelength behind the defect " + saidNumber(1e3 * features->wavelengthByCrossings) + " mm";
  return sentence + ".";
}

std::string eventSentence(const Report& report) {
  if (report.events.records.empty()) return {};
  std::size_t squats = 0;
  constexpr std::array severities{"light", "moderate", "severe"};
  std::array<std::size_t, severities.size()> counts{};
  for (const auto& event : report.events.events) {
    if (event.kind != "squat") continue;
    ++squats;
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += event.severity == severities[i];
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) parts.push_back(std::to_string(counts[i]) + " " + severities[i]);
  std::string bracket;
  for (const auto& part : parts) bracket += (bracket.empty() ? "" : ", ") + part;
  return "Long records: " + counted(squats, "squat", "squats") + (bracket.empty() ? "" : " (" + bracket + ")") +
         " and " + counted(report.events.events.size() - squats, "other event", "other events") + ".";
}

}  // namespace squat::project
