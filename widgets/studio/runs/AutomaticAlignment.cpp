#include "studio/runs/AutomaticAlignment.h"

#include <QFileInfo>
#include <cmath>
#include <exception>
#include <optional>

namespace squat::studio {

namespace {

constexpr double negligible = 0.1e-3;       // [m] a tenth of what a figure shows
constexpr qint64 largestFile = 20'000'000;  // [B] the file is read again, in the thread of the window

// None where the file cannot be read any more: the project says so when it is opened again.
std::optional<project::MeasuredRecord> laidBeside(const results::RunResult& current, const StoredRun& run) {
  const auto match = project::matchBeside(current, *run.record);
  if (!match.isAlike() || std::abs(match.impact - run.reading.impact) < negligible) return std::nullopt;
  try {
    return project::realigned({run.record, run.reading}, run.reading, &current);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

void alignWithCurrent(RunStore& store) {
  const auto current = store.currentResult();
  if (!current || !current->complete) return;
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    if (!run.isMeasured() || run.isMissing() || run.dragged || !run.reading.isAutomatic) continue;
    if (QFileInfo(run.path).size() > largestFile) continue;
    if (const auto laid = laidBeside(*current, run)) store.setMeasured(row, *laid);
  }
}

}  // namespace squat::studio
