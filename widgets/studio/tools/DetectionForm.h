// widgets/studio/tools/DetectionForm.h - options of a search for squats in long records, and the view of what is found.
#pragma once

#include <QTimer>

#include "project/Project.h"
#include "studio/tools/ToolForm.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace squat::studio {

class ButtonedList;
class RecordView;

class DetectionForm : public ToolForm {
  Q_OBJECT
 public:
  explicit DetectionForm(const plots::Style& style, QWidget* parent = nullptr);

  QString name() const override { return QStringLiteral("squats"); }
  QString title() const override { return tr("Squats in records"); }
  QString shortTitle() const override { return tr("Squats"); }
  QString explanation() const override;
  QString subject() const override { return tr("The search"); }
  QString fate() const override { return tr("Its results so far are discarded."); }
  ToolWork work() override;
  QString missing() const override;
  bool usesCase() const override;
  QWidget* view() const override;
  QString viewTitle() const override { return tr("Record"); }
  void setStyle(const plots::Style& style) override;
  void conclude() override;
  void save(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

  void addRecord(const QString& path);
  void addSample();  // the record that is shipped
  RecordView* records() const { return view_; }

  // What is chosen here and seen in the view, as a project keeps it; no files: nothing is open.
  project::LongRecords choices() const;
  void setChoices(const project::LongRecords& choices);

 Q_SIGNALS:
  void choicesChanged();
  void searchStarted();
  void passageRequested(const QString& file);
  void estimateRequested(const QString& file);

 private:
  void nameFields();
  void layOutFields();
  void connectParts();
  project::LongRecords chosen() const;  // without labels and what is seen in the view
  void askForRecords();
  void askForLabels();

  ButtonedList* files_;
  QLineEdit *channels_, *axles_, *chainage_, *labels_, *units_;
  QDoubleSpinBox* speed_;
  QComboBox* together_;
  QCheckBox* own_;
  RecordView* view_;
  QTimer draw_;  // once nothing has changed for a moment
};

}  // namespace squat::studio
