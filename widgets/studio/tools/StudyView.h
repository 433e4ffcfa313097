// widgets/studio/tools/StudyView.h - the runs of a study, filled as they end, and the way from one of them to its
// curves.
#pragma once

#include <QWidget>

#include "studio/tools/StudyRuns.h"

class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class StudyView : public QWidget {
  Q_OBJECT
 public:
  explicit StudyView(QWidget* parent = nullptr);

  void setStudy(const StudyPointer& study);
  void clear();
  void conclude();
  const StudyRuns& runs() const { return *runs_; }

 Q_SIGNALS:
  void runRequested(const squat::studies::StudyPoint& point);  // of a run that is done

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeTable();
  void fitColumns();
  void showState();
  int chosen() const;  // row of the study; -1: none, or one that is not done
  void openChosen();

  StudyRuns* runs_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLabel* says_;
  QPushButton* open_;
};

}  // namespace squat::studio
