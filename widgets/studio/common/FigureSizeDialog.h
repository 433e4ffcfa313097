// widgets/studio/common/FigureSizeDialog.h - the size in which figures are copied and exported, whatever the window's.
#pragma once

#include <QDialog>

#include "plots/PrintedSize.h"

class QComboBox;
class QDoubleSpinBox;

namespace squat::studio {

class FigureSizeDialog : public QDialog {
  Q_OBJECT
 public:
  explicit FigureSizeDialog(const plots::PrintedSize& size, QWidget* parent = nullptr);

  plots::PrintedSize size() const;

 private:
  void takePreset(int row);

  QComboBox* preset_;
  QDoubleSpinBox *width_, *height_, *resolution_;
};

// As it was last chosen, for the next start.
plots::PrintedSize storedFigureSize();
void storeFigureSize(const plots::PrintedSize& size);

}  // namespace squat::studio
