#include "studio/runs/RunPanel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "studio/common/FixedLabel.h"
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
  pause_ = button(tr("Pause"), "pause");
  cancel_ = button(tr("Cancel"), "cancel");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setObjectName("runProgress");
  progress_->setAccessibleName(tr("Progress of the current phase"));
  line_ = new FixedLabel(2, this);
  line_->setObjectName("runLine");
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
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(top);
  layout->addWidget(line_);
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
    note_.clear(), figures_.clear();
    showState();
  });
  connect(&controller_, &RunController::pausedChanged, this, &RunPanel::showState);
  connect(&controller_, &RunController::stopping, this, &RunPanel::showState);
  connect(&controller_, &RunController::news, this, &RunPanel::showNews);
  connect(&controller_, &RunController::finished, this, [this](const ResultPointer& result) {
    note_ = result->complete       ? completionText(*result, controller_.isResumed())
            : result->time.empty() ? tr("Cancelled before rolling started: no results.")
                                   : tr("Stopped: %1. Partial results are kept and marked as incomplete.")
                                         .arg(QString::fromStdString(result->stopReason));
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

void RunPanel::setStopped(const QDateTime& when) {
  stopped_ = when;
  const QString time = QLocale().toString(when, QLocale::ShortFormat);
  resume_->setToolTip(when.isValid() ? tr("Resume the run of this case that was stopped at %1 (Ctrl+F5)").arg(time)
                                     : tr("No run of this case was stopped (Ctrl+F5)"));
  showState();
}

void RunPanel::clear() {
  if (controller_.isRunning()) return;
  note_.clear(), figures_.clear();
  live_->clear();
  seen_->setCurrentIndex(0);
  log_->clear();
  showState();
}

void RunPanel::setStyle(const plots::Style& style) { live_->setStyle(style); }

void RunPanel::say(const QString& line) { log_->appendPlainText(line); }

void RunPanel::showState() {
  const bool running = controller_.isRunning();
  run_->setEnabled(!running && blockers_.isEmpty());
  run_->setToolTip(blockers_.isEmpty() ? tr("Run the case (F5)") : blockers_.join('\n'));
  resume_->setEnabled(!running && stopped_.isValid() && blockers_.isEmpty());
  pause_->setEnabled(running && !controller_.isStopping());
  pause_->setText(controller_.isPaused() && running ? tr("Continue") : tr("Pause"));
  pause_->setAccessibleName(pause_->text());
  cancel_->setEnabled(running && !controller_.isStopping());
  showLine();
  if (!running) {
    setState(tr("Ready"));
    progress_->setValue(0);
  } else if (controller_.isStopping()) {
    setState(tr("Stopping…"));
  } else if (controller_.isPaused()) {
    setState(tr("Paused"));
  }
}

// On the bar itself: beside it, a longer text would make the bar shorter.
void RunPanel::setState(const QString& words) {
  constexpr int around = 8;
  progress_->setFormat(progress_->fontMetrics().elidedText(words, Qt::ElideRight, progress_->width() - around));
  progress_->setToolTip(words);
}

void RunPanel::showLine() {
  if (blockers_.isEmpty() || controller_.isRunning()) return line_->say(note_.isEmpty() ? figures_ : note_);
  const int more = static_cast<int>(blockers_.size()) - 1;
  line_->warn(tr("Cannot run: %1").arg(blockers_[0]) + (more > 0 ? tr(" (and %n more)", nullptr, more) : QString()));
}

void RunPanel::showNews(const WorkerMonitor::News& news) {
  const Progress& now = news.progress;
  progress_->setValue(static_cast<int>(1000 * now.fraction));
  if (!controller_.isPaused() && !controller_.isStopping() && !now.phase.empty()) setState(progressText(now));
  QStringList parts;
  if (now.simulatedTime > 0) parts << tr("%1 ms simulated").arg(now.simulatedTime * 1e3, 0, 'f', 2);
  if (now.elementUpdatesPerSecond > 0)
    parts << tr("%1 million element updates per second").arg(now.elementUpdatesPerSecond * 1e-6, 0, 'f', 1);
  if (now.energyResidual != 0) parts << tr("energy balance error %1 %").arg(now.energyResidual * 100, 0, 'f', 3);
  if (now.step > 0)
    parts << tr("time step %1 µs, limited by %2")
                 .arg(now.step * 1e6, 0, 'f', 3)
                 .arg(QString::fromStdString(now.limitedBy));
  figures_ = parts.join(QStringLiteral("  ·  "));
  showLine();
  for (const QString& line : news.messages) say(line);
  live_->add(news.samples);
}

}  // namespace squat::studio
