// widgets/studio/tools/ReceptanceForm.h - the track receptance of the open case and the modes of its wheelset, or its
// decay rates.
#pragma once

#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace squat::studio {

class ReceptanceForm : public ToolForm {
  Q_OBJECT
 public:
  explicit ReceptanceForm(QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("receptance"); }
  QString title() const override { return tr("Track receptance"); }
  QString shortTitle() const override { return tr("Receptance"); }
  QString explanation() const override;
  QString subject() const override { return tr("The receptance"); }
  QString fate() const override { return tr("Its results so far are discarded."); }
  ToolWork work() override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 private:
  void chooseMeasured();

  QComboBox* quantity_;  // and the decay rates at its end
  QCheckBox *lateral_, *oneRail_, *endless_;
  QLineEdit* measured_;  // decay rates to stand beside the computed ones
};

}  // namespace squat::studio
