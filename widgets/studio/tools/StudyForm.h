// widgets/studio/tools/StudyForm.h - options of a study: which keys take which values.
#pragma once

#include <memory>

#include "studio/tools/StudyRuns.h"
#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace squat::studies {
struct StudyJob;
}

namespace squat::studio {

class KeyRows;
class StudyView;

class StudyForm : public ToolForm {
  Q_OBJECT
 public:
  explicit StudyForm(QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("study"); }
  QString title() const override { return tr("Study"); }
  QString explanation() const override;
  QString subject() const override { return tr("The study"); }
  ToolWork work() override;
  QWidget* view() const override;
  QString viewTitle() const override { return tr("Runs"); }
  void conclude() override;
  void showCase(const cases::CaseDescription& description) override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void showStudy(const StudyPointer& study, const std::shared_ptr<const studies::StudyJob>& job);  // as far as it is

 private:
  void showRuns();  // how many there will be
  void openRun(const studies::StudyPoint& point);

  KeyRows* rows_;
  QComboBox* points_;
  QSpinBox* count_;
  QCheckBox* keep_;
  QLabel* runs_;
  StudyView* view_;
  std::shared_ptr<const studies::StudyJob> shown_;  // null: none
};

}  // namespace squat::studio
