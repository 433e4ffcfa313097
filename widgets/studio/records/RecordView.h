// widgets/studio/records/RecordView.h - a long record with its events: the strip along the track, the list, and what
// can be done with one of them.
#pragma once

#include <QWidget>

#include "studio/records/EventModel.h"
#include "studio/records/RecordStrip.h"

class QComboBox;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace squat::studio {

class RecordView : public QWidget {
  Q_OBJECT
 public:
  explicit RecordView(const plots::Style& style, QWidget* parent = nullptr);

  // A record that is being read, then what was found in it; `folder` is where the list was written.
  void follow(const std::shared_ptr<const records::Overview>& overview);
  void setReport(const ReportPointer& report, const QString& folder);
  void stopFollowing();  // it was read, or will not be
  void setStyle(const plots::Style& style) { strip_->setStyle(style); }
  RecordStrip* strip() const { return strip_; }
  QTableView* table() const { return table_; }
  EventModel* model() const { return model_; }
  void writeLabels(const QString& path);  // throws FileError

 Q_SIGNALS:
  void passageRequested(const QString& file);  // to be shown in the figures
  void estimateRequested(const QString& file);
  void labelsSaved(const QString& path);
  void failed(const QString& problem);

 private:
  QWidget* makeBar();
  void makeTable();
  int chosen() const;  // event; -1: none
  QString passageOfChosen();
  void showChosen();
  void askForLabels();
  void enableButtons();

  RecordStrip* strip_;
  EventModel* model_;
  QSortFilterProxyModel* seen_;
  QTableView* table_;
  QComboBox* channel_;
  QPushButton *show_, *estimate_, *labels_;
  QString folder_;
};

}  // namespace squat::studio
