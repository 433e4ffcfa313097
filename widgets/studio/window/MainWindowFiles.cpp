// Files of the main window: opening, saving, asking.
#include <QFileInfo>
#include <algorithm>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "project/MeasuredRecords.h"
#include "results/ResultFile.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/project/RunReader.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/MainWindow.h"
#include "studio/window/RecentFiles.h"
#include "studio/window/Recovery.h"

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
    document_.startFrom(result->resolvedCase->description, QString(), label, false);
    profile_->plot()->fit();
    return true;
  } catch (const FileError& error) {
    messages_->warn(QString::fromStdString(error.what()));
  }
  return false;
}

void MainWindow::overlay(const QString& path, const readers::SignalFileOptions& options) {
  const ResultPointer current = store_.currentResult();
  const double speed = options.speed > 0 ? options.speed : document_.description().motion.speed;
  const auto records = project::measuredRecords(path.toStdString(), speed, {options, project::impactOf(current.get())});
  messages_->hide();
  QStringList notes;
  for (const auto& [record, reading] : records) {
    QString label = QFileInfo(path).completeBaseName();
    if (records.size() > 1) label += ": " + QString::fromStdString(record->run);
    StoredRun measured{nullptr, label, QFileInfo(path).absoluteFilePath(), true, record};
    measured.reading = reading;
    store_.add(std::move(measured));
    for (const auto& note : record->notes) notes << QString::fromStdString(note);
  }
  if (!notes.isEmpty()) messages_->say(sentence(notes[0]), notes.join('\n'));
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
  auto* dialog = new MeasuredDialog(
      path, messages_->text(),
      [this, path](const readers::SignalFileOptions& options) -> QString {
        try {
          overlay(path, options);
          return {};
        } catch (const std::exception& error) {
          return QString::fromStdString(error.what());
        }
      },
      this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

// One signal at a time: the figure can be dragged for one alone.
void MainWindow::alignByHand(int row) {
  if (row < 0 || row >= store_.rowCount() || !store_.at(row).isMeasured() || store_.at(row).isMissing()) return;
  delete align_;
  if (!store_.at(row).overlaid) store_.setData(store_.index(row), Qt::Checked, Qt::CheckStateRole);
  align_ = new AlignDialog(store_, row, this);
  align_->setAttribute(Qt::WA_DeleteOnClose);
  showTab("aba_position");
  signals_->setAligning(true);
  connect(signals_, &SignalsPanel::shifted, align_, &AlignDialog::shift);
  connect(align_, &QDialog::finished, signals_, [this] { signals_->setAligning(false); });
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
  if (messages_->text() == notSaved()) messages_->hide();
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

// Saves those results, or the user lets them go.
bool MainWindow::mayLeaveResults(const std::vector<ResultPointer>& results) {
  if (results.empty()) return true;
  const QString question = results.size() == 1
                               ? tr("The result “%1” is not saved.").arg(store_.at(store_.rowOf(results[0])).label)
                               : tr("%n results are not saved.", nullptr, static_cast<int>(results.size()));
  switch (services_.asker(this, question, tr("Discard"))) {
    case Answer::save:
      return std::all_of(results.begin(), results.end(), [this](const auto& result) { return saveResult(result); });
    case Answer::discard:
      return true;
    case Answer::cancel:
      break;
  }
  return false;
}

void MainWindow::removeRun(int row) {
  if (row < 0 || row >= store_.rowCount()) return;
  const auto unsaved = store_.unsaved();
  const ResultPointer result = store_.at(row).result;
  const bool lost = std::find(unsaved.begin(), unsaved.end(), result) != unsaved.end();
  if (!lost) return store_.remove(row);
  if (mayLeaveResults({result})) store_.remove(store_.rowOf(result));  // rows may have moved while the question stood
}

void MainWindow::hideSettledRecovery() {
  if (!caseRecovered_ && resultsRecovered_.empty()) return;  // it reports files that cannot be read
  if (messages_->text() != recoverySaid_ || (caseRecovered_ && document_.isModified())) return;
  if (!recoveredResultWaits()) messages_->hide();
}

bool MainWindow::recoveredResultWaits() const {
  const auto unsaved = store_.unsaved();
  return std::any_of(resultsRecovered_.begin(), resultsRecovered_.end(), [&](const auto& each) {
    return std::find(unsaved.begin(), unsaved.end(), each.lock()) != unsaved.end();
  });
}

// Another case is there: what is said of the one before goes, but not that a recovered result is still to be saved.
void MainWindow::hideWordsOfOldCase() {
  if (messages_->text() != recoverySaid_ || !recoveredResultWaits()) messages_->hide();
}

QString MainWindow::recoverCase() {
  const auto found = Recovery::take(services_.recoveryFolder);
  if (!found) return {};
  document_.startFrom(found->description, QString(), found->name, true);
  profile_->plot()->fit();
  caseRecovered_ = true;
  return tr("Unsaved changes to “%1” were recovered. Save them, or open another case to discard them.")
      .arg(found->name);
}

QString MainWindow::recoverResults() {
  int found = 0;
  QStringList unreadable;
  for (const QString& file : unsaved_.takeLeft()) try {
      auto result = std::make_shared<results::RunResult>(results::readResult(file.toStdString()));
      if (result->stem.empty()) result->stem = UnsavedResults::stemOf(file).toStdString();
      store_.add({result, UnsavedResults::stemOf(file) + tr(" (recovered)"), QString(), false, result,
                  std::make_shared<KeptFile>(file)});
      resultsRecovered_.push_back(result);
      ++found;
    } catch (const std::exception& error) {
      unreadable << tr("%1 (the unsaved result is kept as %2)")
                        .arg(QString::fromStdString(error.what()), UnsavedResults::putAside(file));
    }
  QStringList said;
  if (found == 1) said << tr("An unsaved result was recovered. Save it to keep it.");
  if (found > 1) said << tr("%1 unsaved results were recovered. Save those you want to keep.").arg(found);
  return (said + unreadable).join(' ');
}

}  // namespace squat::studio
