// widgets/studio/records/RecordView.h - a long record with its events: the strip along the track, the list, and what
// can be done with one of them.
#pragma once

#include <QThreadPool>
#include <QWidget>
#include <atomic>
#include <optional>
#include <vector>

#include "project/Project.h"
#include "studio/records/EventModel.h"
#include "studio/records/RecordStrip.h"

class QAction;
class QComboBox;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class EventInspector;

class RecordView : public QWidget {
  Q_OBJECT
 public:
  explicit RecordView(const plots::Style& style, QWidget* parent = nullptr);
  ~RecordView() override;  // waits for the part of a record that is being read

  // A record that is being read, then what was found in it; `folder` is where the list was written.
  void follow(const std::shared_ptr<const records::Overview>& overview);
  void setReport(const ReportPointer& report, const QString& folder);
  void stopFollowing();  // it was read, or will not be
  // What a project kept, in place of what is shown. Files are read when the view is first seen: the list of events at
  // once, the first record in a thread of its own.
  void open(const project::LongRecords& kept);
  // Draws the records that are chosen now, before they are searched; notDrawn() where that is not possible yet. While
  // events are listed, their record stays.
  void draw(const project::LongRecords& chosen);
  void keep(project::LongRecords& into) const;  // the list, its order, what the user has seen
  bool isReading() const { return reading_; }
  void setStyle(const plots::Style& style);
  RecordStrip* strip() const { return strip_; }
  QTableView* table() const { return table_; }
  EventModel* model() const { return model_; }
  EventInspector* inspector() const { return inspector_; }
  void writeLabels(const QString& path);  // throws FileError

 Q_SIGNALS:
  void sampleRequested();                      // a record to try the window with
  void passageRequested(const QString& file);  // to be shown in the figures
  void estimateRequested(const QString& file);
  void labelsSaved(const QString& path);
  void failed(const QString& problem);
  void notDrawn(const QString& reason);  // what draw() still needs
  void changed();                        // what a project keeps

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;  // of the list

 private:
  void openWaiting();
  void readList(const project::LongRecords& kept);
  void readRecord(const project::LongRecords& kept, bool isChosen);
  void placeSeen();
  QWidget* makeBar();
  void makeTable();
  void makeUndo();
  int chosen() const;  // event; -1: none
  QString passageOfChosen();
  void showChosen();
  void choose(int event);   // where the filter lets it through
  void inspect(int event);  // -1: none
  void askForLabels();
  void openMenu(const QPoint& location);
  bool takesKey(int key);    // of list and strip: the next event, the one before, a label by its number
  void setLabel(int label);  // of the chosen event: its place in EventModel::labels()
  void enableButtons();

  RecordStrip* strip_;
  EventModel* model_;
  QSortFilterProxyModel* seen_;
  QTableView* table_;
  EventInspector* inspector_;
  QComboBox* channel_;
  QLineEdit* filter_;
  QPushButton *show_, *estimate_, *labels_;
  QAction *undo_, *redo_;  // of labels
  QString folder_;
  QString list_;                                 // squats.json of the events; empty: none
  std::optional<project::LongRecords> waiting_;  // for the view to be seen
  std::vector<project::SeenEvent> unplaced_;     // of a project, while no event is near
  std::atomic<int> generation_{0};               // of the record that is read
  bool reading_ = false;
  QThreadPool thread_;
};

}  // namespace squat::studio
