// widgets/studio/runs/RunsPanel.h - the table of runs: click to see one, tick to overlay it, F2 to rename it.
#pragma once

#include <QWidget>

class QMenu;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class RunStore;

// Sorted by a click on a heading (a third one: in the order they were made), filtered by what is typed above.
class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(RunStore& store, QWidget* parent = nullptr);
  QTableView* table() const { return table_; }
  QModelIndex indexOf(int row) const;         // of a run in the table; not valid where the filter hides it
  int rowOf(const QModelIndex& index) const;  // of the store; -1: none
  void fillMenu(QMenu& menu, int row);        // what can be done with this run

 Q_SIGNALS:
  void openRequested();
  void saveRequested();
  void saveRunRequested(int row);
  void measuredRequested();
  void compareRequested();
  void findRequested(int row);  // the file of a run that is missing
  void removeRequested(int row);
  void alignRequested(int row);  // a measured signal
  void folderRequested(const QString& path);

 private:
  void makeTable();
  QWidget* makeButtons();
  void connectTable();
  void makeCurrent(const QModelIndex& index);
  void chooseColour(int row);
  void fitNames();
  bool eventFilter(QObject* watched, QEvent* event) override;

  RunStore& store_;
  QSortFilterProxyModel* seen_;
  QTableView* table_;
  bool ticked_ = false;  // by the mouse button that is down
};

}  // namespace squat::studio
