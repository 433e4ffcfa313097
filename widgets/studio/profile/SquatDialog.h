// widgets/studio/profile/SquatDialog.h - a squat by its class, form and size, drawn as it is chosen.
#pragma once

#include <QDialog>

#include "case/CaseDescription.h"
#include "detection/Severity.h"
#include "plots/Style.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QVBoxLayout;

namespace squat::studio {

class FixedLabel;

class SquatDialog : public QDialog {
  Q_OBJECT
 public:
  SquatDialog(cases::CaseDescription base, const plots::Style& style, QWidget* parent = nullptr);

  cases::CaseDescription description() const;  // the case with the squat that is chosen
  detection::Severity severity() const;

 private:
  QDoubleSpinBox* number(const QString& name, const QString& label, double low, double high);  // [mm]
  void takeSeverity(int severity);                                                             // its usual size
  void judge();
  void draw();

  cases::CaseDescription base_;
  plots::Style style_;
  QComboBox *severity_, *form_;
  QDoubleSpinBox *length_, *depth_;
  QVBoxLayout* layout_;
  FixedLabel* problem_;
  QPushButton* ok_;
  QWidget* picture_ = nullptr;
};

}  // namespace squat::studio
