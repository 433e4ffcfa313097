// widgets/studio/records/RecordStrip.h - a long record along the chainage: its extremes, and marks at its events.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "plots/Figure.h"
#include "plots/Style.h"
#include "records/Overview.h"
#include "studio/records/EventModel.h"

class QPushButton;
class QTimer;

namespace squat::studio {

// The wheel of the mouse or + and - zoom, dragging or arrows scroll; a double click or Home shows the whole. It grows
// while the record is read. A click on a kind in the legend hides its marks, which cannot be picked then.
class RecordStrip : public QWidget {
  Q_OBJECT
 public:
  explicit RecordStrip(const plots::Style& style, QWidget* parent = nullptr);

  void follow(const std::shared_ptr<const records::Overview>& overview);  // until setReport()
  void setReport(const ReportPointer& report);
  void stopFollowing();
  void clear();  // no record
  void setChannel(const QString& name);
  QString channel() const;
  QStringList channels() const;
  void show(double position);  // [m]: brings it into the middle, and marks it
  void showWhole();
  void setStyle(const plots::Style& style);
  void setEventKeys(std::function<bool(int key)> take);  // N, P and digits; true where it took the key
  plots::Figure* figure() const { return figure_; }

 Q_SIGNALS:
  void sampleRequested();  // there is no record, and the user wants to see one
  void channelsChanged();
  void eventPicked(int event);  // the nearest mark to where the mouse was pressed

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeFigure();
  void showEmptyState();
  void placeSample();
  void grow();
  void draw();
  void drawMarks();
  QStringList hiddenKinds() const;  // in the legend, by its names
  int place() const;                // of the channel; -1: this record has none of its name
  void pick(const QPoint& point);

  std::shared_ptr<const records::Overview> overview_;
  ReportPointer report_;
  std::shared_ptr<const records::Overview> overviewBefore_;  // while another record is read
  ReportPointer reportBefore_;
  plots::Style style_;
  plots::Figure* figure_ = nullptr;
  QCPGraph* signal_ = nullptr;
  QCPItemStraightLine* chosen_ = nullptr;
  QCPItemText* nextStep_ = nullptr;  // in place of the axes where there is no record
  QPushButton* sample_;
  QString channel_;
  std::optional<double> position_;
  QTimer* timer_;
  std::function<bool(int key)> eventKeys_;
  bool whole_ = true;  // the view grows with the record
};

}  // namespace squat::studio
