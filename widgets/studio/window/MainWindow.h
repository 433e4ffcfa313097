// widgets/studio/window/MainWindow.h - the studio's window: it puts the parts together and knows files, nothing more.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <map>

#include "readers/SignalFile.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/ShownCase.h"
#include "studio/preview/PreviewController.h"
#include "studio/runs/RunController.h"
#include "studio/runs/RunStore.h"
#include "studio/runs/StoppedRuns.h"
#include "studio/window/PaperPanel.h"

class QDockWidget;
class QMenu;
class QTabWidget;

namespace squat::studio {

class AlignDialog;
class ComparisonWindow;
class HelpWindow;
class JobsButton;
class MessageBar;
class NotesPanel;
class ParameterForm;
class PreviewPanel;
class ProfileEditor;
class ProjectKeeper;
class QuickTour;
class RecordWatch;
class RunReader;
class RunPanel;
class RunsPanel;
class ScenePanel;
class SignalsPanel;
class ToolTabs;
class ToolWindow;

enum class Answer { save, discard, cancel };
// Asks what to do with unsaved changes (or a run in progress); tests answer without a window.
using Asker = std::function<Answer(QWidget*, const QString& question, const QString& discardText)>;

struct StudioServices {
  Runner runner;
  Comparison comparison;
  PreviewSolver preview;   // empty: no previews
  Asker asker;             // empty: a message box
  QString recoveryFolder;  // of untitled projects; empty: work without a project is not kept
  QString runsFolder;      // of runs that were stopped; empty: none
  int threads = 0;         // of a run; 0: all cores (the window goes first all the same)
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  static constexpr QSize usualSize{1500, 920};  // where the screen has room for it
  static constexpr QSize smallestSize{1000, 680};
  explicit MainWindow(StudioServices services, QWidget* parent = nullptr);
  ~MainWindow() override;

  CaseDocument& document() { return document_; }
  RunController& controller() { return controller_; }
  PreviewController& preview() { return preview_; }
  RunStore& store() { return store_; }
  ProfileEditor* profile() const { return profile_; }
  ParameterForm* form() const { return form_; }
  SignalsPanel* signalsPanel() const { return signals_; }
  PreviewPanel* previewPanel() const { return previewPanel_; }
  ScenePanel* scene() const { return scene_; }
  ComparisonWindow* comparison() const { return comparison_; }
  MessageBar* messages() const { return messages_; }

  // A case, a result or the name of a shipped case. False, with a message in the window, where it cannot be opened.
  bool openAny(const QString& path);
  bool openCase(const QString& nameOrPath);
  bool openResult(const QString& path);
  bool openMeasured(const QString& path);
  void askHowToRead(const QString& path);  // a measured file that does not say so itself
  void alignByHand(int row);               // a measured signal
  bool openProject(const QString& path);
  void openLastProject();  // the one that was open when the program ended, unless there is work already
  bool saveProjectAs();    // asks for a place
  bool saveProjectTo(const QString& path);
  bool copyProject();  // with its data; asks for a location
  bool copyProjectTo(const QString& path);
  bool closeProject();  // saves it; a new case and an empty list follow
  bool saveReport();    // asks for a place
  bool saveReportTo(const QString& path);
  ProjectKeeper* keeper() const { return keeper_; }
  RunReader* reader() const { return reader_; }
  NotesPanel* notes() const { return notes_; }
  ToolWindow* tool(const QString& name);  // "study", "squats", ...; made when it is first asked for
  ToolTabs* toolTabs();                   // that hold them; made with the first one
  bool saveCase();
  bool saveCaseAs();
  bool saveCaseTo(const QString& path);
  bool saveResult(const ResultPointer& result);  // asks for a place
  bool saveRun(int row);                         // the same, with the fields that are in its file alone
  bool saveResultTo(const QString& path) { return saveResultTo(store_.current(), path); }
  bool saveResultTo(int row, const QString& path);
  void startRun() { beginRun(false); }
  void resumeRun() { beginRun(true); }  // with the one of this case that was stopped
  void resetLayout();                   // docks, handles and tools as at the first start
  void showTour();
  void offerTour();  // at the first start
  void setDark(bool dark);
  // "profile", "model", "paper" (the tab "Summary"), "notes", "run", "runs", "preview", "comparison" (a window of its
  // own), or one of the signals panel's; false for another name.
  bool showTab(const QString& name);
  static QStringList tabNames();

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeParts();
  void makeDocks();
  void divideRoom();
  void takeLayout();  // of the settings
  void keepLayout();
  bool signalsAreBeside() const;  // at the right, not hidden
  void shareWidth();
  void connectParts();
  void connectPreview();
  void offerPreview();
  void makeFileMenu();
  void makeProjectActions(QMenu& menu);
  void makeEditMenu();
  void makeRunMenu();
  void makeViewMenu();
  void makeFigureMenu();
  void makeHelpMenu();
  void fillRecentMenu();
  void showTitle();
  QString helpOfFocus() const;
  void showHelp();
  void showShownCase();  // where the result that is shown is not of the case that is open
  void takeWhatIsTyped();
  bool hasUnsavedChanges() const;  // of the case, also those that the form could not take
  bool isTaken();                  // all that is typed; else says what is not, and that nothing is saved
  bool mayLeaveCase();             // saves, or the user lets the changes go
  bool mayLeaveWork();             // case, results and notes with one question; none where the project keeps them
  bool saveWork(bool ofCase, const std::vector<ResultPointer>& results, bool ofNotes);
  void removeRun(int row);
  void restoreRun();
  void showCaseOf(const results::RunResult& result, const QString& name);
  void openCaseOf(int row);  // of a run, to be looked at and changed
  void beginRun(bool resume);
  bool takeCheckpoint(bool resume);  // of the open case, for the run that begins; false: it cannot be resumed
  void keep(const ResultPointer& result);
  void showStopped();
  void enableActions();
  void endRun();
  bool mayLeaveRun();  // stops it, or the user stays
  void makeToolActions(QMenu& menu);
  void showTool(const QString& name);
  void showJobs();
  bool mayLeaveTools();  // stops what they compute, or the user stays
  void recoverWork();
  void showRecovered(const project::Project& work, int others);
  void hideSettledRecovery();  // once what was recovered is saved or let go
  bool hasUnsavedWork() const;
  void hideWordsOfOldCase();
  void overlay(const QString& path, const readers::SignalFileOptions& options);  // throws
  void makeProject();
  project::Project work() const;
  project::LongRecords longRecords() const;
  void showRecords(const project::LongRecords& kept);
  void watchRecords();
  ToolWindow* recordsWindow() const;
  bool recordsAreBusy();  // which is said
  void keepRecords();     // in an open project, once nothing has changed for a moment
  void showCopy(const QString& said, const QStringList& problems);
  bool mayLeaveCopy();
  void listCase(const QString& path);
  void waitForUnsaved();
  void keepResults();         // all of them in files of the project; throws FileError
  void findMissing(int row);  // asks where its file is now
  bool keepProject();         // saves it whole, or the user lets go what cannot be saved
  void showProject(const project::Project& project);
  void showWork(const project::Project& work);  // notes, figures, records; its case and runs apart
  void showViews(const std::vector<std::string>& names);
  void showProjectProblems();  // files that are missing or have changed
  void startCase(const project::OpenCase& open, QStringList& problems);
  QStringList shownTabs() const;
  QString reportTitle() const;
  void setNarrow(bool narrow);
  QWidget* showForm();  // brings it to the front; returns what holds it
  QDockWidget* addDock(const QString& name, const QString& title, QWidget* inside, Qt::DockWidgetArea area);

  StudioServices services_;
  CaseDocument document_;
  RunStore store_;
  std::unique_ptr<platform::FileLock> held_;  // on the checkpoint; outlives the run
  RunController controller_;
  PreviewController preview_;
  StoppedRuns stopped_;
  QString checkpoint_;      // of the run in progress; empty: it keeps none
  QString unsavedFile_;     // where its result is kept
  bool inProject_ = false;  // that file is one of the project
  ResultPointer part_;      // of the run that was stopped to close the window
  std::string running_;     // the case of that run
  bool resumed_ = false;    // the run in progress
  MessageBar* messages_;
  JobsButton* jobs_;
  QPointer<HelpWindow> help_;
  QPointer<AlignDialog> align_;
  QPointer<QuickTour> tour_;
  ToolTabs* toolTabs_ = nullptr;
  std::map<QString, ToolWindow*> tools_;
  ParameterForm* form_;
  ProfileEditor* profile_;
  ScenePanel* scene_;
  PaperPanel* paper_;
  SignalsPanel* signals_;
  PreviewPanel* previewPanel_;
  RunPanel* run_;
  RunsPanel* runs_;
  ComparisonWindow* comparison_;
  NotesPanel* notes_;
  ProjectKeeper* keeper_;
  RunReader* reader_;
  RecordWatch* recordWatch_;
  QStringList projectProblems_;
  QStringList cases_;  // files of the cases of this work, the last one first
  QTabWidget *middle_, *right_;
  QDockWidget *formDock_, *signalsDock_, *runDock_, *runsDock_;
  QSize anchor_;           // [pixels] a width of the window, and the width of the signals in it, as the user chose them
  int sharedWidth_ = 0;    // [pixels] that the signals got last, or were given by the user
  int widthOfAll_ = 0;     // [pixels] the least that form, middle and signals need beside each other
  bool isNarrow_ = false;  // the form is a tab of the middle
  bool formWasShown_ = true;
  bool wasShown_ = false;
  QMenu* recent_ = nullptr;
  QAction *darkAction_ = nullptr, *resumeAction_ = nullptr;
  bool closing_ = false, ending_ = false;
  bool previewOffered_ = false;  // since the last run was shown
  QString recoverySaid_;         // empty: nothing was recovered
};

}  // namespace squat::studio
