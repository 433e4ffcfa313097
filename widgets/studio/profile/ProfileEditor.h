// widgets/studio/profile/ProfileEditor.h - the defect: curve, numbers, shapes, import; of a whole model of either side.
#pragma once

#include <QWidget>

#include "plots/Style.h"
#include "studio/common/HeightUnit.h"

class QComboBox;
class QLabel;
class QSplitter;
class QTableView;

namespace squat::studio {

class FixedLabel;
class CaseDocument;
class EditedDefect;
class ProfilePlot;
class ProfileTable;

class ProfileEditor : public QWidget {
  Q_OBJECT
 public:
  ProfileEditor(CaseDocument& document, const plots::Style& style, QWidget* parent = nullptr);

  ProfilePlot* plot() const { return plot_; }
  QTableView* table() const { return table_; }
  void setStyle(const plots::Style& style);
  void importFile(const QString& path);  // opens the preview

 Q_SIGNALS:
  void failed(const QString& message);

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;  // of the table

 private:
  void makePlot(const plots::Style& style);
  void askForFile();
  void exportFile();
  void chooseSquat();
  QWidget* makeToolBar();
  QComboBox* makeSideChoice(QWidget* parent);
  void showSides();
  HeightUnit unit() const;
  void showPoints();
  void showChosen();  // in the table
  void showNotes();

  plots::Style style_;
  EditedDefect* defect_;  // of the side that is shown
  ProfilePlot* plot_ = nullptr;
  QTableView* table_;
  QSplitter* splitter_;
  QComboBox *side_, *snap_, *unitChoice_;
  ProfileTable* points_;
  QLabel* location_;
  FixedLabel* notes_;
};

}  // namespace squat::studio
