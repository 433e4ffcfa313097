// widgets/studio/tools/CalibrationForm.h - options of a calibration: which keys are unknown, and what is to be met.
#pragma once

#include "studio/tools/ToolForm.h"

class QComboBox;
class QSpinBox;

namespace squat::studio {

class KeyRows;
class RunStore;
class TargetList;

class CalibrationForm : public ToolForm {
  Q_OBJECT
 public:
  explicit CalibrationForm(const RunStore& store, QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("calibration"); }
  QString title() const override { return tr("Calibration"); }
  QString explanation() const override;
  QString subject() const override { return tr("The calibration"); }
  QString missing() const override;
  ToolWork work() override;
  void showCase(const cases::CaseDescription& description) override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  TargetList* targets() const { return targets_; }

 private:
  KeyRows* rows_;
  TargetList* targets_;
  QComboBox *search_, *confirm_;
  QSpinBox* evaluations_;
};

}  // namespace squat::studio
