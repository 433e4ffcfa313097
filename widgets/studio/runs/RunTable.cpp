#include "studio/runs/RunTable.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>

#include "case/DecimalNumber.h"
#include "plots/Style.h"
#include "studio/common/RowTable.h"
#include "studio/common/Words.h"
#include "studio/runs/GroupedRows.h"
#include "studio/runs/ProgressText.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {
namespace {

constexpr std::size_t shownLines = 3;

// [s] that the computation took; 0: not known.
double computingTime(const StoredRun& run) {
  if (!run.isMeasured())
    for (const auto& figure : run.result->performance)
      if (figure.name == "seconds") return figure.value;
  return 0;
}

std::size_t meshRow() {
  const auto& table = cases::parameterTable();
  return static_cast<std::size_t>(cases::findParameter("mesh.preset") - table.data());
}

// Empty where the key has no effect in this case; a dash where the run has no case.
QString valueOf(const StoredRun& run, std::size_t row) {
  return run.values ? QString::fromStdString((*run.values)[row].shown) : QStringLiteral("–");
}

QString linesOf(const StoredRun& run) {
  QStringList lines;
  for (const double line : run.digest.lines)
    if (lines.size() < static_cast<qsizetype>(shownLines)) lines << QString::number(line, 'f', 0);
  return lines.join(", ");
}

}  // namespace

QColor curveColour(const StoredRun& run, bool current) {
  const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
  const plots::Style style = dark ? plots::darkStyle() : plots::lightStyle();
  if (current) return style.curve(0);
  if (!run.overlaid) return {};
  return run.colour.isValid() ? run.colour : style.overlay(run.colourIndex);
}

RunTable::RunTable(RunStore& store, QObject* parent) : QAbstractTableModel(parent), store_(&store) {
  columns_ = columnsNow();
  // What differs, and so the columns, may change with every run that comes or goes.
  const auto begin = [this] { beginResetModel(); };
  const auto end = [this] {
    columns_ = columnsNow();
    endResetModel();
  };
  connect(&store, &RunStore::filled, this, [this] {
    auto columns = columnsNow();
    if (columns == columns_) return;
    beginResetModel();
    columns_ = std::move(columns);
    endResetModel();
  });
  connect(&store, &RunStore::rowsAboutToBeInserted, this, begin);
  connect(&store, &RunStore::rowsInserted, this, end);
  connect(&store, &RunStore::rowsAboutToBeRemoved, this, begin);
  connect(&store, &RunStore::rowsRemoved, this, end);
  connect(&store, &RunStore::modelAboutToBeReset, this, begin);
  connect(&store, &RunStore::modelReset, this, end);
  connect(&store, &RunStore::dataChanged, this, [this](const QModelIndex& from, const QModelIndex& to) {
    Q_EMIT dataChanged(index(from.row(), 0), index(to.row(), columnCount() - 1));
  });
}

std::vector<RunTable::Column> RunTable::columnsNow() const {
  std::vector<Column> columns{{Kind::name}, {Kind::peak}, {Kind::lines}};
  std::vector<const cases::ComparedCase*> cases;
  for (int row = 0; row < store_->rowCount(); ++row)
    if (store_->at(row).values) cases.push_back(store_->at(row).values.get());
  for (const std::size_t row : cases::differingRows(cases))
    if (row != meshRow()) columns.push_back({Kind::parameter, row});
  columns.push_back({Kind::mesh, meshRow()});
  columns.push_back({Kind::time});
  return columns;
}

int RunTable::rowCount(const QModelIndex& parent) const { return parent.isValid() || !store_ ? 0 : store_->rowCount(); }

int RunTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QString RunTable::text(const StoredRun& run, const Column& column) const {
  switch (column.kind) {
    case Kind::name:
      break;
    case Kind::peak:
      return run.digest.peak > 0 ? QString::number(run.digest.peak, 'f', 1) : QString();
    case Kind::lines:
      return linesOf(run);
    case Kind::parameter:
    case Kind::mesh:
      return valueOf(run, column.row);
    case Kind::time:
      return computingTime(run) > 0 ? durationText(computingTime(run)) : QString();
  }
  return run.label;
}

QVariant RunTable::sorted(const StoredRun& run, const Column& column) const {
  if (column.kind == Kind::peak) return run.digest.peak;
  if (column.kind == Kind::time) return computingTime(run);
  if (column.kind == Kind::lines) return run.digest.lines.empty() ? 0.0 : run.digest.lines.front();
  const QString shown = text(run, column);
  if (column.kind == Kind::parameter)
    if (const auto number = cases::parseDecimal(shown.toStdString())) return *number;
  return shown;
}

QVariant RunTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const StoredRun& run = store_->at(index.row());
  const Column& column = columns_[static_cast<std::size_t>(index.column())];
  if (role == sortRole) return sorted(run, column);
  if (role == Qt::EditRole) return text(run, column);
  if (role == Qt::TextAlignmentRole && column.kind != Kind::name) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::DecorationRole && column.kind == Kind::name) {
    const QColor colour = curveColour(run, index.row() == store_->current());
    return colour.isValid() ? QVariant(colour) : QVariant();
  }
  const bool ofTheRun = column.kind == Kind::name || role == Qt::FontRole || role == Qt::ToolTipRole;
  if (ofTheRun) return store_->data(store_->index(index.row()), role);
  return role == Qt::DisplayRole ? text(run, column) : QVariant();
}

bool RunTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != 0 || index.row() >= rowCount()) return false;
  if (role == Qt::CheckStateRole) return store_->setData(store_->index(index.row()), value, role);
  if (role != Qt::EditRole) return false;
  store_->rename(index.row(), value.toString());
  return true;
}

QString RunTable::tipOf(Kind kind) {
  switch (kind) {
    case Kind::name:
      return tr("What distinguishes the run from the others; F2 renames it");
    case Kind::peak:
      return tr("Largest absolute axle box acceleration, low-passed");
    case Kind::lines:
      return tr(
          "Frequencies of the strongest lines (peaks) in the spectrum of the axle box acceleration, the strongest "
          "first");
    case Kind::time:
      return tr("Time that the computation took");
    case Kind::parameter:
    case Kind::mesh:
      break;
  }
  return {};
}

QVariant RunTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical || section < 0 || section >= columnCount()) return {};
  const Column& column = columns_[static_cast<std::size_t>(section)];
  const auto& parameter = cases::comparedParameter(column.row);
  const std::string key = cases::comparedKey(column.row);
  if (role == Qt::ToolTipRole && (column.kind == Kind::parameter || column.kind == Kind::mesh))
    return QString::fromStdString(key + ": " + parameter.doc);
  const bool isKey = column.kind == Kind::parameter || column.kind == Kind::mesh;
  if (role == Qt::ToolTipRole) return tipOf(column.kind);
  if (role == GroupedRows::columnKeyRole || (role == columnNameRole && isKey))
    return isKey ? QString::fromStdString(key) : QString();
  if (role == columnNameRole)
    return column.kind == Kind::name    ? "name"
           : column.kind == Kind::peak  ? "peak"
           : column.kind == Kind::lines ? "lines"
                                        : "computing_time";
  if (role != Qt::DisplayRole) return {};  // two lines: a column is hardly wider than its values
  switch (column.kind) {
    case Kind::name:
      return tr("Run");
    case Kind::peak:
      return tr("Peak\n[m/s²]");
    case Kind::lines:
      return tr("Lines\n[Hz]");
    case Kind::mesh:
      return tr("Mesh");
    case Kind::time:
      return tr("Computed in").replace(' ', '\n');
    case Kind::parameter:
      break;
  }
  QString label = QString::fromStdString(cases::comparedLabel(column.row));
  label[0] = label[0].toUpper();
  if (parameter.unit.empty() || parameter.unit == "-" || cases::isList(parameter)) return label;
  return QStringLiteral("%1\n[%2]").arg(label, printedUnits(QString::fromStdString(parameter.unit)));
}

Qt::ItemFlags RunTable::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() != 0) return usual;
  const bool missing = index.row() < rowCount() && store_->at(index.row()).isMissing();
  return usual | Qt::ItemIsEditable | (missing ? Qt::NoItemFlags : Qt::ItemIsUserCheckable);
}

}  // namespace squat::studio
