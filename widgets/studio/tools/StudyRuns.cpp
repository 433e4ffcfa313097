#include "studio/tools/StudyRuns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "case/CaseNames.h"
#include "case/DecimalNumber.h"
#include "case/RightSide.h"
#include "studies/StudySummary.h"
#include "studio/common/Words.h"
#include "text/Numbers.h"

namespace squat::studio {
namespace {

using studies::RunState;

// Resumed, or computed again: the rows are the same.
bool haveSameRuns(const studies::StudyProgress& one, const studies::StudyProgress& other) {
  if (one.definition == other.definition) return true;
  const auto &a = one.definition->variations, &b = other.definition->variations;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.key == y.key; }) &&
         std::equal(one.runs.begin(), one.runs.end(), other.runs.begin(), other.runs.end(),
                    [](const auto& x, const auto& y) { return x.row->point.values == y.row->point.values; });
}

int percent(const studies::RunProgress& run) { return static_cast<int>(100 * std::clamp(run.fraction, 0.0, 1.0)); }

bool looksAlike(const studies::RunProgress& one, const studies::RunProgress& other) {
  return one.row == other.row && one.state == other.state && percent(one) == percent(other);
}

const studies::SummaryFeature& featureAt(int place) {
  return studies::summaryFeatures()[static_cast<std::size_t>(place)];
}

int featureCount() { return static_cast<int>(studies::summaryFeatures().size()); }

}  // namespace

void StudyRuns::setStudy(const StudyPointer& study) {
  concluded_ = false;
  if (!study_ || !haveSameRuns(*study_, *study)) {
    beginResetModel();
    study_ = study;
    endResetModel();
    return;
  }
  const StudyPointer before = std::exchange(study_, study);
  for (int row = 0; row < rowCount(); ++row)
    if (!looksAlike(before->runs[static_cast<std::size_t>(row)], at(row)))
      Q_EMIT dataChanged(index(row, 0), index(row, columnCount() - 1));
}

void StudyRuns::clear() {
  beginResetModel();
  study_.reset();
  concluded_ = false;
  endResetModel();
}

void StudyRuns::conclude() {
  concluded_ = true;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, stateColumn()), index(rowCount() - 1, stateColumn()));
}

int StudyRuns::count(RunState state) const {
  if (!study_) return 0;
  return static_cast<int>(std::count_if(study_->runs.begin(), study_->runs.end(),
                                        [&](const studies::RunProgress& run) { return run.state == state; }));
}

int StudyRuns::stateColumn() const { return study_ ? static_cast<int>(study_->definition->variations.size()) : 0; }

int StudyRuns::reasonColumn() const { return stateColumn() + 1 + featureCount(); }

int StudyRuns::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !study_ ? 0 : static_cast<int>(study_->runs.size());
}

int StudyRuns::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !study_ ? 0 : reasonColumn() + 1;
}

QString StudyRuns::stateText(const studies::RunProgress& run) const {
  switch (run.state) {
    case RunState::waiting:
      return concluded_ ? tr("not computed") : tr("waiting");
    case RunState::computing:
      return concluded_ ? tr("cancelled") : tr("computing %1 %").arg(percent(run));
    case RunState::done:
      return tr("done");
    case RunState::failed:
      return tr("failed");
    case RunState::cancelled:
      break;
  }
  return tr("cancelled");
}

// NaN where the run has none.
double StudyRuns::featureOf(int row, int column) const {
  return studies::valueOf(*at(row).row, featureAt(column - stateColumn() - 1));
}

QString StudyRuns::text(int row, int column) const {
  const auto& run = at(row);
  if (column < stateColumn()) return QString::fromStdString(run.row->point.values[static_cast<std::size_t>(column)]);
  if (column == stateColumn()) return stateText(run);
  if (column == reasonColumn())
    return run.state == RunState::failed ? QString::fromStdString(run.row->message) : QString();
  if (run.state != RunState::done) return {};
  const double value = featureOf(row, column);
  return std::isnan(value) ? QStringLiteral("–") : QString::fromStdString(text::roundedText(value));
}

QVariant StudyRuns::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount() || index.column() >= columnCount()) return {};
  const bool isWords = index.column() == stateColumn() || index.column() == reasonColumn();
  if (role == Qt::TextAlignmentRole) return int((isWords ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) return text(index.row(), reasonColumn());
  if (role == Qt::DisplayRole) return text(index.row(), index.column());
  return role == sortRole ? sorted(index.row(), index.column()) : QVariant();
}

// Numbers as numbers; those that are not there yet are the smallest.
QVariant StudyRuns::sorted(int row, int column) const {
  const QString shown = text(row, column);
  if (column == stateColumn() || column == reasonColumn()) return shown;
  if (column < stateColumn()) {
    const auto number = cases::parseDecimal(shown.toStdString());
    return number ? QVariant(*number) : QVariant(shown);
  }
  const double value = featureOf(row, column);
  return std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;
}

QVariant StudyRuns::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical || section < 0 || section >= columnCount()) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  if (section < stateColumn()) {
    const auto& key = study_->definition->variations[static_cast<std::size_t>(section)].key;
    const auto& parameter = *cases::findOnEitherSide(key);
    if (role == Qt::ToolTipRole) return QString::fromStdString(key + ": " + parameter.doc);
    QString label =
        QString::fromStdString((cases::keyOnRight(key).empty() ? "" : "right ") + cases::shortLabel(parameter));
    label[0] = label[0].toUpper();
    if (parameter.unit.empty() || parameter.unit == "-") return label;
    return QStringLiteral("%1\n[%2]").arg(label, printedUnits(QString::fromStdString(parameter.unit)));
  }
  if (section == stateColumn()) return role == Qt::DisplayRole ? tr("State") : tr("How far the run is");
  if (section == reasonColumn()) return role == Qt::DisplayRole ? tr("Reason") : tr("Why the run failed");
  const auto& feature = featureAt(section - stateColumn() - 1);
  if (role == Qt::ToolTipRole) return QString::fromUtf8(feature.name);
  QString head = QString::fromUtf8(feature.head).replace(" [", "\n[");
  head[0] = head[0].toUpper();
  return head;
}

QString StudyRuns::widestText(int column) const {
  if (column == stateColumn()) return tr("computing %1 %").arg(100);
  if (column > stateColumn()) return QStringLiteral("00000.00");
  QString widest;
  for (int row = 0; row < rowCount(); ++row)
    if (const QString shown = text(row, column); shown.size() > widest.size()) widest = shown;
  return widest;
}

}  // namespace squat::studio
