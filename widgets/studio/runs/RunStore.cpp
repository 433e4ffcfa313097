#include "studio/runs/RunStore.h"

#include <QFont>
#include <algorithm>

#include "case/Resolve.h"

namespace squat::studio {

RunStore::RunStore(QObject* parent) : QAbstractListModel(parent) {}

int RunStore::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(runs_.size());
}

QVariant RunStore::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const StoredRun& run = at(index.row());
  if (role == Qt::DisplayRole) {
    QString text = run.label;
    if (run.opening) return text + tr(" (opening)");
    if (run.isMissing()) return text + tr(" (missing)");
    if (run.isMeasured()) text += tr(" (measured)");
    if (!run.isMeasured() && !run.result->complete) text += tr(" (incomplete)");
    if (!run.isMeasured() && run.path.isEmpty()) text += " *";
    return text;
  }
  if (role == Qt::ToolTipRole && run.isMissing()) return run.missing;
  if (role == Qt::ToolTipRole)
    return run.path.isEmpty() ? tr("not saved; case hash %1").arg(QString::fromStdString(run.result->caseHash))
                              : run.path;
  if (role == Qt::CheckStateRole && run.isMissing()) return {};
  if (role == Qt::CheckStateRole) return run.overlaid ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::FontRole && index.row() == current_) {
    QFont font;
    font.setBold(true);
    return font;
  }
  return {};
}

bool RunStore::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole) return false;
  auto& run = runs_[static_cast<std::size_t>(index.row())];
  if (run.isMissing()) return false;
  if (!run.overlaid) run.colourIndex = freeColourIndex();
  run.overlaid = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index);
  Q_EMIT overlaysChanged();
  return true;
}

Qt::ItemFlags RunStore::flags(const QModelIndex& index) const {
  return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable : Qt::NoItemFlags;
}

void describe(StoredRun& run) {
  if (!run.isMeasured() && run.result->resolvedCase)
    run.values = std::make_shared<cases::ComparedCase>(cases::comparedCase(run.result->resolvedCase->description));
  if (run.record) run.digest = analysis::runDigest(*run.record);
}

int RunStore::add(StoredRun run) {
  const int row = rowCount();
  const bool measured = run.isMeasured();
  run.overlaid = measured;
  run.colourIndex = freeColourIndex();
  describe(run);
  beginInsertRows({}, row, row);
  runs_.push_back(std::move(run));
  endInsertRows();
  makeNames();
  if (measured)
    Q_EMIT overlaysChanged();
  else
    setCurrent(row);
  return row;
}

void RunStore::replaceAll(std::vector<StoredRun> runs, int current) {
  beginResetModel();
  runs_.clear();
  current_ = -1;
  waiting_.reset();
  aside_.clear();
  for (StoredRun& run : runs) {
    if (run.isMissing()) run.overlaid = false;
    run.colourIndex = freeColourIndex();
    if (!run.isMissing()) describe(run);
    runs_.push_back(std::move(run));
  }
  if (current >= 0 && current < rowCount() && at(current).opening)
    waiting_ = at(current).link;
  else if (current >= 0 && current < rowCount() && !at(current).isMeasured())
    current_ = current;
  endResetModel();
  makeNames();
  Q_EMIT referenceChanged();
  Q_EMIT currentChanged();
  Q_EMIT overlaysChanged();
  Q_EMIT asideChanged();
}

void RunStore::list(std::vector<StoredRun> runs) {
  if (runs.empty()) return;
  if (current_ < 0 && rowOfLink(waiting_) < 0) waiting_ = runs.front().link;
  const int row = rowCount();
  beginInsertRows({}, row, row + static_cast<int>(runs.size()) - 1);
  for (StoredRun& run : runs) runs_.push_back(std::move(run));
  endInsertRows();
}

bool RunStore::fillRow(int row, const StoredRun& read) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  run.opening = false, run.missing = read.missing;
  if (read.isMissing()) {
    if (run.kept) run.path = run.kept->leave(), run.kept.reset();  // for whoever can read it
    if (reference_ == run.record) reference_.reset();
    return false;
  }
  const bool isWaitedFor = waiting_ && (waiting_ == run.link || rowOfLink(waiting_) < 0);  // or that one was removed
  if (reference_ == run.record) reference_ = read.record;
  run.result = read.result, run.record = read.record, run.reading = read.reading;
  run.values = read.values, run.digest = read.digest, run.fields = read.fields;
  run.colourIndex = freeColourIndex(), run.overlaid = run.link->overlaid;
  run.link.reset();
  return current_ < 0 && read.result && isWaitedFor;
}

void RunStore::fill(const std::vector<std::pair<int, StoredRun>>& read) {
  if (read.empty()) return;
  int first = rowCount(), last = -1, current = -1;
  bool overlaid = false;
  for (const auto& [row, run] : read) {
    if (fillRow(row, run)) current = row;
    overlaid = overlaid || at(row).overlaid;
    first = std::min(first, row), last = std::max(last, row);
  }
  makeNames();
  Q_EMIT dataChanged(index(first), index(last));
  Q_EMIT filled();
  if (current >= 0) setCurrent(current);
  if (overlaid) Q_EMIT overlaysChanged();
}

void RunStore::setResult(int row, const ResultPointer& result, Fields fields) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  if (reference_ == run.record) reference_ = result;
  run.result = result, run.record = result, run.fields = fields;
  Q_EMIT dataChanged(index(row), index(row));
  if (row == current_) Q_EMIT currentChanged();
  if (run.overlaid && row != current_) Q_EMIT overlaysChanged();
}

void RunStore::setMeasured(int row, const project::MeasuredRecord& measured, bool dragged) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  if (reference_ == run.record) reference_ = measured.record;
  run.record = measured.record, run.reading = measured.reading, run.dragged = dragged;
  describe(run);
  Q_EMIT dataChanged(index(row), index(row));
  if (run.overlaid) Q_EMIT overlaysChanged();
}

void RunStore::remove(int row) {
  if (row < 0 || row >= rowCount()) return;
  beginRemoveRows({}, row, row);
  runs_.erase(runs_.begin() + row);
  endRemoveRows();
  if (current_ > row)
    --current_;
  else if (current_ == row)
    current_ = computedNear(row);
  makeNames();
  Q_EMIT currentChanged();
}

void RunStore::putAside(int row) {
  if (row < 0 || row >= rowCount()) return;
  if (at(row).opening) return remove(row);
  constexpr std::size_t most = 5;  // a result may take a hundred megabytes
  if (aside_.size() == most) aside_.erase(aside_.begin());
  aside_.push_back({row, at(row), row == current_});
  remove(row);
  Q_EMIT asideChanged();
}

int RunStore::restore() {
  if (aside_.empty()) return -1;
  Aside last = std::move(aside_.back());
  aside_.pop_back();
  const int row = std::min(last.row, rowCount());
  const bool isOverlaid = last.run.overlaid;
  if (isOverlaid) last.run.colourIndex = freeColourIndex();
  beginInsertRows({}, row, row);
  runs_.insert(runs_.begin() + row, std::move(last.run));
  if (current_ >= row) ++current_;
  endInsertRows();
  makeNames();
  if (last.isCurrent)
    setCurrent(row);
  else if (isOverlaid)
    Q_EMIT overlaysChanged();
  Q_EMIT asideChanged();
  return row;
}

void RunStore::rename(int row, const QString& name) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  const QString given = name.simplified();
  if (given == run.label || (given.isEmpty() && run.isMeasured())) return;
  run.named = !given.isEmpty();
  run.label = given;
  makeNames();
  Q_EMIT dataChanged(index(row), index(row));
  Q_EMIT namesChanged();
}

// The first that no overlaid run has: each keeps its colour while others come and go.
std::size_t RunStore::freeColourIndex() const {
  std::size_t colourIndex = 0;
  const auto taken = [&](const StoredRun& run) { return run.overlaid && run.colourIndex == colourIndex; };
  while (std::any_of(runs_.begin(), runs_.end(), taken)) ++colourIndex;
  return colourIndex;
}

void RunStore::setColour(int row, const QColor& colour) {
  runs_.at(static_cast<std::size_t>(row)).colour = colour;
  Q_EMIT dataChanged(index(row), index(row));
  if (at(row).overlaid) Q_EMIT overlaysChanged();
}

// Also those that the user named are compared with: what is called by what differs, differs from them. The names of a
// project stand until all of its runs are read.
void RunStore::makeNames() {
  if (std::any_of(runs_.begin(), runs_.end(), [](const StoredRun& run) { return run.opening; })) return;
  std::vector<cases::CaseToName> known;
  for (const StoredRun& run : runs_)
    if (run.values) known.push_back({run.result->stem, run.values.get()});
  const auto names = cases::caseNames(known);
  auto next = names.begin();
  bool changed = false;
  for (StoredRun& run : runs_) {
    const std::string name = run.values ? *next++ : run.isMeasured() ? std::string() : run.result->stem;
    if (run.named || run.isMissing() || run.label == QString::fromStdString(name)) continue;
    run.label = QString::fromStdString(name);
    changed = true;
  }
  if (!changed) return;
  Q_EMIT dataChanged(index(0), index(rowCount() - 1));
  Q_EMIT namesChanged();
}

// A measured signal is laid over a run and is none itself.
int RunStore::computedNear(int row) const {
  for (int below = row; below < rowCount(); ++below)
    if (!at(below).isMeasured()) return below;
  for (int above = row - 1; above >= 0; --above)
    if (!at(above).isMeasured()) return above;
  return -1;
}

void RunStore::setCurrent(int row) {
  if (row < -1 || row >= rowCount() || row == current_) return;
  current_ = row;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
  Q_EMIT currentChanged();
}

ResultPointer RunStore::currentResult() const { return current_ < 0 ? nullptr : at(current_).result; }

void RunStore::setPath(int row, const QString& path) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  run.path = path, run.kept.reset();
  Q_EMIT dataChanged(index(row), index(row));
}

int RunStore::rowOf(const ResultPointer& result) const {
  for (int row = 0; row < rowCount(); ++row)
    if (at(row).result == result) return row;
  return -1;
}

int RunStore::rowOfRecord(const RecordPointer& record) const {
  for (int row = 0; row < rowCount(); ++row)
    if (at(row).record == record) return row;
  return -1;
}

std::size_t RunStore::signalNumber(int row) {
  auto& run = runs_.at(static_cast<std::size_t>(row));
  if (run.signal == 0) run.signal = ++lastSignal_;
  return run.signal;
}

int RunStore::rowOfSignal(std::size_t number) const {
  for (int row = 0; row < rowCount(); ++row)
    if (at(row).signal == number) return row;
  return -1;
}

int RunStore::rowOfLink(const RunLink& link) const {
  for (int row = 0; row < rowCount(); ++row)
    if (link && at(row).link == link) return row;
  return -1;
}

int RunStore::waitingCurrent() const { return current_ < 0 ? rowOfLink(waiting_) : -1; }

int RunStore::reference() const {
  if (const int chosen = chosenReference(); chosen >= 0) return chosen;
  int first = -1;
  for (int row = 0; row < rowCount(); ++row) {
    if (at(row).isMissing()) continue;
    if (at(row).isMeasured()) return row;
    if (first < 0) first = row;
  }
  return first;
}

void RunStore::setReference(int row) {
  if (row < 0 || row >= rowCount() || at(row).record == reference_) return;
  if (at(row).isMissing() && !at(row).opening) return;
  reference_ = at(row).record;
  Q_EMIT referenceChanged();
}

std::vector<ResultPointer> RunStore::unsaved() const {
  std::vector<ResultPointer> found;
  for (const StoredRun& run : runs_)
    if (!run.isMeasured() && run.path.isEmpty()) found.push_back(run.result);
  return found;
}

std::vector<StoredRun> RunStore::overlays() const {
  std::vector<StoredRun> chosen;
  for (int row = 0; row < rowCount(); ++row)
    if (row != current_ && at(row).overlaid) chosen.push_back(at(row));
  return chosen;
}

}  // namespace squat::studio
