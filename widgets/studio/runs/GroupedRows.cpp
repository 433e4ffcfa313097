#include "studio/runs/GroupedRows.h"

#include <QFont>
#include <QGuiApplication>
#include <QHash>
#include <QPalette>

namespace squat::studio {

GroupedRows::GroupedRows(QAbstractItemModel& source, QObject* parent) : QAbstractProxyModel(parent) {
  setSourceModel(&source);
  rows_ = arranged();
  follow(source);
}

void GroupedRows::follow(QAbstractItemModel& source) {
  connect(&source, &QAbstractItemModel::modelAboutToBeReset, this, &GroupedRows::beginResetModel);
  connect(&source, &QAbstractItemModel::modelReset, this, [this] {
    rows_ = arranged();
    endResetModel();
  });
  connect(&source, &QAbstractItemModel::layoutAboutToBeChanged, this, &GroupedRows::beginChange);
  connect(&source, &QAbstractItemModel::layoutChanged, this, &GroupedRows::endChange);
  connect(&source, &QAbstractItemModel::rowsAboutToBeInserted, this, &GroupedRows::beginChange);
  connect(&source, &QAbstractItemModel::rowsInserted, this, &GroupedRows::endChange);
  connect(&source, &QAbstractItemModel::rowsAboutToBeRemoved, this, &GroupedRows::beginChange);
  connect(&source, &QAbstractItemModel::rowsRemoved, this, &GroupedRows::endChange);
  connect(&source, &QAbstractItemModel::headerDataChanged, this, &GroupedRows::headerDataChanged);
  connect(&source, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& from, const QModelIndex& to) {
    if (groupColumn() >= 0 && arranged() != rows_) {  // a value that groups go by has changed
      beginChange();
      endChange();
    }
    for (int row = 0; row < rowCount(); ++row)
      if (const int at = rows_[static_cast<std::size_t>(row)].source; at >= from.row() && at <= to.row())
        Q_EMIT dataChanged(index(row, from.column()), index(row, to.column()));
  });
}

int GroupedRows::groupColumn() const {
  if (key_.isEmpty() || !sourceModel()) return -1;
  for (int column = 0; column < sourceModel()->columnCount(); ++column)
    if (sourceModel()->headerData(column, Qt::Horizontal, columnKeyRole).toString() == key_) return column;
  return -1;
}

std::vector<GroupedRows::Row> GroupedRows::arranged() const {
  std::vector<Row> rows;
  const int column = groupColumn();
  const int count = sourceModel() ? sourceModel()->rowCount() : 0;
  if (column < 0) {
    for (int row = 0; row < count; ++row) rows.push_back({row, QString()});
    return rows;
  }
  QStringList groups;
  QHash<QString, std::vector<int>> members;
  for (int row = 0; row < count; ++row) {
    const QString value = sourceModel()->index(row, column).data().toString();
    if (!members.contains(value)) groups << value;
    members[value].push_back(row);
  }
  for (const QString& group : groups) {
    rows.push_back({-1, group, static_cast<int>(members[group].size())});
    if (closed_.contains(group)) continue;
    for (const int row : members[group]) rows.push_back({row, group});
  }
  return rows;
}

// The indices that views hold (the current one, an open editor) move with their rows; those of rows that are no longer
// shown become invalid.
void GroupedRows::beginChange() {
  Q_EMIT layoutAboutToBeChanged();
  before_ = persistentIndexList();
  kept_.clear();
  for (const QModelIndex& index : before_) {
    kept_.push_back({mapToSource(index), std::nullopt, index.column()});
    if (isHeading(index)) kept_.back().heading = rows_[static_cast<std::size_t>(index.row())].group;
  }
}

void GroupedRows::endChange() {
  rows_ = arranged();
  QModelIndexList after;
  for (const Kept& kept : kept_)
    after << (kept.heading ? headingOf(*kept.heading, kept.column) : mapFromSource(kept.source));
  changePersistentIndexList(before_, after);
  before_.clear();
  kept_.clear();
  Q_EMIT layoutChanged();
}

QModelIndex GroupedRows::headingOf(const QString& group, int column) const {
  for (int row = 0; row < rowCount(); ++row)
    if (const Row& at = rows_[static_cast<std::size_t>(row)]; at.source < 0 && at.group == group)
      return createIndex(row, column);
  return {};
}

void GroupedRows::groupBy(const QString& columnKey) {
  if (columnKey == key_) return;
  beginChange();
  key_ = columnKey;
  closed_.clear();
  endChange();
}

bool GroupedRows::isHeading(const QModelIndex& index) const {
  return index.isValid() && index.row() < rowCount() && rows_[static_cast<std::size_t>(index.row())].source < 0;
}

bool GroupedRows::isOpen(const QModelIndex& heading) const {
  return isHeading(heading) && !closed_.contains(rows_[static_cast<std::size_t>(heading.row())].group);
}

void GroupedRows::setOpen(const QModelIndex& heading, bool open) {
  if (!isHeading(heading) || open == isOpen(heading)) return;
  const QString group = rows_[static_cast<std::size_t>(heading.row())].group;
  beginChange();
  if (open)
    closed_.remove(group);
  else
    closed_.insert(group);
  endChange();
}

void GroupedRows::reveal(const QModelIndex& source) {
  if (!source.isValid() || mapFromSource(source).isValid()) return;
  beginChange();
  closed_.remove(source.siblingAtColumn(groupColumn()).data().toString());
  endChange();
}

QModelIndex GroupedRows::index(int row, int column, const QModelIndex& parent) const {
  return hasIndex(row, column, parent) ? createIndex(row, column) : QModelIndex();
}

QModelIndex GroupedRows::parent(const QModelIndex&) const { return {}; }

int GroupedRows::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int GroupedRows::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !sourceModel() ? 0 : sourceModel()->columnCount();
}

QModelIndex GroupedRows::mapToSource(const QModelIndex& index) const {
  if (!index.isValid() || index.row() >= rowCount() || !sourceModel()) return {};
  const int row = rows_[static_cast<std::size_t>(index.row())].source;
  return row < 0 ? QModelIndex() : sourceModel()->index(row, index.column());
}

QModelIndex GroupedRows::mapFromSource(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  for (int row = 0; row < rowCount(); ++row)
    if (rows_[static_cast<std::size_t>(row)].source == index.row()) return createIndex(row, index.column());
  return {};
}

QString GroupedRows::headingText(const Row& row) const {
  const QString label =
      sourceModel()->headerData(groupColumn(), Qt::Horizontal, Qt::DisplayRole).toString().replace('\n', ' ');
  const QString arrow = closed_.contains(row.group) ? QStringLiteral("▸") : QStringLiteral("▾");
  const QString value = row.group.isEmpty() ? tr("without effect") : row.group;
  return tr("%1 %2: %3 (%4)").arg(arrow, label, value).arg(row.members);
}

QVariant GroupedRows::data(const QModelIndex& index, int role) const {
  if (!isHeading(index)) return mapToSource(index).data(role);
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::BackgroundRole) return QGuiApplication::palette().alternateBase();
  if (index.column() != 0) return {};
  if (role == Qt::DisplayRole) return headingText(row);
  if (role == Qt::ToolTipRole) return tr("Click, or press Enter, to open and close the group");
  if (role == Qt::AccessibleTextRole)
    return closed_.contains(row.group) ? tr("%1, closed").arg(headingText(row)) : tr("%1, open").arg(headingText(row));
  if (role != Qt::FontRole) return {};
  QFont font = QGuiApplication::font();
  font.setBold(true);
  return font;
}

QVariant GroupedRows::headerData(int section, Qt::Orientation orientation, int role) const {
  return sourceModel() ? sourceModel()->headerData(section, orientation, role) : QVariant();
}

Qt::ItemFlags GroupedRows::flags(const QModelIndex& index) const {
  return isHeading(index) ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : QAbstractProxyModel::flags(index);
}

void GroupedRows::sort(int column, Qt::SortOrder order) {
  if (sourceModel()) sourceModel()->sort(column, order);
}

}  // namespace squat::studio
