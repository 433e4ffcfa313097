#include "studio/comparison/ComparisonModel.h"

#include <QFont>

#include "studio/runs/RunTable.h"
#include "text/Units.h"

namespace squat::studio {
namespace {

constexpr int pause = 60;  // [ms] in which numbers gather before the table is made anew

// "power 130-320 Hz [(m/s2)2]" over three lines: columns as narrow as their numbers.
QString headingOf(const std::string& column) {
  QString heading = QString::fromStdString(text::withPrintedUnit(column));
  heading.replace(" [", "\n[").replace("power ", "power\n").replace("wavelength by ", "wavelength\nby ");
  heading.remove("\n[-]");
  heading[0] = heading[0].toUpper();
  return heading;
}

}  // namespace

ComparisonModel::ComparisonModel(RunStore& store, QObject* parent) : QAbstractTableModel(parent), store_(&store) {
  timer_.setSingleShot(true);
  timer_.setInterval(pause);
  connect(&timer_, &QTimer::timeout, this, &ComparisonModel::update);
  const auto soon = [this] {
    if (seen_ && !timer_.isActive()) timer_.start();
  };
  connect(&worker_, &ComparisonWorker::changed, this, soon);
  connect(&store, &RunStore::rowsInserted, this, soon);
  connect(&store, &RunStore::rowsRemoved, this, soon);
  connect(&store, &RunStore::modelReset, this, soon);
  connect(&store, &RunStore::dataChanged, this, soon);
  connect(&store, &RunStore::referenceChanged, this, soon);
  connect(&store, &RunStore::overlaysChanged, this, soon);
  connect(&store, &RunStore::currentChanged, this, soon);
}

void ComparisonModel::setSeen(bool seen) {
  seen_ = seen;
  if (seen) update();
}

ComparisonWorker::Source ComparisonModel::sourceOf(int row) const {
  const StoredRun& run = store_->at(row);
  return {run.record, run.reading, run.isMeasured()};
}

void ComparisonModel::update() {
  if (!store_) return;
  for (int row = 0; row < store_->rowCount(); ++row)
    if (store_->at(row).dragged) return;  // it is laid in a moment
  std::set<RecordPointer> there;
  for (int row = 0; row < store_->rowCount(); ++row) there.insert(store_->at(row).record);
  worker_.forgetAllBut(there);
  const int reference = store_->reference();
  std::vector<analysis::ComparedSignal> signals;
  std::vector<QString> problems;
  for (int row = 0; row < store_->rowCount(); ++row) {
    const StoredRun& run = store_->at(row);
    const QString name = run.opening ? run.label + tr(" (opening)")
                         : run.isMissing()
                             ? run.label + tr(" (missing)")
                             : QString::fromStdString(project::nameWithGain(run.label.toStdString(), run.reading));
    analysis::ComparedSignal signal{name.toStdString(), run.values.get(), {}, {}};
    QString problem = run.missing;
    const auto take = [&](const ComparisonWorker::Numbers* numbers, analysis::NamedNumbers& into) {
      if (!numbers) return;
      into = numbers->numbers;
      if (problem.isEmpty()) problem = numbers->problem;
    };
    if (!run.isMissing()) {
      take(worker_.numbersOf(sourceOf(row)), signal.numbers);
      if (!store_->at(reference).isMissing())  // it may still be opening
        take(worker_.likenessOf(sourceOf(row), sourceOf(reference)), signal.likeness);
    }
    signals.push_back(std::move(signal));
    problems.push_back(problem);
  }
  auto table = analysis::comparisonTable(signals);
  const bool sameShape = table.columns == table_.columns && table.rows.size() == table_.rows.size();
  if (!sameShape) beginResetModel();
  table_ = std::move(table);
  problems_ = std::move(problems);
  if (!sameShape)
    endResetModel();
  else if (rowCount() > 0)
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int ComparisonModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int ComparisonModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(table_.columns.size());
}

QVariant ComparisonModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto& cell = table_.rows[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
  const bool name = index.column() == 0;
  if (role == Qt::DisplayRole) return QString::fromStdString(cell.text);
  if (role == sortRole && !name && !std::isnan(cell.number)) return cell.number;
  if (role == sortRole) return QString::fromStdString(cell.text);
  if (role == Qt::TextAlignmentRole && !name) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (!store_ || index.row() >= store_->rowCount()) return {};
  if (role == Qt::DecorationRole && name) {
    const QColor colour = curveColour(store_->at(index.row()), index.row() == store_->current());
    return colour.isValid() ? QVariant(colour) : QVariant();
  }
  if (role == Qt::FontRole && index.row() == store_->reference()) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role == Qt::ToolTipRole) {
    const QString& problem = problems_[static_cast<std::size_t>(index.row())];
    if (!problem.isEmpty()) return problem;
    return index.row() == store_->reference() ? tr("the reference") : QString();
  }
  return {};
}

QVariant ComparisonModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical || section < 0 || section >= columnCount()) return {};
  const std::string& column = table_.columns[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return headingOf(column);
  if (role == Qt::AccessibleTextRole || role == Qt::ToolTipRole)
    return QString::fromStdString(text::withPrintedUnit(column));
  return {};
}

analysis::ComparisonTable ComparisonModel::table(const std::vector<int>& rows) const {
  analysis::ComparisonTable chosen{table_.columns, {}};
  for (const int row : rows) chosen.rows.push_back(table_.rows.at(static_cast<std::size_t>(row)));
  return chosen;
}

}  // namespace squat::studio
