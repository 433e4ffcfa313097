// widgets/studio/runs/RunPanel.h - start, pause and stop a run, and watch it.
#pragma once

#include <QWidget>

#include "plots/Style.h"
#include "studio/runs/WorkerMonitor.h"

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace squat::studio {

class LivePlot;
class RunController;

class RunPanel : public QWidget {
  Q_OBJECT
 public:
  RunPanel(RunController& controller, const plots::Style& style, QWidget* parent = nullptr);

  // Why the case cannot be run, one sentence each; empty: it can.
  void setBlockers(const QStringList& reasons);
  // True where a run of this case was stopped and can be resumed.
  void setStopped(bool canResume);
  LivePlot* live() const { return live_; }
  void setStyle(const plots::Style& style);

 Q_SIGNALS:
  void runRequested();
  void resumeRequested();

 private:
  void showNews(const WorkerMonitor::News& news);
  void showState();
  void showNote(const QString& note);  // empty: the figures
  void say(const QString& line);

  RunController& controller_;
  QPushButton *run_, *resume_, *pause_, *cancel_;
  QProgressBar* progress_;
  QLabel *state_, *figures_, *why_;
  QLabel* note_;  // how the last run ended, in place of the figures of one that is under way
  LivePlot* live_;
  QStackedWidget* seen_;  // a hint, then the live curves
  QPlainTextEdit* log_;
  QStringList blockers_;
  bool canResume_ = false;
};

}  // namespace squat::studio
