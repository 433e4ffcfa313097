// widgets/studio/profile/ProfileTable.h - the points of the profile as numbers.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "case/CaseDescription.h"

#include "studio/common/HeightUnit.h"

namespace squat::studio {

class EditedDefect;

// Two columns: position [mm], height as it is run, with the height scale [um or mm]. Read-only for analytic shapes
// (their handles are no points of the case).
class ProfileTable : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit ProfileTable(EditedDefect& defect, QObject* parent = nullptr);

  void setUnit(const HeightUnit& unit);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  void update();
  EditedDefect& defect_;
  HeightUnit unit_;
  double scale_ = 1;  // from the heights of the case to those shown
  std::vector<cases::ProfilePoint> points_;
};

}  // namespace squat::studio
