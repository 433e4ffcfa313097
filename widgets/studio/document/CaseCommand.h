// widgets/studio/document/CaseCommand.h - one change of the case: the description before and after it.
#pragma once

#include <QUndoCommand>
#include <memory>

#include "case/CaseDescription.h"

namespace squat::studio {

class CaseDocument;

// Whole descriptions are kept (some kilobytes each): no change can be undone wrongly.
class CaseCommand : public QUndoCommand {
 public:
  using State = std::shared_ptr<const cases::CaseDescription>;
  CaseCommand(CaseDocument& document, const QString& what, State before, State after, int gesture);

  void undo() override;
  void redo() override;
  int id() const override { return gesture_ == 0 ? -1 : gesture_; }
  bool mergeWith(const QUndoCommand* later) override;

 private:
  CaseDocument& document_;
  State before_, after_;
  int gesture_;
};

}  // namespace squat::studio
