// widgets/studio/runs/MeasuredDialog.h - how a measured file is read where it does not say so itself.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>

#include "readers/SignalFile.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace squat::studio {

class MeasuredDialog : public QDialog {
  Q_OBJECT
 public:
  // Tries to read the file so and returns why it cannot be; empty: it was, and the dialog closes.
  using Reading = std::function<QString(const readers::SignalFileOptions&)>;

  // `reason`: what the file does not say.
  MeasuredDialog(const QString& path, const QString& reason, Reading read, QWidget* parent = nullptr);

  void accept() override;

 private:
  readers::SignalFileOptions options() const;

  Reading read_;
  QLabel* reason_;
  QLineEdit *column_, *timeColumn_, *object_;
  QDoubleSpinBox *rate_, *speed_;
};

}  // namespace squat::studio
