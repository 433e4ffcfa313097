// widgets/studio/records/EventModel.h - the events of a record as a table: where, what, how severe, and what the user
// has seen there.
#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <vector>

#include "detection/DetectionFiles.h"
#include "project/EventList.h"
#include "project/Project.h"

namespace squat::studio {

using ReportPointer = std::shared_ptr<const detection::DetectionReport>;

// A list of events that was written earlier, without the signals over them. `files`: the records where they are now,
// known by their names. Throws CaseError for a kind or a severity that is none.
ReportPointer reportOf(const project::EventList& list, const std::vector<std::string>& files);

class EventModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { position, kind, severity, length, depth, peak, speed, channel, side, passes, sureness, seen, columns };
  static constexpr int sortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  // Of the same record, what was seen stays with the events of its channel within half a metre.
  void setReport(const ReportPointer& report);
  const ReportPointer& report() const { return report_; }
  const detection::CombinedEvent& at(int row) const { return report_->events.at(static_cast<std::size_t>(row)); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  // Of the last column alone: one of labels().
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  static QStringList labels();  // "", "light squat", ..., "joint", ...
  std::vector<detection::SeenEvent> seenEvents() const;
  // The same as a project keeps it, to the millimetre of squats.json; and back: false where no event is near.
  std::vector<project::SeenEvent> seenForProject() const;
  bool see(const project::SeenEvent& noted);

 private:
  int nearest(const std::string& onChannel, double metres) const;  // row; -1: none
  QString text(int row, int column) const;
  double number(int row, int column) const;

  ReportPointer report_;
  std::map<int, int> seen_;  // of a row, the place among labels()
};

}  // namespace squat::studio
