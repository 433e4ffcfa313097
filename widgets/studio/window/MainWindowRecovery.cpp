// Work without a project in the main window: what a crash left, and the message about it.
#include <QTextDocument>
#include <QTimer>

#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {

// What a crash left. A case that is opened from the command line hides the message before anybody has seen it.
void MainWindow::recoverWork() {
  const auto recovered = keeper_->recover();
  if (recovered.work) showRecovered(*recovered.work, recovered.others);
  if (!recovered.problems.isEmpty()) messages_->warn(recovered.problems.join(' '));
  if (const QString said = messages_->text(); !said.isEmpty())
    QTimer::singleShot(0, this, [this, said] {
      if (messages_->text().isEmpty()) messages_->say(said);
    });
}

// Windows that were open come back once this one is there.
void MainWindow::showRecovered(const project::Project& work, int others) {
  startCase(work.open, projectProblems_);
  reader_->open(work, keeper_->untitledResults());
  showWork(work);
  notes_->document()->setModified(!work.notes.empty());
  QTimer::singleShot(0, this, [this, names = work.views] { showViews(names); });
  recoverySaid_ = tr("The program ended unexpectedly. Your work was recovered; save it as a project to keep it.");
  if (others > 0) recoverySaid_ += ' ' + tr("Start the program once more to recover the work of another window.");
  messages_->say(recoverySaid_, projectProblems_.join('\n'));
  connect(&document_, &CaseDocument::titleChanged, this, &MainWindow::hideSettledRecovery);
  connect(&store_, &RunStore::rowsRemoved, this, &MainWindow::hideSettledRecovery);
  connect(&store_, &RunStore::dataChanged, this, &MainWindow::hideSettledRecovery);
}

// Results that are still being read count as unsaved.
bool MainWindow::hasUnsavedWork() const {
  return hasUnsavedChanges() || reader_->isBusy() || !store_.unsaved().empty() || notes_->document()->isModified();
}

// Recovered results are read while the window is in use; only then can they be saved or discarded.
void MainWindow::waitForUnsaved() {
  constexpr int patience = 20000;  // [ms]
  for (int row = 0; row < store_.rowCount(); ++row)
    if (store_.at(row).opening && store_.at(row).kept) return void(reader_->waitFor(patience));
}

void MainWindow::hideSettledRecovery() {
  if (!recoverySaid_.isEmpty() && messages_->text() == recoverySaid_ && !hasUnsavedWork()) messages_->clear();
}

// Another case is open: a message about the one before goes, but not that recovered work is still to be saved.
void MainWindow::hideWordsOfOldCase() {
  if (messages_->text() != recoverySaid_ || !hasUnsavedWork()) messages_->clear();
}

}  // namespace squat::studio
