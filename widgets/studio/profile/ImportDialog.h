// widgets/studio/profile/ImportDialog.h - import of a measured profile, seen before it is taken.
#pragma once

#include <QDialog>
#include <QString>

#include "plots/Figure.h"
#include "studio/profile/ProfileImport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace squat::studio {

class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  // Throws FileError where the file cannot be read or is larger than 20 MB.
  ImportDialog(const QString& path, const plots::Style& style, QWidget* parent = nullptr);

  const std::vector<cases::ProfilePoint>& points() const { return profile_.points; }
  const QString& path() const { return path_; }
  // Whether the heights count from the line through the first and last point.
  bool levelsThroughEnds() const;

 private:
  void makeControls();
  void showSuggestion();
  void update();

  QString path_;
  std::string text_;
  ImportedProfile profile_;
  plots::Figure* plot_;
  QTableWidget* table_;
  QComboBox *delimiter_, *positionUnit_, *heightUnit_, *levelling_;
  QSpinBox *positionColumn_, *heightColumn_;
  QDoubleSpinBox *scale_, *step_;
  QCheckBox *comma_, *flip_, *reverse_;
  QLabel* message_;
  QPushButton* take_ = nullptr;
};

}  // namespace squat::studio
