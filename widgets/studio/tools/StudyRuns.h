// widgets/studio/tools/StudyRuns.h - the runs of a study as a table, while they are computed and after.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "studies/StudyProgress.h"

namespace squat::studio {

using StudyPointer = std::shared_ptr<const studies::StudyProgress>;

// One row a run: values of the keys, state, the features of the summary, and why it failed. Of the same study, only
// what has changed is drawn anew, and every row stays where it is.
class StudyRuns : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int sortRole = Qt::UserRole + 1;  // numbers as numbers

  using QAbstractTableModel::QAbstractTableModel;

  void setStudy(const StudyPointer& study);
  void clear();
  void conclude();  // what has not ended is not being computed any more
  int count(studies::RunState state) const;
  const studies::RunProgress& at(int row) const { return study_->runs.at(static_cast<std::size_t>(row)); }
  QString widestText(int column) const;  // that a row may show there, so that widths need not change

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  int stateColumn() const;   // behind the keys
  int reasonColumn() const;  // the last one
  QString stateText(const studies::RunProgress& run) const;
  double featureOf(int row, int column) const;
  QString text(int row, int column) const;
  QVariant sorted(int row, int column) const;

  StudyPointer study_;  // null: none
  bool concluded_ = false;
};

}  // namespace squat::studio
