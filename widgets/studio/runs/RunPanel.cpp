#include "studio/runs/RunPanel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "studio/common/Theme.h"
#include "studio/runs/LivePlot.h"
#include "studio/runs/ProgressText.h"
#include "studio/runs/RunController.h"

namespace squat::studio {

RunPanel::RunPanel(RunController& controller, const plots::Style& style, QWidget* parent)
    : QWidget(parent), controller_(controller) {
  const auto button = [this](const QString& text, const QString& name) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    made->setAccessibleName(text);
    return made;
  };
  run_ = button(tr("Run"), "run");
  resume_ = button(tr("Resume"), "resumeRun");
  resume_->setToolTip(tr("Resume the stopped run of this case (Ctrl+F5)"));
  pause_ = button(tr("Pause"), "pause");
  cancel_ = button(tr("Cancel"), "cancel");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress of the current phase"));
  state_ = new QLabel(tr("Ready"), this);
  state_->setObjectName("runState");
  figures_ = new QLabel(this);
  figures_->setObjectName("runFigures");
  figures_->setWordWrap(true);
  note_ = new QLabel(this);
  note_->setObjectName("runNote");
  note_->setWordWrap(true);
  note_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  note_->hide();
  why_ = new QLabel(this);
  why_->setObjectName("blockers");
  why_->setWordWrap(true);
  why_->setStyleSheet(QStringLiteral("color: %1;").arg(wrongColour));
  auto* hint =
      new QLabel(tr("Press F5 to roll the wheel over this profile. Axle box acceleration and contact force are "
                    "plotted here during the run."),
                 this);
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  hint->setForegroundRole(QPalette::PlaceholderText);
  live_ = new LivePlot(style, this);
  seen_ = new QStackedWidget(this);
  seen_->addWidget(hint);
  seen_->addWidget(live_);
  log_ = new QPlainTextEdit(this);
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(500);
  log_->setAccessibleName(tr("Run messages"));
  log_->setPlaceholderText(tr("Run messages"));
  log_->setMaximumHeight(46);  // two lines; older ones are scrolled to
  auto* top = new QHBoxLayout;
  for (QPushButton* each : {run_, resume_, pause_, cancel_}) top->addWidget(each);
  top->addWidget(progress_, 1);
  top->addWidget(state_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(top);
  layout->addWidget(why_);
  layout->addWidget(figures_);
  layout->addWidget(note_);
  layout->addWidget(seen_, 1);
  layout->addWidget(log_);
  connect(run_, &QPushButton::clicked, this, &RunPanel::runRequested);
  connect(resume_, &QPushButton::clicked, this, &RunPanel::resumeRequested);
  connect(pause_, &QPushButton::clicked, this, [this] { controller_.setPaused(!controller_.isPaused()); });
  connect(cancel_, &QPushButton::clicked, &controller_, &RunController::cancel);
  connect(&controller_, &RunController::started, this, [this] {
    live_->clear();
    seen_->setCurrentWidget(live_);
    log_->clear();
    showNote({});
    showState();
  });
  connect(&controller_, &RunController::pausedChanged, this, &RunPanel::showState);
  connect(&controller_, &RunController::stopping, this, &RunPanel::showState);
  connect(&controller_, &RunController::news, this, &RunPanel::showNews);
  connect(&controller_, &RunController::finished, this, [this](const ResultPointer& result) {
    showNote(result->complete       ? completionText(*result, controller_.isResumed())
             : result->time.empty() ? tr("Cancelled before rolling started: no results.")
                                    : tr("Stopped: %1. Partial results are kept and marked as incomplete.")
                                          .arg(QString::fromStdString(result->stopReason)));
    for (const auto& warning : result->warnings) say(QString::fromStdString(warning));
  });
  connect(&controller_, &RunController::failed, this, [this](const QString& sentence, const QString& details) {
    say(sentence);
    if (!details.isEmpty()) say(details);
  });
  connect(&controller_, &RunController::ended, this, &RunPanel::showState);
  showState();
}

void RunPanel::setBlockers(const QStringList& reasons) {
  blockers_ = reasons;
  showState();
}

void RunPanel::setStopped(bool canResume) {
  canResume_ = canResume;
  showState();
}

void RunPanel::setStyle(const plots::Style& style) { live_->setStyle(style); }

void RunPanel::say(const QString& line) { log_->appendPlainText(line); }

void RunPanel::showNote(const QString& note) {
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  figures_->setVisible(note.isEmpty());
}

void RunPanel::showState() {
  const bool running = controller_.isRunning();
  run_->setEnabled(!running && blockers_.isEmpty());
  run_->setToolTip(blockers_.isEmpty() ? tr("Run the case (F5)") : blockers_.join('\n'));
  resume_->setEnabled(!running && canResume_ && blockers_.isEmpty());
  resume_->setVisible(canResume_ && !running);
  pause_->setEnabled(running && !controller_.isStopping());
  pause_->setText(controller_.isPaused() && running ? tr("Continue") : tr("Pause"));
  pause_->setAccessibleName(pause_->text());
  cancel_->setEnabled(running && !controller_.isStopping());
  why_->setVisible(!blockers_.isEmpty() && !running);
  QString reason = blockers_.value(0);
  if (blockers_.size() > 1) reason += tr(" (and %n more)", nullptr, static_cast<int>(blockers_.size()) - 1);
  why_->setText(tr("Cannot run: %1").arg(reason));
  if (!running) {
    state_->setText(tr("Ready"));
    progress_->setValue(0);
  } else if (controller_.isStopping()) {
    state_->setText(tr("Stopping…"));
  } else if (controller_.isPaused()) {
    state_->setText(tr("Paused"));
  }
}

void RunPanel::showNews(const WorkerMonitor::News& news) {
  const Progress& now = news.progress;
  progress_->setValue(static_cast<int>(1000 * now.fraction));
  if (!controller_.isPaused() && !controller_.isStopping() && !now.phase.empty()) state_->setText(progressText(now));
  QStringList parts;
  if (now.simulatedTime > 0) parts << tr("%1 ms simulated").arg(now.simulatedTime * 1e3, 0, 'f', 2);
  if (now.elementUpdatesPerSecond > 0)
    parts << tr("%1 million element updates per second").arg(now.elementUpdatesPerSecond * 1e-6, 0, 'f', 1);
  if (now.energyResidual != 0) parts << tr("energy balance error %1 %").arg(now.energyResidual * 100, 0, 'f', 3);
  if (now.step > 0)
    parts << tr("time step %1 µs, limited by %2")
                 .arg(now.step * 1e6, 0, 'f', 3)
                 .arg(QString::fromStdString(now.limitedBy));
  figures_->setText(parts.join(QStringLiteral("  ·  ")));
  for (const QString& line : news.messages) say(line);
  live_->add(news.samples);
}

}  // namespace squat::studio
