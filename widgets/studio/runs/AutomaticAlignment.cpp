#include "studio/runs/AutomaticAlignment.h"

#include <cmath>

#include "core/Errors.h"

namespace squat::studio {

void alignWithCurrent(RunStore& store) {
  constexpr double negligible = 0.1e-3;  // [m] a tenth of what a figure shows; the file is read again for more
  const auto current = store.currentResult();
  if (!current) return;
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    if (!run.isMeasured() || run.isMissing() || run.dragged || !run.reading.isAutomatic) continue;
    const auto match = project::matchBeside(*current, *run.record);
    if (std::abs(match.impact - run.reading.impact) < negligible) continue;
    try {
      store.setMeasured(row, project::realigned({run.record, run.reading}, run.reading, current.get()));
    } catch (const FileError&) {
      // Gone, or another file now: the project says so when it is opened again.
    }
  }
}

}  // namespace squat::studio
