// widgets/studio/runs/RunTable.h - the runs as a table: name, peak, lines, what differs between the cases, mesh, time.
#pragma once

#include <QAbstractTableModel>
#include <QPointer>
#include <vector>

#include "studio/runs/RunStore.h"

namespace squat::studio {

// Of its curve in the figures; not valid where there is none.
QColor curveColour(const StoredRun& run, bool current);

// One row a run of the store, in its order. The name can be edited and carries the check box of the overlay. Numbers
// sort as numbers (sortRole).
class RunTable : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int sortRole = Qt::UserRole + 1;
  explicit RunTable(RunStore& store, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  enum class Kind { name, peak, lines, parameter, mesh, time };
  struct Column {
    Kind kind = Kind::name;
    std::size_t row = 0;  // of a compared case
    bool operator==(const Column&) const = default;
  };
  std::vector<Column> columnsNow() const;
  static QString tipOf(Kind kind);  // of its heading; empty for keys, whose own words stand there
  QString text(const StoredRun& run, const Column& column) const;
  QVariant sorted(const StoredRun& run, const Column& column) const;

  QPointer<RunStore> store_;  // a window lets its runs go before its widgets, which ask on
  std::vector<Column> columns_;
};

}  // namespace squat::studio
