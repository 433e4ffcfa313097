// widgets/studio/runs/AlignDialog.h - lays a measured signal along the track by hand: position, speed and gain.
#pragma once

#include <QDialog>

#include "studio/runs/RunStore.h"

class QDoubleSpinBox;

namespace squat::studio {

class FixedLabel;

// Stands beside the window; what it says is drawn at once. The signal is read again with each change, so that a project
// which is opened later draws the same.
class AlignDialog : public QDialog {
  Q_OBJECT
 public:
  AlignDialog(RunStore& store, int row, QWidget* parent = nullptr);

  // While the mouse drags the signal: `metres` since the button went down; laid for good where `done`.
  void shift(double metres, bool done);
  void done(int result) override;  // a drag that has not ended is undone

 Q_SIGNALS:
  // When the dialog closes: how the signal of this row, which lies otherwise now, lay when it opened.
  void aligned(int row, const project::MeasuredRecord& before);

 private:
  QDoubleSpinBox* numberOf(const QString& name, const QString& label, const QString& unit, double low, double high,
                           int decimals);
  int row() const { return store_.rowOfRecord(shown_); }
  void lay(const project::MeasuredReading& wanted, const signals::Record* beside = nullptr);
  void layAsTyped();
  void layAutomatically();
  void showValues();

  RunStore& store_;
  project::MeasuredRecord measured_;  // as it is laid for good
  project::MeasuredRecord first_;     // as it was when the dialog opened
  RecordPointer shown_;               // in the list
  QDoubleSpinBox *position_, *speed_, *gain_;
  FixedLabel* problem_;
};

}  // namespace squat::studio
