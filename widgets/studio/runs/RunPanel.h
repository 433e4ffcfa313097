// widgets/studio/runs/RunPanel.h - start, pause and stop a run, and watch it.
#pragma once

#include <QDateTime>
#include <QWidget>

#include "plots/Style.h"
#include "studio/runs/WorkerMonitor.h"

class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace squat::studio {

class FixedLabel;
class LivePlot;
class RunController;

class RunPanel : public QWidget {
  Q_OBJECT
 public:
  RunPanel(RunController& controller, const plots::Style& style, QWidget* parent = nullptr);

  // Why the case cannot be run, one sentence each; empty: it can.
  void setBlockers(const QStringList& reasons);
  void setStopped(const QDateTime& when);  // the run of the case that can be resumed; not valid: there is none
  void clear();                            // removes what is shown of the last run, unless it is under way
  LivePlot* live() const { return live_; }
  void setStyle(const plots::Style& style);

 Q_SIGNALS:
  void runRequested();
  void resumeRequested();

 private:
  void showNews(const WorkerMonitor::News& news);
  void showState();
  void setState(const QString& words);
  void showLine();
  void say(const QString& line);

  RunController& controller_;
  QPushButton *run_, *resume_, *pause_, *cancel_;
  QProgressBar* progress_;
  FixedLabel* line_;  // why the case cannot be run, else how the last run ended, else figures of the one under way
  QString note_, figures_;
  LivePlot* live_;
  QStackedWidget* seen_;  // a hint, then the live curves
  QPlainTextEdit* log_;
  QStringList blockers_;
  QDateTime stopped_;
};

}  // namespace squat::studio
