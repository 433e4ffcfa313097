#include "studio/profile/ProfileTable.h"

#include <QLocale>
#include <cmath>

#include "studio/profile/EditedDefect.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {

ProfileTable::ProfileTable(EditedDefect& defect, QObject* parent) : QAbstractTableModel(parent), defect_(defect) {
  connect(&defect_, &EditedDefect::changed, this, &ProfileTable::update);
  update();
}

void ProfileTable::update() {
  const auto& defect = defect_.description().defect;
  const bool sampled = defect.shape == cases::DefectShape::profile;
  scale_ = shownScale(defect);
  std::vector<cases::ProfilePoint> points = sampled ? defect.points : std::vector<cases::ProfilePoint>();
  if (points.size() == points_.size()) {
    points_ = std::move(points);
    if (!points_.empty()) Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(points_.size()) - 1, 1));
    return;
  }
  beginResetModel();
  points_ = std::move(points);
  endResetModel();
}

void ProfileTable::setUnit(const HeightUnit& unit) {
  unit_ = unit;
  Q_EMIT headerDataChanged(Qt::Horizontal, 1, 1);
  if (!points_.empty()) Q_EMIT dataChanged(index(0, 1), index(static_cast<int>(points_.size()) - 1, 1));
}

int ProfileTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int ProfileTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant ProfileTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || static_cast<std::size_t>(index.row()) >= points_.size()) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const auto& point = points_[static_cast<std::size_t>(index.row())];
  return index.column() == 0 ? QString::number(point.position * 1e3, 'g', 8)
                             : QString::number(point.height * scale_ * unit_.perMetre, 'g', 8);
}

QVariant ProfileTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  return section == 0 ? tr("Position [mm]") : tr("Height [%1]").arg(unit_.name);
}

Qt::ItemFlags ProfileTable::flags(const QModelIndex& index) const {
  return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable : Qt::NoItemFlags;
}

// A number that would pass a neighbour is refused, not clamped: what was typed is what counts.
bool ProfileTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid()) return false;
  if (value.toString() == data(index, Qt::EditRole).toString()) return true;  // the cell rounds: not a change
  bool valid = false;
  const double number = value.toString().trimmed().replace(',', '.').toDouble(&valid);
  if (!valid || !std::isfinite(number)) return false;
  const auto row = static_cast<std::size_t>(index.row());
  cases::ProfilePoint to = points_[row];
  if (index.column() == 1 && !(scale_ > 0)) return false;  // any height would be shown as zero
  (index.column() == 0 ? to.position : to.height) = number / (index.column() == 0 ? 1e3 : scale_ * unit_.perMetre);
  if (std::abs(to.height) > 0.05) return false;
  cases::CaseDescription after = defect_.description();
  after.defect.points = movedPoint(after.defect.points, row, to);
  if (after.defect.points[row].position != to.position) return false;
  after.defect.file.clear();
  defect_.edit(tr("Change point %1").arg(row + 1), after);
  return true;
}

}  // namespace squat::studio
