// widgets/studio/comparison/ComparisonModel.h - the comparison of the runs in the store as a table for a view.
#pragma once

#include <QAbstractTableModel>
#include <QPointer>
#include <QTimer>

#include "analysis/ComparisonTable.h"
#include "studio/comparison/ComparisonWorker.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// One row a run or measured signal of the store, in its order. Numbers come one after the other; nothing is computed
// while nobody looks.
class ComparisonModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int sortRole = Qt::UserRole + 1;
  explicit ComparisonModel(RunStore& store, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  void setSeen(bool seen);
  bool isBusy() const { return worker_.isBusy() || timer_.isActive(); }
  analysis::ComparisonTable table(const std::vector<int>& rows) const;  // these rows in this order

 private:
  ComparisonWorker::Source sourceOf(int row) const;
  void update();

  QPointer<RunStore> store_;  // a window lets its runs go before its widgets, which ask on
  ComparisonWorker worker_;
  QTimer timer_;
  bool seen_ = false;
  analysis::ComparisonTable table_;
  std::vector<QString> problems_;  // a row
};

}  // namespace squat::studio
