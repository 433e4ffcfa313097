// widgets/studio/records/LabelCommand.h - one change of the label of an event.
#pragma once

#include <QUndoCommand>

#include "studio/records/EventModel.h"

namespace squat::studio {

// Labels are places among EventModel::labels().
class LabelCommand : public QUndoCommand {
 public:
  LabelCommand(EventModel& model, EventPointer event, int before, int after);

  void undo() override;
  void redo() override;

 private:
  EventModel& model_;
  EventPointer event_;
  int before_, after_;
};

}  // namespace squat::studio
