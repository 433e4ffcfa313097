// widgets/studio/comparison/ComparisonWindow.h - runs and measured signals side by side, in a window of its own: a
// table as wide as the screen beside the figures.
#pragma once

#include <QWidget>
#include <vector>

class QComboBox;
class QMenu;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class ComparisonModel;
class FixedLabel;
class MapWindow;
class RunStore;

class ComparisonWindow : public QWidget {
  Q_OBJECT
 public:
  ComparisonWindow(RunStore& store, QWidget* parent);

  QTableView* table() const { return table_; }
  bool isBusy() const;                       // numbers are still to come
  void copy() const;                         // the table as it is sorted, tab-separated
  void writeCsv(const QString& path) const;  // with every digit; throws FileError
  void fillMenu(QMenu& menu, int row);       // of the store
  void showMaps();                           // of the chosen signal beside the reference
  MapWindow* maps() const { return maps_; }  // null: not asked for yet

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void makeTable();
  QWidget* makeBar();
  void listReferences();
  void askForFile();
  void showMenu(const QPoint& place);
  std::vector<int> shownRows() const;  // of the store, in the order in which they stand

  RunStore& store_;
  ComparisonModel* model_;
  QSortFilterProxyModel* seen_;
  QTableView* table_;
  QComboBox* reference_;
  FixedLabel* problem_;
  MapWindow* maps_ = nullptr;
};

}  // namespace squat::studio
