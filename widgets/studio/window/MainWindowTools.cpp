// The tools: studies, calibration, receptance, records and estimates, and what comes out of them.
#include <QAction>
#include <QMenu>

#include "studio/common/Theme.h"
#include "studio/document/ParameterForm.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/tools/CalibrationForm.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/EstimateForm.h"
#include "studio/tools/GrowthForm.h"
#include "studio/tools/JobsButton.h"
#include "studio/tools/ReceptanceForm.h"
#include "studio/tools/StudyForm.h"
#include "studio/tools/TargetList.h"
#include "studio/tools/ToolTabs.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {
namespace {

ToolForm* formOf(const QString& name, const RunStore& store, const plots::Style& style) {
  if (name == "study") return new StudyForm;
  if (name == "calibration") return new CalibrationForm(store);
  if (name == "squats") return new DetectionForm(style);
  if (name == "estimate") return new EstimateForm(store);
  if (name == "growth") return new GrowthForm(style);
  return new ReceptanceForm;
}

}  // namespace

void MainWindow::makeToolActions(QMenu& menu) {
  menu.addSeparator();
  const auto add = [&](const QString& text, const QKeySequence& keys, const QString& name, const QString& tip) {
    QAction* action = menu.addAction(text, this, [this, name] { showTool(name); });
    action->setShortcut(keys);
    action->setShortcutContext(Qt::ApplicationShortcut);  // from one tool to the next
    action->setObjectName(name + "Action");
    action->setToolTip(tip);
  };
  add(tr("&Study…"), QKeySequence("F8"), "study", tr("Run the case for many values of its keys"));
  add(tr("C&alibration…"), QKeySequence("F9"), "calibration",
      tr("Find unknown values from targets that the case must meet"));
  add(tr("&Growth under traffic…"), QKeySequence("Shift+F8"), "growth",
      tr("Wear and plastic flow over millions of tonnes"));
  add(tr("Track recep&tance…"), QKeySequence("Shift+F9"), "receptance",
      tr("Receptance of the track, and modes of the wheelset"));
  add(tr("S&quats in records…"), QKeySequence("Ctrl+F8"), "squats", tr("Find squats in long records"));
  add(tr("Profile from &measured passages…"), QKeySequence("Ctrl+F9"), "estimate",
      tr("Find the profile that explains measured signals"));
}

ToolTabs* MainWindow::toolTabs() {
  if (!toolTabs_) toolTabs_ = new ToolTabs(this);
  return toolTabs_;
}

ToolWindow* MainWindow::tool(const QString& name) {
  ToolWindow*& window = tools_[name];
  if (window) return window;
  const auto style = figureStyle(requestedDark());
  const auto blocker = [this] {
    takeWhatIsTyped();
    return form_->blockers().value(0);
  };
  window = new ToolWindow(document_, formOf(name, store_, style), blocker, style);
  toolTabs()->add(window);
  window->setProject(keeper_->path());
  connect(keeper_, &ProjectKeeper::openChanged, window, [this, window] { window->setProject(keeper_->path()); });
  connect(window, &ToolWindow::progressed, this, &MainWindow::showJobs);
  connect(window, &ToolWindow::helpRequested, this, &MainWindow::showHelp);
  connect(window, &ToolWindow::resultsKept, reader_, &RunReader::add);
  connect(window, &ToolWindow::runRequested, this, [this](const QString& file, const QString& label) {
    reader_->show(file.toStdString(), label.toStdString());
    activateWindow(), raise();
  });
  connect(window, &ToolWindow::openCaseRequested, this, &MainWindow::openCase);
  connect(window, &ToolWindow::caseFound, this, [this](const QString& path) {
    listCase(path);
    keeper_->saveSoon();
  });
  if (const auto* records = qobject_cast<DetectionForm*>(window->form())) {
    connect(records, &DetectionForm::passageRequested, this, [this](const QString& file) {
      if (openMeasured(file)) showTab("aba_position"), activateWindow(), raise();
    });
    connect(records, &DetectionForm::estimateRequested, this, [this](const QString& file) {
      openMeasured(file);  // beside the run of the estimate
      qobject_cast<EstimateForm*>(tool("estimate")->form())->passages()->setFile(file);
      showTool("estimate");
    });
  }
  return window;
}

void MainWindow::showTool(const QString& name) { toolTabs()->open(*tool(name)); }

void MainWindow::showJobs() {
  std::vector<Job> jobs;
  for (const auto& [name, window] : tools_)
    if (window && !window->progress().isEmpty())
      jobs.push_back({window->form()->title(), window->progress(), [this, name = name] { showTool(name); },
                      [window = window] { window->cancel(); }});
  jobs_->setJobs(std::move(jobs));
}

bool MainWindow::mayLeaveTools() {
  constexpr int patience = 20000;  // [ms]: a computation asks whether it is cancelled many times a second
  for (const auto& [name, window] : tools_)
    if (window->isComputing() &&
        services_.asker(this, tr("%1 is in progress. %2").arg(window->form()->subject(), window->form()->fate()),
                        tr("Stop it and close")) == Answer::cancel)
      return false;
  for (const auto& [name, window] : tools_) {  // none is stopped before all may be
    window->cancel();
    window->waitFor(patience);
  }
  return true;
}

}  // namespace squat::studio
