#include "studio/project/StoreReport.h"

namespace squat::studio {
namespace {

project::ReportSignal signalOf(const StoredRun& run) {
  project::ReportSignal signal{project::nameWithGain(run.label.toStdString(), run.reading),
                               run.path.toStdString(),
                               run.record,
                               run.result,
                               run.reading,
                               run.overlaid};
  // The name of a measured signal may be the user's; its file is that of the record.
  if (run.isMeasured()) signal.file = run.record->file;
  if (run.colour.isValid()) signal.colour = run.colour.name().toStdString();
  return signal;
}

}  // namespace

project::Report reportOf(const RunStore& store, const ResultPointer& shown, const QString& title,
                         const QString& notes) {
  project::Report report;
  report.title = title.toStdString(), report.notes = notes.toStdString();
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    const bool current = row == store.current(), reference = row == store.reference();
    if (run.isMissing() || !(current || run.overlaid || reference)) continue;
    const int place = static_cast<int>(report.signals.size());
    report.signals.push_back(signalOf(run));
    if (current) {
      report.shown = place;
      report.signals.back().result = shown, report.signals.back().record = shown;
    }
    if (reference) report.reference = place;
  }
  return report;
}

}  // namespace squat::studio
