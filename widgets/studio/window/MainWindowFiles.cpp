// Files of the main window: opening, saving, asking.
#include <QFileInfo>
#include <algorithm>
#include <set>
#include <tuple>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "project/MeasuredRecords.h"
#include "results/ResultFile.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/document/ParameterForm.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/project/ProjectRuns.h"
#include "studio/project/RunReader.h"
#include "studio/runs/AlignCommand.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/AutomaticAlignment.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/MainWindow.h"
#include "studio/window/RecentFiles.h"

namespace squat::studio {
namespace {

QString allProblems(const CaseError& error) {
  QStringList lines;
  for (const auto& problem : error.problems()) lines << QString::fromStdString(toText(problem));
  return lines.join('\n');
}

QString notSaved() { return QObject::tr("The case was not saved: correct the marked values first."); }

QString sentence(QString note) {
  if (!note.isEmpty()) note[0] = note[0].toUpper();
  return note;
}

// By whatever name: links are followed.
bool isSameFile(const QString& one, const QString& other) {
  const QString file = QFileInfo(one).canonicalFilePath();
  return !file.isEmpty() && file == QFileInfo(other).canonicalFilePath();
}

// The row of a result file; -1: it is not listed.
int rowOfResult(const RunStore& store, const QString& path) {
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    const bool isRun = run.isMissing() ? run.link->kind == project::Kind::run : !run.isMeasured();
    if (isRun && isSameFile(run.path, path)) return row;
  }
  return -1;
}

// What its file holds now, in place of the listed one: name, colour and overlay stay.
void showAgain(RunStore& store, int row, const ResultPointer& result) {
  const StoredRun listed = store.at(row);
  StoredRun read{result, listed.label, listed.path};
  read.named = listed.named, read.colour = listed.colour;
  if (listed.isMissing()) {  // when its project was opened, or it is still to be read
    describe(read);
    store.fill({{row, read}});
  } else if (listed.result->caseHash == result->caseHash &&
             project::recordDigest(*listed.record) == project::recordDigest(*result)) {
    store.setResult(row, result, Fields::inMemory);
  } else {
    const bool isReference = store.chosenReference() == row;
    store.remove(row);
    row = store.add(std::move(read));
    if (listed.overlaid) store.setData(store.index(row), Qt::Checked, Qt::CheckStateRole);
    if (isReference) store.setReference(row);
  }
  store.setCurrent(row);
}

bool isSame(const readers::SignalFileOptions& one, const readers::SignalFileOptions& other) {
  const auto all = [](const readers::SignalFileOptions& of) {
    return std::tie(of.column, of.timeColumn, of.positionColumn, of.speedColumn, of.runColumn, of.object, of.rate,
                    of.speed, of.delimiter, of.decimal);
  };
  return all(one) == all(other);
}

bool isLaidAlike(const project::MeasuredReading& one, const project::MeasuredReading& other) {
  return one.impact == other.impact && one.gain == other.gain;
}

// The row of the same signal of the same file, read with the same choices or to the same values; -1: it is not listed.
// It may have been laid otherwise by hand since. A file may have several signals of one name: none of `taken`.
int rowOfSignal(const RunStore& store, const QString& path, const project::MeasuredRecord& read,
                const std::set<int>& taken) {
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    if (taken.contains(row) || !run.isMeasured() || !isSameFile(run.path, path)) continue;
    if (run.isMissing()) {
      if (run.link->signal == read.record->run && isSame(run.link->reading, read.reading.options)) return row;
      continue;
    }
    if (run.record->run != read.record->run) continue;
    const bool isOfThisGain = read.reading.gain == 1 || read.reading.gain == run.reading.gain;
    if ((isOfThisGain && isSame(run.reading.options, read.reading.options)) ||
        project::recordDigest(*run.record) == project::recordDigest(*read.record))
      return row;
  }
  return -1;
}

// What its file holds now, in place of the listed one, laid as that is; where it was hidden, it is overlaid again.
void showAgain(RunStore& store, int row, const project::MeasuredRecord& read) {
  const StoredRun listed = store.at(row);
  if (listed.isMissing()) {
    QString problem;
    const StoredRun found = openEntry(*listed.link, results::ResultContent::everything, problem);
    if (!found.record) return;
    store.fill({{row, found}});
  } else {
    const bool asRead = isLaidAlike(listed.reading, read.reading);
    const auto now = asRead ? read : project::realigned({listed.record, listed.reading}, listed.reading);
    if (project::recordDigest(*now.record) != project::recordDigest(*listed.record)) store.setMeasured(row, now);
  }
  if (!store.at(row).overlaid) store.setData(store.index(row), Qt::Checked, Qt::CheckStateRole);
}

// Returns what was assumed while they were read. Throws FileError where a file has gone meanwhile.
QStringList addMeasured(RunStore& store, const QString& path, const std::vector<project::MeasuredRecord>& records) {
  QStringList notes;
  std::set<int> rows;
  bool isNew = false;
  for (const auto& read : records) {
    if (const int row = rowOfSignal(store, path, read, rows); row >= 0) {
      showAgain(store, row, read);
      rows.insert(row);
      continue;
    }
    QString label = QFileInfo(path).completeBaseName();
    if (records.size() > 1) label += ": " + QString::fromStdString(read.record->run);
    StoredRun measured{nullptr, label, QFileInfo(path).absoluteFilePath(), true, read.record};
    measured.reading = read.reading;
    rows.insert(store.add(std::move(measured)));
    isNew = true;
    for (const auto& note : read.record->notes) notes << QString::fromStdString(note);
  }
  if (!isNew) notes << QObject::tr("already in the list: %1").arg(QFileInfo(path).fileName());
  return notes;
}

void report(MessageBar& messages, const QStringList& notes) {
  messages.clear();
  if (!notes.isEmpty()) messages.say(sentence(notes[0]), notes.join('\n'));
}

}  // namespace

bool MainWindow::openAny(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == "h5" || ending == "hdf5") return openResult(path);
  if (ending == "squat-project") return openProject(path);
  if (ending == "csv" || ending == "txt") {
    showTab("profile");
    profile_->importFile(path);
    return true;
  }
  return openCase(path);
}

bool MainWindow::openCase(const QString& nameOrPath) {
  if (!mayLeaveCase()) return false;
  try {
    document_.open(nameOrPath);
  } catch (const CaseError& error) {
    messages_->warn(error.problems().size() == 1
                        ? tr("“%1” cannot be opened: 1 error").arg(nameOrPath)
                        : tr("“%1” cannot be opened: %2 errors").arg(nameOrPath).arg(error.problems().size()),
                    allProblems(error));
    return false;
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  if (!document_.path().isEmpty()) listCase(document_.path());
  hideWordsOfOldCase();
  profile_->plot()->fit();
  return true;
}

void MainWindow::listCase(const QString& path) {
  addRecentFile(path);
  cases_.removeAll(path);
  cases_.prepend(path);
}

bool MainWindow::openResult(const QString& path) {
  try {
    auto result = std::make_shared<results::RunResult>(results::readResult(path.toStdString()));
    const QString label = QFileInfo(path).completeBaseName();
    if (result->stem.empty()) result->stem = label.toStdString();
    addRecentFile(path);
    if (const int row = rowOfResult(store_, path); row >= 0)
      showAgain(store_, row, result);
    else
      store_.add({result, label, QFileInfo(path).absoluteFilePath(), false});
    if (!result->notRead.empty())
      messages_->warn(tr("This version does not read all of %1: install the newer one to see the rest.").arg(path),
                      QString::fromStdString(result->notRead));
    if (result->caseToml.empty() || hasUnsavedChanges()) return true;
    // The case that made the result, to be looked at and changed.
    if (!result->resolvedCase) {
      messages_->warn(tr("The case stored in %1 cannot be read by this version; only its results are shown.").arg(path),
                      QString::fromStdString(result->caseProblem));
      return true;
    }
    showCaseOf(*result, label);
    return true;
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
  }
  return false;
}

void MainWindow::showCaseOf(const results::RunResult& result, const QString& name) {
  document_.startFrom(result.resolvedCase->description, QString(), name, false);
  profile_->plot()->fit();
}

void MainWindow::openCaseOf(int row) {
  const ResultPointer result = store_.at(row).result;
  if (!result || !result->resolvedCase || !mayLeaveCase()) return;
  const int at = store_.rowOf(result);  // rows may have moved while the question stood
  hideWordsOfOldCase();
  showCaseOf(*result, at < 0 ? QString::fromStdString(result->stem) : store_.at(at).label);
}

void MainWindow::overlay(const QString& path, const readers::SignalFileOptions& options) {
  const ResultPointer current = store_.currentResult();
  const double speed = options.speed > 0 ? options.speed : document_.description().motion.speed;
  const auto records =
      project::measuredRecords(path.toStdString(), speed, {.options = options, .isAutomatic = true}, current.get());
  report(*messages_, addMeasured(store_, path, records));
}

bool MainWindow::openMeasured(const QString& path) {
  try {
    overlay(path, {});
    return true;
  } catch (const std::exception& error) {
    messages_->warn(QString::fromStdString(error.what()));
  }
  return false;
}

void MainWindow::askHowToRead(const QString& path) {
  auto* dialog = new MeasuredDialog({path.toStdString(),
                                     {.options = {}, .isAutomatic = true},
                                     document_.description().motion.speed,
                                     {},
                                     store_.currentResult()},
                                    figureStyle(requestedDark()), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
    try {
      report(*messages_, addMeasured(store_, path, dialog->records()));
    } catch (const std::exception& error) {
      messages_->warn(QString::fromStdString(error.what()));
    }
  });
  hideWordsOfOldCase();  // why the file could not be read stands in the dialog
  dialog->open();
}

// One signal at a time: the figure can be dragged for one alone.
void MainWindow::alignByHand(int row) {
  if (row < 0 || row >= store_.rowCount() || !store_.at(row).isMeasured() || store_.at(row).isMissing()) return;
  if (align_) align_->close();
  delete align_;
  if (!store_.at(row).overlaid) store_.setData(store_.index(row), Qt::Checked, Qt::CheckStateRole);
  align_ = new AlignDialog(store_, row, this);
  align_->setAttribute(Qt::WA_DeleteOnClose);
  showTab("aba_position");
  signals_->setAligning(true);
  connect(signals_, &SignalsPanel::shifted, align_, &AlignDialog::shift);
  connect(align_, &AlignDialog::aligned, this, [this](int aligned, const project::MeasuredRecord& before) {
    document_.undoStack().push(new AlignCommand(store_, aligned, before));
  });
  connect(align_, &QDialog::finished, signals_, [this] {
    signals_->setAligning(false);
    alignWithCurrent(store_);  // the others have waited
  });
  align_->show();
}

bool MainWindow::hasUnsavedChanges() const { return document_.isModified() || !form_->refusals().isEmpty(); }

// The case would be saved with the value before, which is not the one on the screen.
bool MainWindow::isTaken() {
  const QStringList refused = form_->refusals();
  if (refused.isEmpty()) return true;
  messages_->warn(notSaved(), refused.join('\n'));
  return false;
}

bool MainWindow::saveCaseTo(const QString& path) {
  if (!isTaken()) return false;
  try {
    document_.save(path);
  } catch (const CaseError& error) {
    messages_->warn(notSaved(), allProblems(error));
    return false;
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  if (messages_->text() == notSaved()) messages_->clear();
  listCase(document_.path());
  return true;
}

bool MainWindow::saveCase() {
  takeWhatIsTyped();
  return document_.path().isEmpty() ? saveCaseAs() : saveCaseTo(document_.path());
}

bool MainWindow::saveCaseAs() {
  takeWhatIsTyped();
  if (!isTaken()) return false;
  const QString path = locationToSave(this, tr("Save case"), document_.name() + ".toml", tr("Cases (*.toml)"));
  return !path.isEmpty() && saveCaseTo(path);
}

// Rows move while a dialog stands and runs end: the result itself is what is meant.
bool MainWindow::saveResult(const ResultPointer& result) {
  const int asked = store_.rowOf(result);
  if (asked < 0) return false;
  const QString path = locationToSave(this, tr("Save result “%1”").arg(store_.at(asked).label),
                                      QString::fromStdString(result->stem) + ".h5", tr("Results (*.h5)"));
  return !path.isEmpty() && saveResultTo(store_.rowOf(result), path);
}

bool MainWindow::saveRun(int row) {
  if (row < 0) return false;
  try {
    return saveResult(reader_->wholeResult(row));
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
}

bool MainWindow::saveResultTo(int row, const QString& path) {
  if (row < 0 || row >= store_.rowCount()) return false;
  try {
    results::writeResult(path.toStdString(), *reader_->wholeResult(row));
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
    return false;
  }
  store_.setPath(row, QFileInfo(path).absoluteFilePath());
  addRecentFile(path);
  // What could not be kept by itself has its checkpoint still.
  const auto& result = *store_.at(row).result;
  const QString checkpoint = stopped_.file(result.caseHash);
  if (result.complete && !(controller_.isRunning() && checkpoint == checkpoint_)) StoppedRuns::forget(checkpoint);
  showStopped();
  return true;
}

bool MainWindow::mayLeaveCase() {
  takeWhatIsTyped();
  if (!hasUnsavedChanges()) return true;
  switch (services_.asker(this, tr("“%1” has unsaved changes.").arg(document_.name()), tr("Discard"))) {
    case Answer::save:
      return saveCase();
    case Answer::discard:
      return true;
    case Answer::cancel:
      break;
  }
  return false;
}

void MainWindow::removeRun(int row) {
  if (row < 0 || row >= store_.rowCount()) return;
  const QString name = store_.at(row).label;
  const bool canComeBack = !store_.at(row).opening;
  store_.putAside(row);
  if (canComeBack)
    messages_->say(tr("“%1” was removed from the list. Edit > Restore run (Ctrl+Alt+Z) brings it back.").arg(name));
}

void MainWindow::restoreRun() {
  const int row = store_.restore();
  if (row >= 0) messages_->say(tr("“%1” is in the list again.").arg(store_.at(row).label));
}

}  // namespace squat::studio
