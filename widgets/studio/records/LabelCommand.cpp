#include "studio/records/LabelCommand.h"

#include <QObject>

namespace squat::studio {

LabelCommand::LabelCommand(EventModel& model, EventPointer event, int before, int after)
    : model_(model), event_(std::move(event)), before_(before), after_(after) {
  setText(QObject::tr("label of event at %1 m").arg(event_->event.position, 0, 'f', 2));  // as the list shows it
}

void LabelCommand::undo() { model_.become(event_, before_); }

void LabelCommand::redo() { model_.become(event_, after_); }

}  // namespace squat::studio
