#include "studio/window/MainWindow.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <utility>

#include "case/CaseFile.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/model/ScenePanel.h"
#include "studio/preview/PreviewPanel.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RecordWatch.h"
#include "studio/project/RunReader.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/AutomaticAlignment.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/JobsButton.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

Answer askWithBox(QWidget* parent, const QString& question, const QString& discardText) {
  QMessageBox box(QMessageBox::Question, QObject::tr("Squat Studio"), question, QMessageBox::Cancel, parent);
  QPushButton* discard = box.addButton(discardText, QMessageBox::DestructiveRole);
  QPushButton* save = discardText == QObject::tr("Discard") ? box.addButton(QMessageBox::Save) : nullptr;
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == discard) return Answer::discard;
  return save && box.clickedButton() == save ? Answer::save : Answer::cancel;
}

}  // namespace

MainWindow::MainWindow(StudioServices services, QWidget* parent)
    : QMainWindow(parent),
      services_(std::move(services)),
      controller_(services_.runner),
      preview_(services_.preview, services_.threads),
      stopped_(services_.runsFolder) {
  if (!services_.asker) services_.asker = askWithBox;
  setObjectName("mainWindow");
  setAcceptDrops(true);
  makeParts();
  makeDocks();
  makeFileMenu();
  makeEditMenu();
  makeRunMenu();
  makeFigureMenu();
  makeViewMenu();
  makeHelpMenu();
  connectParts();
  connectPreview();
  makeProject();
  widthOfAll_ = minimumSizeHint().width();
  layout()->setSizeConstraint(QLayout::SetNoConstraint);  // setNarrow() makes room below the width of all
  setMinimumSize(smallestSize);
  resize(usualSize.boundedTo(screen()->availableSize()));
  takeLayout();
  showTitle();
  recoverWork();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeParts() {
  const bool dark = requestedDark();
  applyTheme(dark);
  const plots::Style style = figureStyle(dark);
  keeper_ = new ProjectKeeper([this] { return work(); }, services_.recoveryFolder, this);
  reader_ = new RunReader(store_, this);
  recordWatch_ = new RecordWatch(this);
  auto* centre = new QWidget(this);
  messages_ = new MessageBar(this);
  middle_ = new QTabWidget(centre);
  middle_->setDocumentMode(true);
  middle_->setAccessibleName(tr("Profile, model, summary and notes"));
  profile_ = new ProfileEditor(document_, style, middle_);
  scene_ = new ScenePanel(store_, dark, middle_);
  paper_ = new PaperPanel(store_, services_.comparison, middle_);
  middle_->addTab(profile_, tr("Profile"));
  middle_->addTab(scene_, tr("3-D"));
  middle_->addTab(paper_, tr("Summary"));
  notes_ = new NotesPanel(middle_);
  middle_->addTab(notes_, tr("Notes"));
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(middle_, 1);
  setCentralWidget(centre);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(messages_, 1);
  jobs_ = new JobsButton(this);
  statusBar()->addPermanentWidget(jobs_);
  form_ = new ParameterForm(document_, this);
  signals_ = new SignalsPanel(store_, style, this);
  previewPanel_ = new PreviewPanel(preview_, store_, style, this);
  right_ = new QTabWidget(this);
  right_->setDocumentMode(true);
  right_->setAccessibleName(tr("Signals of runs, and the preview"));
  right_->addTab(signals_, tr("Runs"));
  right_->addTab(previewPanel_, tr("Preview"));
  run_ = new RunPanel(controller_, style, this);
  runs_ = new RunsPanel(store_, this);
  comparison_ = new ComparisonWindow(store_, this);
}

QWidget* MainWindow::showForm() {
  if (isNarrow_) {
    middle_->setCurrentWidget(form_);
    return middle_;
  }
  formDock_->show();
  formDock_->raise();
  return formDock_;
}

void MainWindow::connectParts() {
  connect(&document_, &CaseDocument::titleChanged, this, &MainWindow::showTitle);
  connect(form_, &ParameterForm::blockersChanged, this, [this] {
    run_->setBlockers(form_->blockers());
    showTitle();
  });
  run_->setBlockers(form_->blockers());
  connect(run_, &RunPanel::runRequested, this, &MainWindow::startRun);
  connect(run_, &RunPanel::resumeRequested, this, &MainWindow::resumeRun);
  connect(&document_, &CaseDocument::changed, this, &MainWindow::showStopped);
  connect(&controller_, &RunController::started, this, &MainWindow::showStopped);
  connect(&controller_, &RunController::ended, this, [this] {
    held_.reset();
    showStopped();
  });
  showStopped();
  connect(&store_, &RunStore::currentChanged, this, &MainWindow::enableActions);
  connect(&store_, &RunStore::currentChanged, this, &MainWindow::showShownCase);
  for (const auto signal : {&RunStore::currentChanged, &RunStore::filled})
    connect(&store_, signal, this, [this] {
      if (!align_) alignWithCurrent(store_);  // nothing moves under the hand that aligns
    });
  connect(&store_, &RunStore::namesChanged, this, &MainWindow::showShownCase);
  connect(&document_, &CaseDocument::changed, this, &MainWindow::showShownCase);
  connect(&document_, &CaseDocument::noted, messages_,
          [this](const QString& note) { messages_->say(note.left(1).toUpper() + note.mid(1)); });
  connect(&store_, &RunStore::overlaysChanged, this, &MainWindow::enableActions);
  connect(&store_, &RunStore::asideChanged, this, &MainWindow::enableActions);
  connect(&controller_, &RunController::finished, this, &MainWindow::keep);
  connect(&controller_, &RunController::refused, this, [this](const std::vector<CaseProblem>& problems) {
    if (cases::writeCase(document_.description()) == running_) form_->mark(problems);  // else it may be mended already
  });
  connect(&controller_, &RunController::failed, this,
          [this](const QString& sentence, const QString& details, const ResultPointer& soFar) {
            messages_->warn(sentence, details);
            if (soFar) store_.add({soFar, QString::fromStdString(soFar->stem) + tr(" (failed)"), QString(), false});
          });
  connect(profile_, &ProfileEditor::failed, messages_, [this](const QString& text) { messages_->warn(text); });
  connect(signals_, &SignalsPanel::failed, messages_, [this](const QString& text) { messages_->warn(text); });
  connect(scene_, &ScenePanel::failed, messages_, [this](const QString& text) { messages_->warn(text); });
}

void MainWindow::showTitle() {
  const QString project = keeper_->isOpen() ? keeper_->name() + " - " : QString();
  setWindowTitle(tr("%1[*] - %2Squat Studio").arg(document_.name(), project));
  setWindowModified(hasUnsavedChanges());
  setWindowFilePath(document_.path());
}

void MainWindow::showShownCase() {
  const int row = store_.current();
  const QString name = row < 0 ? QString() : store_.at(row).label;
  signalsDock_->setWindowTitle(name.isEmpty() ? tr("Signals") : tr("Signals: %1").arg(name));
  const QString different = differenceOfCases(store_.currentResult().get(), document_.description());
  signals_->setNote(different.isEmpty() ? QString() : tr("“%1” is of another case: %2").arg(name, different));
}

// A value that is still being typed counts as typed: shortcuts do not move the focus, which is what enters it.
void MainWindow::takeWhatIsTyped() {
  QWidget* typing = focusWidget();
  if (auto* number = qobject_cast<QAbstractSpinBox*>(typing)) return number->interpretText();
  auto* line = qobject_cast<QLineEdit*>(typing);
  if (!line || !line->isModified()) return;
  if (line->hasFocus())
    line->clearFocus(), line->setFocus();
  else  // the window is not the active one
    Q_EMIT line->editingFinished();
}

void MainWindow::beginRun(bool resume) {
  takeWhatIsTyped();
  showTab("run");  // where the reasons stand
  if (!form_->blockers().isEmpty() || controller_.isRunning()) return;
  if (!resume && stopped_.has(document_.description()) &&
      services_.asker(this, tr("A stopped run of this case can be resumed (Ctrl+F5). Starting over discards it."),
                      tr("Start over")) == Answer::cancel)
    return;
  if (controller_.isRunning() || !takeCheckpoint(resume)) return;  // events have passed meanwhile
  running_ = cases::writeCase(document_.description());
  resumed_ = resume;
  simulation::RunOptions options;
  options.threads = services_.threads;
  options.checkpointPath = checkpoint_.toStdString();
  options.resume = resume;
  inProject_ = keeper_->isOpen();
  unsavedFile_ = keeper_->nextResult(document_.name());
  controller_.start(document_.description(), document_.name().toStdString(), options,
                    [file = unsavedFile_](const results::RunResult& result) { keepResult(file, result); });
}

// Another window that computes this case writes its checkpoint: that run is not resumed here, and one that begins here
// keeps none.
bool MainWindow::takeCheckpoint(bool resume) {
  checkpoint_ = stopped_.file(document_.description());
  if (resume && !StoppedRuns::exists(checkpoint_)) return false;
  held_ = StoppedRuns::hold(checkpoint_);
  if (held_ || checkpoint_.isEmpty()) return true;
  const QString owner = StoppedRuns::owner(checkpoint_);
  checkpoint_.clear();
  showStopped();
  if (resume)
    messages_->warn(tr("Another window computes this case. Its run can be resumed once it is stopped there."), owner);
  else
    messages_->say(tr("Another window computes this case as well. If this run is stopped, it cannot be resumed."),
                   owner);
  return !resume;
}

void MainWindow::keep(const ResultPointer& result) {
  const auto kept = inProject_ ? nullptr : std::make_shared<KeptFile>(unsavedFile_);
  if (result->time.empty()) return;  // cancelled before the wheel rolled: there is nothing to keep
  if (ending_ && !result->complete) {
    part_ = result;  // kept where the window stays after all
    return;
  }
  if (result->complete) {
    held_.reset();
    if (unsavedFile_.isEmpty() || QFileInfo::exists(unsavedFile_))
      StoppedRuns::forget(checkpoint_);
    else
      messages_->warn(tr("The result could not be written to %1. Save it now: it is lost when the program ends.")
                          .arg(unsavedFile_));
  }
  // What a run had when it was stopped is a part of what it has now, as far as it reaches.
  for (int row = store_.rowCount() - 1; resumed_ && row >= 0; --row) {
    const StoredRun& run = store_.at(row);
    if (!run.isMeasured() && run.path.isEmpty() && !run.result->complete && run.result->caseHash == result->caseHash &&
        run.result->time.size() <= result->time.size())
      store_.remove(row);
  }
  const bool saved = inProject_ && result->complete && QFileInfo::exists(unsavedFile_);
  store_.add({result, QString(), saved ? unsavedFile_ : QString(), false, result, kept, false});
  if (keeper_->isOpen() && !inProject_ && result->complete) try {
      keepResults();  // the project was made while the run was under way
    } catch (const FileError& error) {
      messages_->warn(QString::fromStdString(error.what()));
    }
}

void MainWindow::showStopped() {
  const bool can = !controller_.isRunning() && stopped_.has(document_.description());
  run_->setStopped(can ? StoppedRuns::time(stopped_.file(document_.description())) : QDateTime());
  if (resumeAction_) resumeAction_->setEnabled(can);
  enableActions();
}

// What can do nothing now says so.
void MainWindow::enableActions() {
  const bool running = controller_.isRunning(), result = store_.currentResult() != nullptr;
  const bool figures = result || !store_.overlays().empty();
  const auto enable = [this](const char* name, bool on) {
    if (auto* action = findChild<QAction*>(name)) action->setEnabled(on);
  };
  for (const char* name : {"pauseAction", "cancelAction"}) enable(name, running);
  enable("closeProject", keeper_->isOpen());
  enable("restoreRun", store_.canRestore());
  const bool reading = result && store_.at(store_.current()).fields == Fields::inFile;  // the model, for a moment
  enable("saveResult", result);
  for (const char* name : {"modelPicture", "vtkSeries"}) enable(name, result && !reading);
  for (const char* name : {"copyFigure", "exportFigure"}) enable(name, figures);
  enable("report", result || !longRecords().events.empty());
  enable("exportAll", figures && !reading);
}

void MainWindow::setDark(bool dark) {
  if (darkAction_) darkAction_->setChecked(dark);
  applyTheme(dark);
  const plots::Style style = figureStyle(dark);
  profile_->setStyle(style);
  signals_->setStyle(style);
  previewPanel_->setStyle(style);
  run_->setStyle(style);
  scene_->setDark(dark);
  for (const auto& [name, window] : tools_) window->setStyle(style);
}

QStringList MainWindow::tabNames() {
  return QStringList{"profile", "model", "paper", "run", "runs"} + SignalsPanel::names() +
         QStringList{"preview", "comparison", "notes"};
}

bool MainWindow::showTab(const QString& name) {
  if (!tabNames().contains(name)) return false;
  if (name == "profile")
    middle_->setCurrentWidget(profile_);
  else if (name == "model")
    middle_->setCurrentWidget(scene_);
  else if (name == "paper")
    middle_->setCurrentWidget(paper_);
  else if (name == "notes")
    middle_->setCurrentWidget(notes_);
  else if (name == "run")
    runDock_->show(), runDock_->raise();
  else if (name == "runs")
    runsDock_->show(), runsDock_->raise();
  else if (name == "comparison")
    comparison_->show(), comparison_->raise(), comparison_->activateWindow();
  else if (name == "preview")
    signalsDock_->show(), signalsDock_->raise(), right_->setCurrentWidget(previewPanel_);
  else
    signalsDock_->show(), signalsDock_->raise(), right_->setCurrentWidget(signals_), signals_->showTab(name);
  return true;
}

// Cancels and waits. A part of a result goes with the window, as the question said; what is complete is kept.
void MainWindow::endRun() {
  ending_ = true;
  controller_.setPaused(false);
  controller_.cancel();
  constexpr int patience = 20000;  // [ms]: a run asks whether it is cancelled many times a second
  controller_.waitFor(patience);
  ending_ = false;
}

// Computing stops with the answer, not after the questions that may follow.
bool MainWindow::mayLeaveRun() {
  if (!controller_.isRunning()) return true;
  const QString fate = StoppedRuns::exists(checkpoint_) ? tr("It can be resumed when its case is opened again.")
                                                        : tr("Its results so far are discarded.");
  if (services_.asker(this, tr("A run is in progress. %1").arg(fate), tr("Stop it and close")) == Answer::cancel)
    return false;
  if (controller_.isRunning()) endRun();
  return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (closing_) return;  // events go on passing while a question stands or a run ends
  closing_ = true;
  const bool leave = mayLeaveRun() && mayLeaveTools() && mayLeaveWork();
  closing_ = false;
  const ResultPointer part = std::exchange(part_, nullptr);
  if (!leave && part) keep(part);
  if (!leave) return;
  keeper_->end();
  keepLayout();
  preview_.setHeld(true);
  event->accept();
}

// A run of this case may have begun or stopped in another window meanwhile.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange) showStopped();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) openAny(url.toLocalFile());
}

}  // namespace squat::studio
