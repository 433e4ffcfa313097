// widgets/studio/tools/StudyForm.h - options of a study: which keys take which values.
#pragma once

#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace squat::studio {

class KeyRows;

class StudyForm : public ToolForm {
  Q_OBJECT
 public:
  explicit StudyForm(QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("study"); }
  QString title() const override { return tr("Study"); }
  QString explanation() const override;
  QString subject() const override { return tr("The study"); }
  ToolWork work() override;
  void showCase(const cases::CaseDescription& description) override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 private:
  void showRuns();  // how many there will be

  KeyRows* rows_;
  QComboBox* points_;
  QSpinBox* count_;
  QCheckBox* keep_;
  QLabel* runs_;
};

}  // namespace squat::studio
