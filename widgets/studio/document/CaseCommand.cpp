#include "studio/document/CaseCommand.h"

#include "studio/document/CaseDocument.h"

namespace squat::studio {

CaseCommand::CaseCommand(CaseDocument& document, const QString& what, State before, State after, int gesture)
    : QUndoCommand(what),
      document_(document),
      before_(std::move(before)),
      after_(std::move(after)),
      gesture_(gesture) {}

void CaseCommand::undo() { document_.become(before_); }

void CaseCommand::redo() { document_.become(after_); }

bool CaseCommand::mergeWith(const QUndoCommand* later) {
  after_ = static_cast<const CaseCommand*>(later)->after_;
  return true;
}

}  // namespace squat::studio
