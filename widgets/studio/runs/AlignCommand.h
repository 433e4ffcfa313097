// widgets/studio/runs/AlignCommand.h - a measured signal that was laid otherwise by hand: one step to undo.
#pragma once

#include <QUndoCommand>

#include "studio/runs/RunStore.h"

namespace squat::studio {

// True where both lie alike: position, speed, gain, and whether the run that is shown decides.
bool isSameAlignment(const project::MeasuredReading& one, const project::MeasuredReading& other);

// What a step changes, of a reading that may have changed since the step: the rest stays.
project::MeasuredReading alignmentStep(const project::MeasuredReading& now, const project::MeasuredReading& from,
                                       const project::MeasuredReading& to);

// Acts on the signal wherever it stands, and on nothing once it is not in the list. One that has followed another run
// since, or was read from another column, is read from its file again, and stays as it is where that cannot be read.
class AlignCommand : public QUndoCommand {
 public:
  AlignCommand(RunStore& store, int row, project::MeasuredRecord before);  // as it lies now, and before

  void undo() override { step(after_, before_); }
  void redo() override { step(before_, after_); }

 private:
  void step(const project::MeasuredRecord& from, const project::MeasuredRecord& to);

  RunStore& store_;
  std::size_t signal_;
  project::MeasuredRecord before_, after_;
};

}  // namespace squat::studio
