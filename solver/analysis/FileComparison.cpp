#include "analysis/FileComparison.h"

#include <filesystem>

#include "core/Errors.h"
#include "signals/Butterworth.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"

namespace squat::analysis {
namespace {

signals::Passage passageIn(const signals::Record& signal) {
  try {
    if (signal.signals.size() > 1 && !signal.position.empty() && signal.channel(signals::names::axleBox))
      return signals::passageOf(signal, signals::names::axleBox);
    return readers::passageWithPositions(signal);
  } catch (const signals::SignalError& error) {
    throw FileError(signal.file, signal.run, error.what());
  }
}

}  // namespace

signals::Passage comparedPassage(const signals::Record& signal, double lowPass, std::vector<std::string>& notes) {
  auto passage = passageIn(signal);
  passage.series.name = std::filesystem::path(signal.file).stem().string() + ": " + signal.run;
  for (const auto& note : signal.notes) notes.push_back(passage.series.name + ": " + note);
  try {
    if (lowPass > 0 && lowPass < 0.49 * passage.series.rate())
      passage.series = signals::lowPass(passage.series, lowPass);
    else if (lowPass > 0)
      notes.push_back(passage.series.name + ": not low-pass filtered: the sampling rate is too low");
  } catch (const signals::SignalError& error) {
    throw FileError(signal.file, signal.run, error.what());
  }
  return passage;
}

std::vector<FileComparison> compareFiles(const std::string& first, const std::vector<std::string>& others,
                                         const FileComparisonOptions& options, Monitor& monitor) {
  if (others.empty()) throw CaseError({{"MEASURED", "none", "at least one file", "Name the signals to compare with"}});
  const auto firsts = readers::readSignals(first, options.first);
  if (firsts.size() != 1)
    throw CaseError({{"--result-column", "a choice of " + std::to_string(firsts.size()) + " signals in " + first,
                      "one signal", "Name the column of the reference signal"}});
  std::vector<std::string> firstNotes;
  const auto reference = comparedPassage(firsts[0], options.lowPass, firstNotes);
  auto comparison = options.comparison;
  if (options.smooth) {
    comparison.align = false;
    comparison.inPosition = true;
  }
  std::vector<FileComparison> result;
  for (const auto& file : others)
    for (const auto& signal : readers::readSignals(file, options.second)) {
      if (monitor.cancelled()) return result;
      Progress progress;
      progress.phase = "comparing with " + std::filesystem::path(file).filename().string();
      monitor.report(progress);
      FileComparison entry{first, file, {}, firstNotes};
      const auto passage = comparedPassage(signal, options.lowPass, entry.notes);
      try {
        entry.comparison = signals::compare(reference, passage, comparison);
      } catch (const signals::SignalError& error) {
        throw FileError(file, signal.run, error.what());
      }
      result.push_back(std::move(entry));
    }
  return result;
}

}  // namespace squat::analysis
