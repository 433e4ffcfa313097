// The project in the main window: what it holds, opening, saving, copying, and what is asked before work is left.
#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>
#include <QMenu>
#include <QProgressDialog>
#include <QSettings>
#include <QTabWidget>
#include <QTextDocument>
#include <algorithm>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "plots/FigureFiles.h"
#include "plots/ReportPages.h"
#include "project/ProjectFile.h"
#include "results/ResultFile.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/MessageBar.h"
#include "studio/common/WorkFolder.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/model/ScenePanel.h"
#include "studio/preview/PreviewPanel.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/ProjectRuns.h"
#include "studio/project/RecordWatch.h"
#include "studio/project/RunReader.h"
#include "studio/project/StoreReport.h"
#include "studio/records/RecordView.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolTabs.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/MainWindow.h"
#include "studio/window/RecentFiles.h"

namespace squat::studio {
namespace {

constexpr const char* lastProject = "project";  // in the settings
constexpr const char* recordsTool = "squats";   // the window of long records

QString projectKinds() { return QObject::tr("Projects (*.squat-project)"); }

}  // namespace

void MainWindow::makeProject() {
  connect(keeper_, &ProjectKeeper::failed, messages_, [this](const QString& text) { messages_->warn(text); });
  const auto soon = [this] { keeper_->saveSoon(); };
  connect(&document_, &CaseDocument::changed, this, soon);
  connect(&document_, &CaseDocument::titleChanged, this, soon);
  connect(&store_, &RunStore::rowsInserted, this, [this] { keeper_->saveSoon(0); });  // a run has ended
  connect(&store_, &RunStore::rowsRemoved, this, soon);
  connect(&store_, &RunStore::dataChanged, this, soon);
  connect(&store_, &RunStore::currentChanged, this, soon);
  connect(&store_, &RunStore::overlaysChanged, this, soon);
  connect(&store_, &RunStore::namesChanged, this, soon);
  connect(&store_, &RunStore::referenceChanged, this, soon);
  connect(reader_, &RunReader::progressed, this, [this](int read, int all) {
    runsDock_->setWindowTitle(read < all ? tr("Runs (reading %1 of %2)").arg(read + 1).arg(all) : tr("Runs"));
  });
  connect(reader_, &RunReader::finished, this, [this](const QStringList& problems) {
    projectProblems_ += problems;
    if (!problems.isEmpty()) showProjectProblems();
  });
  connect(reader_, &RunReader::failed, messages_, [this](const QString& text) { messages_->warn(text); });
  connect(recordWatch_, &RecordWatch::looked, this, soon);
  connect(recordWatch_, &RecordWatch::changed, this, [this](const QString& problem) {
    projectProblems_ << problem;
    showProjectProblems();
  });
  connect(runs_, &RunsPanel::orderChanged, this, soon);
  connect(runs_, &RunsPanel::findRequested, this, &MainWindow::findMissing);
  connect(notes_, &QPlainTextEdit::textChanged, this, soon);
  connect(middle_, &QTabWidget::currentChanged, this, soon);
  connect(right_, &QTabWidget::currentChanged, this, soon);
  connect(signals_, &SignalsPanel::tabChanged, this, soon);
  connect(signals_, &SignalsPanel::choicesChanged, this, soon);
  connect(findChild<QAction*>("squatsAction"), &QAction::triggered, this, &MainWindow::watchRecords);
  connect(keeper_, &ProjectKeeper::openChanged, findChild<QAction*>("copyProject"), &QAction::setEnabled);
  connect(keeper_, &ProjectKeeper::copyEnded, this, &MainWindow::showCopy);
}

void MainWindow::keepRecords() {
  recordWatch_->follow(longRecords().files);
  keeper_->saveSoon();
  enableActions();  // a report may have events now
}

void MainWindow::makeProjectActions(QMenu& menu) {
  const auto add = [&](const QString& text, const QKeySequence& keys, const char* name, auto action) {
    QAction* made = menu.addAction(text, this, action);
    made->setShortcut(keys);
    made->setObjectName(name);
  };
  menu.addSeparator();
  add(tr("Open &project…"), QKeySequence("Ctrl+Alt+O"), "openProject", [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a project"), QString(), projectKinds());
    if (!path.isEmpty()) openProject(path);
  });
  add(tr("Save pro&ject as…"), QKeySequence("Ctrl+Alt+S"), "saveProject", [this] { saveProjectAs(); });
  add(tr("Save a copy with its &data…"), QKeySequence("Ctrl+Alt+B"), "copyProject", [this] { copyProject(); });
  findChild<QAction*>("copyProject")->setEnabled(false);
  add(tr("Close projec&t"), QKeySequence("Ctrl+Alt+W"), "closeProject", [this] { closeProject(); });
  menu.addSeparator();
}

QStringList MainWindow::shownTabs() const {
  QStringList names;
  const QWidget* middle = middle_->currentWidget();
  names << (middle == scene_ ? "model" : middle == paper_ ? "paper" : middle == notes_ ? "notes" : "profile");
  names << (right_->currentWidget() == previewPanel_ ? QString("preview") : signals_->currentTab());
  if (comparison_->isVisible()) names << "comparison";
  if (const ToolWindow* records = recordsWindow(); records && toolTabs_->isOpen(*records)) names << recordsTool;
  return names;
}

project::Project MainWindow::work() const {
  project::Project project;
  project.open = {document_.name().toStdString(), document_.path().toStdString(), document_.isModified(),
                  cases::writeCase(document_.description())};
  for (const QString& path : cases_) project.cases.push_back(path.toStdString());
  listRuns(store_, project);
  project.notes = notes_->toPlainText().toStdString();
  for (const QString& name : shownTabs()) project.views.push_back(name.toStdString());
  project.figures = signals_->views();
  project.records = longRecords();
  project.records.digests = recordWatch_->digestsOf(project.records.files);
  project.runOrder = runs_->order();
  return project;
}

// Null before it is first asked for.
ToolWindow* MainWindow::recordsWindow() const {
  const auto found = tools_.find(recordsTool);
  return found == tools_.end() ? nullptr : found->second;
}

project::LongRecords MainWindow::longRecords() const {
  const ToolWindow* window = recordsWindow();
  const auto* form = window ? qobject_cast<DetectionForm*>(window->form()) : nullptr;
  return form ? form->choices() : project::LongRecords();
}

// What is typed and found in the window of long records is a part of the project.
void MainWindow::watchRecords() {
  const auto* form = qobject_cast<DetectionForm*>(tool(recordsTool)->form());
  connect(form, &DetectionForm::choicesChanged, this, &MainWindow::keepRecords, Qt::UniqueConnection);
  connect(form, &DetectionForm::searchStarted, recordWatch_, &RecordWatch::lookAgain, Qt::UniqueConnection);
}

// In place of what the window of long records holds; its files are read when it is first seen. The next search writes
// where this list is, or beside the project: not over the list of another one.
void MainWindow::showRecords(const project::LongRecords& kept) {
  if (kept.files.empty() && !recordsWindow()) return;
  watchRecords();
  qobject_cast<DetectionForm*>(recordsWindow()->form())->setChoices(kept);
  recordWatch_->open(kept);
  const QDir beside = workFolder(keeper_->path(), document_.path());
  const QString usual = beside.filePath((keeper_->isOpen() ? keeper_->name() : document_.name()) + "-squats");
  recordsWindow()->setFolder(kept.events.empty() ? usual : QFileInfo(QString::fromStdString(kept.events)).path());
  if (kept.files.empty()) return;
  auto files = kept.files;
  files.insert(files.end(), {kept.labels, kept.events});
  for (const auto& file : files)
    if (const QString path = QString::fromStdString(file); !path.isEmpty() && !QFileInfo(path).isReadable())
      projectProblems_ << tr("%1 is missing, or cannot be read").arg(path);
}

// A search writes its list into the project that is open when it ends.
bool MainWindow::recordsAreBusy() {
  const ToolWindow* window = recordsWindow();
  if (!window || !window->isBusy()) return false;
  messages_->warn(tr("A search for squats in records is in progress. Wait for it, or cancel it."));
  return true;
}

bool MainWindow::openProject(const QString& path) {
  if (recordsAreBusy() || !mayLeaveWork()) return false;
  project::Project project;
  try {
    project = project::readProject(path.toStdString());
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  QString other;
  if (!keeper_->take(path, &other)) {
    messages_->warn(tr("%1 is open in another window: %2. Close it there first.").arg(path, other));
    return false;
  }
  keeper_->dropUntitled();
  run_->clear();
  projectProblems_.clear();
  startCase(project.open, projectProblems_);
  reader_->open(project);
  showProject(project);
  return true;
}

// The case as it was, whatever has become of its file since.
void MainWindow::startCase(const project::OpenCase& open, QStringList& problems) {
  const auto description = cases::parseUnfinishedCase(open.toml, open.name);
  QString path = QString::fromStdString(open.path);
  bool modified = open.modified;
  if (!path.isEmpty()) try {
      const bool same = sameCase(cases::readCase(open.path), description);
      if (!same && !open.modified)
        problems << tr("%1 has changed since; the case of the project is shown, and not saved there.").arg(path);
      modified = !same;
    } catch (const std::exception& error) {
      problems << QString::fromStdString(error.what());
      path.clear();
      modified = true;
    }
  document_.startFrom(description, path, QString::fromStdString(open.name), modified);
  profile_->plot()->fit();
}

void MainWindow::showWork(const project::Project& project) {
  cases_.clear();
  for (const auto& path : project.cases) cases_ << QString::fromStdString(path);
  notes_->setNotes(QString::fromStdString(project.notes));
  if (project.figures) {
    const bool isRun = project.current >= 0;
    const std::string run = isRun ? project.entries.at(static_cast<std::size_t>(project.current)).path : std::string();
    signals_->setViews(*project.figures, QString::fromStdString(run));
  }
  showRecords(project.records);
  runs_->setOrder(project.runOrder);
}

void MainWindow::showViews(const std::vector<std::string>& names) {
  for (const auto& name : names)
    if (!showTab(QString::fromStdString(name)) && name == recordsTool) showTool(recordsTool);
}

void MainWindow::showProject(const project::Project& project) {
  showWork(project);
  showViews(project.views);
  messages_->clear();
  showProjectProblems();
  addRecentFile(keeper_->path());
  QSettings().setValue(lastProject, keeper_->path());
  showTitle();
  enableActions();
  keeper_->saveSoon();
}

void MainWindow::showProjectProblems() {
  const auto count = projectProblems_.size();
  if (count > 0)
    messages_->warn(count == 1 ? tr("1 file of the project is missing or has changed.")
                               : tr("%1 files of the project are missing or have changed.").arg(count),
                    projectProblems_.join('\n'));
}

// Rows may move while the dialog stands: the run itself is what is meant.
void MainWindow::findMissing(int row) {
  const StoredRun lost = store_.at(row);
  const QString path = QFileDialog::getOpenFileName(this, tr("Find the file of “%1”").arg(lost.label),
                                                    QFileInfo(lost.path).absolutePath(), tr("All files (*)"));
  row = store_.rowOfRecord(lost.record);
  if (path.isEmpty() || row < 0) return;
  project::Entry entry = *lost.link;
  entry.path = QFileInfo(path).absoluteFilePath().toStdString();
  QString problem;
  StoredRun found = openEntry(entry, results::ResultContent::withoutFields, problem);
  messages_->clear();
  if (!problem.isEmpty()) messages_->warn(problem);
  if (!found.record) return;
  store_.setPath(row, QString::fromStdString(entry.path));
  store_.fill({{row, found}});
  if (store_.current() < 0 && !store_.at(row).isMeasured()) store_.setCurrent(row);
}

void MainWindow::openLastProject() {
  const QString path = QSettings().value(lastProject).toString();
  if (path.isEmpty() || hasUnsavedWork() || store_.rowCount() > 0) return;
  if (!openProject(path)) QSettings().remove(lastProject);
}

bool MainWindow::saveProjectAs() {
  takeWhatIsTyped();
  const QString name = keeper_->isOpen() ? keeper_->name() : document_.name();
  const QString path = locationToSave(this, tr("Save project"), name + ".squat-project", projectKinds());
  return !path.isEmpty() && saveProjectTo(path);
}

bool MainWindow::saveProjectTo(const QString& path) {
  QString other;
  if (!keeper_->take(path, &other)) {
    messages_->warn(tr("%1 is open in another window: %2. Choose another name.").arg(path, other));
    return false;
  }
  try {
    keepResults();
    keeper_->saveNow();
  } catch (const FileError& error) {
    keeper_->release();
    showTitle();
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  notes_->document()->setModified(false);
  addRecentFile(keeper_->path());
  QSettings().setValue(lastProject, keeper_->path());
  showTitle();
  enableActions();
  return true;
}

bool MainWindow::copyProject() {
  takeWhatIsTyped();
  const QString path =
      locationToSave(this, tr("Save a copy with its data"), keeper_->name() + "-copy.squat-project", projectKinds());
  return !path.isEmpty() && copyProjectTo(path);
}

bool MainWindow::copyProjectTo(const QString& path) {
  if (!keeper_->isOpen() || keeper_->isCopying()) {
    messages_->warn(keeper_->isOpen() ? tr("A copy of the project is being written. Wait for it, or cancel it.")
                                      : tr("Save the project first: its files are copied."));
    return false;
  }
  try {
    keepResults();
    keeper_->copyTo(path);
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  constexpr int patience = 1000;  // [ms] before it is shown
  auto* progress = new QProgressDialog(tr("Copying the project with its data"), tr("Cancel"), 0, 1000, this);
  progress->setMinimumDuration(patience);
  progress->setAutoReset(false);
  progress->setValue(0);
  connect(progress, &QProgressDialog::canceled, keeper_, &ProjectKeeper::cancelCopy);
  connect(keeper_, &ProjectKeeper::copyProgressed, progress,
          [progress](double fraction) { progress->setValue(static_cast<int>(1000 * fraction)); });
  connect(keeper_, &ProjectKeeper::copyEnded, progress, &QObject::deleteLater);
  return true;
}

void MainWindow::showCopy(const QString& said, const QStringList& problems) {
  const QString missing = problems.size() == 1 ? tr("1 file is missing from the copy.")
                                               : tr("%1 files are missing from the copy.").arg(problems.size());
  if (!problems.isEmpty())
    messages_->warn(said + ' ' + missing, problems.join('\n'));
  else if (!said.isEmpty())
    messages_->say(said);
}

// The window closes: a copy that is being written is stopped, or the user stays.
bool MainWindow::mayLeaveCopy() {
  if (!keeper_->isCopying()) return true;
  if (services_.asker(this, tr("A copy of the project is being written."), tr("Stop it and close")) == Answer::cancel)
    return false;
  constexpr int patience = 20000;  // [ms]: it asks whether it is cancelled after every few megabytes
  keeper_->cancelCopy();
  keeper_->waitForCopy(patience);
  return true;
}

bool MainWindow::saveReport() {
  const QString path = locationToSave(this, tr("Save report"), reportTitle() + ".pdf", tr("PDF (*.pdf)"));
  return !path.isEmpty() && saveReportTo(path);
}

QString MainWindow::reportTitle() const {
  if (keeper_->isOpen()) return keeper_->name();
  return store_.current() < 0 ? document_.name() : store_.at(store_.current()).label;
}

bool MainWindow::saveReportTo(const QString& path) {
  const bool hasRun = store_.current() >= 0;
  const auto records = longRecords();
  if (!hasRun && records.events.empty()) return false;
  const bool letter = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  std::vector<std::string> problems;
  QString failure;
  try {
    const auto shown = hasRun ? reader_->wholeResult(store_.current()) : ResultPointer();
    auto report = reportOf(store_, shown, reportTitle(), notes_->toPlainText());
    project::addEvents(records, report, problems);
    const auto page = letter ? plots::PageFormat::letter : plots::PageFormat::a4;
    plots::writeWhole(plots::reportPdf(report, {page, {}, signals_->colourMap()}, problems), path.toStdString());
  } catch (const std::exception& error) {  // the cursor must not stay a clock
    failure = QString::fromStdString(error.what());
  }
  QGuiApplication::restoreOverrideCursor();
  if (!failure.isEmpty()) {
    messages_->warn(failure);
    return false;
  }
  QStringList lines;
  for (const auto& problem : problems) lines << QString::fromStdString(problem);
  const QString said = tr("Report written to %1.").arg(path);
  if (lines.isEmpty())
    messages_->say(said);
  else
    messages_->say(tr("%1 Not all could be computed or drawn.").arg(said), lines.join('\n'));
  return true;
}

void MainWindow::keepResults() {
  waitForUnsaved();
  for (int row = 0; row < store_.rowCount(); ++row) {
    if (store_.at(row).isMeasured() || !store_.at(row).path.isEmpty()) continue;
    const ResultPointer result = reader_->wholeResult(row);
    const QString file = keeper_->nextResult(QString::fromStdString(result->stem));
    results::writeResult(file.toStdString(), *result);
    store_.setPath(row, file);
  }
}

bool MainWindow::keepProject() {
  try {
    keepResults();
    keeper_->saveNow();
    return true;
  } catch (const FileError& error) {
    const QString question = tr("The project could not be saved: %1").arg(QString::fromStdString(error.what()));
    return services_.asker(this, question, tr("Discard")) == Answer::discard;
  }
}

bool MainWindow::closeProject() {
  if (recordsAreBusy() || !mayLeaveWork()) return false;
  keeper_->release();
  QSettings().remove(lastProject);
  reader_->open({});
  run_->clear();
  document_.startNew();
  showRecords({});
  runs_->setOrder({});
  profile_->plot()->fit();
  cases_.clear();
  notes_->setNotes({});
  messages_->clear();
  showTitle();
  enableActions();
  return true;
}

// A run may end while the question stands: what it adds is asked for as well.
bool MainWindow::mayLeaveWork() {
  if (closing_ && !mayLeaveCopy()) return false;
  waitForUnsaved();
  std::vector<ResultPointer> asked;
  bool caseAsked = false, notesAsked = false;
  for (;;) {
    takeWhatIsTyped();
    if (keeper_->isOpen() && form_->refusals().isEmpty()) return keepProject();
    std::vector<ResultPointer> fresh;
    for (const auto& result : store_.unsaved())
      if (std::find(asked.begin(), asked.end(), result) == asked.end()) fresh.push_back(result);
    const bool ofCase = !caseAsked && hasUnsavedChanges();
    const bool ofNotes = !notesAsked && !keeper_->isOpen() && notes_->document()->isModified();
    QStringList sentences;
    if (ofCase) sentences << tr("“%1” has unsaved changes.").arg(document_.name());
    if (fresh.size() == 1)
      sentences << tr("The result “%1” is not saved.").arg(store_.at(store_.rowOf(fresh[0])).label);
    if (fresh.size() > 1) sentences << tr("%1 results are not saved.").arg(fresh.size());
    if (ofNotes) sentences << tr("The notes are not saved.");
    if (sentences.isEmpty()) return true;
    const Answer answer = services_.asker(this, sentences.join(' '), tr("Discard"));
    if (answer == Answer::cancel || (answer == Answer::save && !saveWork(ofCase, fresh, ofNotes))) return false;
    asked.insert(asked.end(), fresh.begin(), fresh.end());
    caseAsked = notesAsked = true;
  }
}

// One thing goes where the user says; several go into a project, which asks for one place.
bool MainWindow::saveWork(bool ofCase, const std::vector<ResultPointer>& results, bool ofNotes) {
  if (ofCase && results.empty() && !ofNotes) return saveCase();
  if (!ofCase && results.size() == 1 && !ofNotes) return saveResult(results[0]);
  return isTaken() && saveProjectAs();
}

}  // namespace squat::studio
