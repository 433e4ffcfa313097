// widgets/studio/runs/GroupedRows.h - rows of a table in groups: those of one value in a column stand under a heading.
#pragma once

#include <QAbstractProxyModel>
#include <QSet>
#include <optional>
#include <vector>

namespace squat::studio {

// A flat model over a flat one. Groups stand in the order of their first rows, rows within a group in that of the
// source: a source that is sorted by the column of the groups puts the groups in the order of its values. A group that
// is closed shows its heading alone. Columns are named by a key, since they come and go (columnKeyRole of the source's
// headings); while there is no column of that key, there are no groups.
class GroupedRows : public QAbstractProxyModel {
  Q_OBJECT
 public:
  static constexpr int columnKeyRole = Qt::UserRole + 2;  // empty: rows cannot be grouped by this column
  explicit GroupedRows(QAbstractItemModel& source, QObject* parent = nullptr);

  void groupBy(const QString& columnKey);  // empty: no groups; all groups are open
  const QString& key() const { return key_; }
  int groupColumn() const;  // of the source; -1: there are no groups
  bool isHeading(const QModelIndex& index) const;
  bool isOpen(const QModelIndex& heading) const;
  void setOpen(const QModelIndex& heading, bool open);
  void reveal(const QModelIndex& source);  // opens the group of this row

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QModelIndex mapToSource(const QModelIndex& index) const override;
  QModelIndex mapFromSource(const QModelIndex& index) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  void sort(int column, Qt::SortOrder order) override;

 private:
  struct Row {
    int source = -1;  // -1: a heading
    QString group;    // the value that its rows share; empty without groups
    int members = 0;  // of a heading
    bool operator==(const Row&) const = default;
  };
  struct Kept {  // where an index of a view was
    QPersistentModelIndex source;
    std::optional<QString> heading;  // whose group it is
    int column = 0;
  };
  void follow(QAbstractItemModel& source);
  std::vector<Row> arranged() const;
  void beginChange();
  void endChange();
  QModelIndex headingOf(const QString& group, int column) const;
  QString headingText(const Row& row) const;

  QString key_;
  QSet<QString> closed_;  // values of groups
  std::vector<Row> rows_;
  QModelIndexList before_;
  std::vector<Kept> kept_;
};

}  // namespace squat::studio
