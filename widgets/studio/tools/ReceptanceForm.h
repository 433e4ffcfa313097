// widgets/studio/tools/ReceptanceForm.h - the track receptance of the open case, and the modes of its wheelset.
#pragma once

#include "studio/tools/ToolForm.h"

namespace squat::studio {

class ReceptanceForm : public ToolForm {
  Q_OBJECT
 public:
  using ToolForm::ToolForm;

  QString name() const override { return QStringLiteral("receptance"); }
  QString title() const override { return tr("Track receptance"); }
  QString explanation() const override;
  QString subject() const override { return tr("The receptance"); }
  QString fate() const override { return tr("Its results so far are discarded."); }
  ToolWork work() override;
};

}  // namespace squat::studio
