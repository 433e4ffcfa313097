// widgets/studio/records/EventModel.h - the events of a record as a table: where, what, how severe, and what the user
// has seen there.
#pragma once

#include <QAbstractTableModel>
#include <QUndoStack>
#include <map>
#include <memory>
#include <vector>

#include "detection/DetectionFiles.h"
#include "project/EventList.h"
#include "project/Project.h"

namespace squat::studio {

using ReportPointer = std::shared_ptr<const detection::DetectionReport>;
using EventPointer = std::shared_ptr<const detection::CombinedEvent>;  // in its report, which it keeps

// A list of events that was written earlier, without the signals over them. `files`: the records where they are now,
// known by their names. Throws CaseError for a kind or a severity that is none.
ReportPointer reportOf(const project::EventList& list, const std::vector<std::string>& files);

class EventModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { position, kind, severity, length, depth, peak, speed, channel, side, passes, sureness, seen, columns };
  static constexpr int sortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;
  ~EventModel() override;

  // Of the same record, what was seen stays with the events of its channel within half a metre. No label that was set
  // before can be undone.
  void setReport(const ReportPointer& report);
  const ReportPointer& report() const { return report_; }
  const detection::CombinedEvent& at(int row) const { return report_->events.at(static_cast<std::size_t>(row)); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  // Of the last column alone: one of labels(). A change can be undone.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  static QStringList labels();  // "", "light squat", ..., "joint", ...
  QUndoStack& undoStack() { return undo_; }
  std::vector<detection::SeenEvent> seenEvents() const;
  // The same as a project keeps it, to the millimetre of squats.json; and back, which is no step to undo: false where
  // no event is near.
  std::vector<project::SeenEvent> seenForProject() const;
  bool see(const project::SeenEvent& noted);

 Q_SIGNALS:
  void labelStepped(int row);  // a label was set, undone or redone

 private:
  friend class LabelCommand;
  void become(const EventPointer& event, int label);  // nothing where another report is shown
  void setLabel(int row, int label);
  int labelOf(int row) const;                                      // its place among labels()
  int nearest(const std::string& onChannel, double metres) const;  // row; -1: none
  QString text(int row, int column) const;
  double number(int row, int column) const;

  ReportPointer report_;
  std::map<int, int> seen_;  // of a row, the place among labels()
  QUndoStack undo_;
};

}  // namespace squat::studio
