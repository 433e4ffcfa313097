// widgets/studio/runs/RunsPanel.h - the table of runs: click to see one, tick to overlay it, F2 to rename it.
#pragma once

#include <QWidget>

#include "project/Project.h"

class QComboBox;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class GroupedRows;
class RunStore;

// Sorted by a click on a heading (a third one: in the order they were made), filtered by what is typed above, grouped
// by the column that is chosen there. Columns come and go with the runs: the rows are sorted and grouped by the one
// that was chosen whenever it is there.
class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(RunStore& store, QWidget* parent = nullptr);
  QTableView* table() const { return table_; }
  QModelIndex indexOf(int row) const;         // of a run; not valid where the filter or a closed group hides it
  int rowOf(const QModelIndex& index) const;  // of the store; -1: none, as for the heading of a group
  void fillMenu(QMenu& menu, int row);        // what can be done with this run
  project::TableOrder order() const;          // as a project keeps it
  void setOrder(const project::TableOrder& order);

 Q_SIGNALS:
  void orderChanged();
  void openRequested();
  void saveRequested();
  void saveRunRequested(int row);
  void measuredRequested();
  void compareRequested();
  void findRequested(int row);  // the file of a run that is missing
  void caseRequested(int row);
  void removeRequested(int row);
  void alignRequested(int row);    // a measured signal
  void columnsRequested(int row);  // the same
  void folderRequested(const QString& path);

 private:
  void makeTable();
  QWidget* makeChoices();
  void listGroupings();
  void spanHeadings();
  void sortAsChosen();
  bool takesKey(const QModelIndex& heading, int key);
  QWidget* makeButtons();
  void connectTable();
  void makeCurrent(const QModelIndex& index);
  void chooseColour(int row);
  void fitNames();
  QModelIndex seenIndexOf(int row) const;  // in the filtered table, whatever group it is in
  bool eventFilter(QObject* watched, QEvent* event) override;

  RunStore& store_;
  QSortFilterProxyModel* seen_;
  GroupedRows* groups_;
  QLineEdit* filter_;
  QComboBox* groupBy_;
  QTableView* table_;
  QString sortedBy_;  // name of the column, which may not be there now; empty: none
  bool descending_ = false;
  bool arranging_ = false;  // not the user
  bool ticked_ = false;     // by the mouse button that is down
};

}  // namespace squat::studio
