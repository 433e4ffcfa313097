// widgets/studio/runs/MeasuredDialog.h - which columns of a measured file are read, and what they hold.
#pragma once

#include <QDialog>
#include <QString>
#include <QTimer>
#include <memory>

#include "plots/Figure.h"
#include "studio/runs/MeasuredLook.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QTableWidget;

namespace squat::studio {

class BackgroundJob;
class RunStore;

// Lists the columns of the file and shows its first rows at once, from its beginning alone. The signal is read in the
// background with each choice and drawn as it would be laid over a run; what cannot be read so is said, and not taken.
class MeasuredDialog : public QDialog {
  Q_OBJECT
 public:
  // `first`: what the controls show when it opens.
  MeasuredDialog(MeasuredChoice first, const plots::Style& style, QWidget* parent = nullptr);
  ~MeasuredDialog() override;  // does not wait for a file that is being read

  // As the file is read by what is chosen; empty while that goes on, and where it cannot be read.
  const std::vector<project::MeasuredRecord>& records() const { return look_.records; }
  void accept() override;  // nothing where there are none

 private:
  QComboBox* listIn(const QString& label, const QString& name);
  QDoubleSpinBox* numberIn(const QString& label, const QString& name, const QString& unit, double maximum);
  void makeForm();
  void makeLayout();
  void takeHead(const readers::SignalFileOptions& options, const std::string& run);
  void takePart(int part);
  void listParts();
  void listColumns(const std::string& run);
  void recogniseUnit();
  MeasuredChoice choice() const;
  void forget();      // what was read: it is another choice now
  void changeSoon();  // once the number is typed
  void change();
  void showUnit();
  void showTaken();
  void showSpeed(const readers::TableRoles& taken);
  void showHeadings(const readers::TableRoles& taken);
  void read();
  void takeLook();
  void draw();
  void say(const QString& words, bool wrong);

  const MeasuredChoice first_;
  readers::SignalFileOptions options_;  // what no control shows, and what the part is chosen by
  MeasuredHead head_;
  MeasuredLook look_;
  std::shared_ptr<MeasuredLook> reading_;  // what the job fills
  BackgroundJob* job_;
  QTimer wait_;
  bool stale_ = false;       // the choice has changed since the job began
  bool needsSpeed_ = false;  // the file links time and position in no way
  double gain_;              // of the alignment, without that of the unit
  int unitIndex_ = 0;
  plots::Figure* plot_;
  QFormLayout* form_;
  QTableWidget* table_;
  QLabel *reason_, *message_;
  QComboBox *part_ = nullptr, *signal_ = nullptr, *unit_ = nullptr, *time_ = nullptr, *position_ = nullptr;
  QDoubleSpinBox *rate_ = nullptr, *speed_ = nullptr;
  QPushButton* take_ = nullptr;
};

// Opens it for a measured signal of the list, which is read again in its place: name, colour, overlay and alignment
// stay. `speed` [m/s]: of the case.
void askForColumns(RunStore& store, int row, double speed, const plots::Style& style, QWidget* parent);

}  // namespace squat::studio
