#include "studio/runs/AlignCommand.h"

#include <QObject>
#include <exception>

namespace squat::studio {

bool isSameAlignment(const project::MeasuredReading& one, const project::MeasuredReading& other) {
  return one.impact == other.impact && one.gain == other.gain && one.isAutomatic == other.isAutomatic &&
         one.options.speed == other.options.speed;
}

project::MeasuredReading alignmentStep(const project::MeasuredReading& now, const project::MeasuredReading& from,
                                       const project::MeasuredReading& to) {
  auto wanted = now;
  const bool follows = from.isAutomatic && to.isAutomatic;  // its position is that of the run that is shown now
  if (now.isAutomatic == from.isAutomatic && !follows) wanted.isAutomatic = to.isAutomatic, wanted.impact = to.impact;
  if (now.gain == from.gain) wanted.gain = to.gain;
  if (now.options.speed == from.options.speed) wanted.options.speed = to.options.speed;
  return wanted;
}

AlignCommand::AlignCommand(RunStore& store, int row, project::MeasuredRecord before)
    : QUndoCommand(QObject::tr("alignment of “%1”").arg(QString(store.at(row).label).replace('&', "&&"))),
      store_(store),
      signal_(store.signalNumber(row)),
      before_(std::move(before)),
      after_{store.at(row).record, store.at(row).reading} {}

void AlignCommand::step(const project::MeasuredRecord& from, const project::MeasuredRecord& to) {
  const int row = store_.rowOfSignal(signal_);
  if (row < 0 || store_.at(row).isMissing()) return;
  const project::MeasuredRecord now{store_.at(row).record, store_.at(row).reading};
  if (now.record == to.record) return;
  if (now.record == from.record) return store_.setMeasured(row, to);
  const auto wanted = alignmentStep(now.reading, from.reading, to.reading);
  if (isSameAlignment(wanted, now.reading)) return;
  try {
    const auto current = store_.currentResult();
    store_.setMeasured(row, project::realigned(now, wanted, wanted.isAutomatic ? current.get() : nullptr));
  } catch (const std::exception&) {
    setObsolete(true);  // the file is gone: there is no way back
  }
}

}  // namespace squat::studio
