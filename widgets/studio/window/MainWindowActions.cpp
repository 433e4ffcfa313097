// Menus of the main window: every action has a shortcut and a name.
#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStyle>
#include <QUrl>

#include "case/ParameterTable.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "core/ProgramVersion.h"
#include "studio/common/PaneKeys.h"
#include "studio/common/Theme.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/model/ScenePanel.h"
#include "studio/preview/PreviewPanel.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/project/NotesPanel.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/HelpWindow.h"
#include "studio/window/MainWindow.h"
#include "studio/window/PaperPanel.h"
#include "studio/window/RecentFiles.h"
#include "text/HeadingAnchor.h"

namespace squat::studio {
namespace {

template <class Target, class Slot>
QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys, const char* name, Target* target, Slot slot) {
  QAction* action = menu->addAction(text, target, slot);
  action->setShortcut(keys);
  action->setObjectName(name);
  return action;
}

// As it reads behind "Show": "contact force", "3-D model".
QString tabTitle(const QString& name) {
  if (name == "model") return QObject::tr("3-D model");
  if (name == "preview") return QObject::tr("live preview");
  if (name == "comparison") return QObject::tr("comparison of runs");
  if (name == "paper") return QObject::tr("summary of the run");
  if (!SignalsPanel::names().contains(name)) return name;
  const QString title = QString::fromStdString(plots::figureRow(name.toStdString()).title);
  return title.left(1).toLower() + title.mid(1);
}

// Ctrl+1 to Ctrl+9, then Ctrl+Alt+1 to Ctrl+Alt+9 and Ctrl+Alt+0; no keys beyond.
QKeySequence tabKeys(int index) {
  constexpr int digits = 9;
  if (index == 2 * digits) return QKeySequence("Ctrl+Alt+0");
  if (index > 2 * digits) return {};
  return QKeySequence(
      (index < digits ? QStringLiteral("Ctrl+%1") : QStringLiteral("Ctrl+Alt+%1")).arg(index % digits + 1));
}

}  // namespace

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  add(menu, tr("&New case"), QKeySequence::New, "new", this, [this] {
    if (!mayLeaveCase()) return;
    document_.startNew();
    hideWordsOfOldCase();
    profile_->plot()->fit();
  });
  add(menu, tr("&Open…"), QKeySequence::Open, "open", this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a case, a result or a project"), QString(),
                                                      tr("Cases, results and projects (*.toml *.h5 *.squat-project);;"
                                                         "All files (*)"));
    if (!path.isEmpty()) openAny(path);
  });
  QMenu* shipped = menu->addMenu(tr("S&hipped cases"));
  int number = 0;
  for (const auto& name : cases::shippedCases()) {
    const QString text = QString::fromStdString(name);
    const QString keys = ++number <= 10 ? QStringLiteral("Alt+Shift+%1").arg(number % 10) : QString();
    add(shipped, text, QKeySequence(keys), "", this, [this, text] {
      openCase(text);
    })->setObjectName("shipped " + text);
  }
  QMenu* ofProject = menu->addMenu(tr("&Cases of this work"));
  connect(ofProject, &QMenu::aboutToShow, this, [this, ofProject] {
    ofProject->clear();
    for (const QString& path : cases_)
      ofProject->addAction(QFileInfo(path).completeBaseName(), this, [this, path] { openCase(path); })
          ->setToolTip(path);
    if (ofProject->isEmpty()) ofProject->addAction(tr("No case files yet"))->setEnabled(false);
  });
  recent_ = menu->addMenu(tr("&Recent"));
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
  menu->addSeparator();
  add(menu, tr("&Save case"), QKeySequence::Save, "save", this, [this] { saveCase(); });
  add(menu, tr("Save case &as…"), QKeySequence("Ctrl+Shift+S"), "saveAs", this, [this] { saveCaseAs(); });
  makeProjectActions(*menu);
  QAction* saving = add(menu, tr("Save r&esult…"), QKeySequence("Ctrl+Shift+R"), "saveResult", this,
                        [this] { saveRun(store_.current()); });
  QAction* measured = add(menu, tr("Overlay &measured signal…"), QKeySequence("Ctrl+M"), "measured", this, [this] {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Overlay measured signal"), QString(),
        tr("Signals (*.csv *.txt *.gz *.h5 *.mat *.tdms *.lvm *.wav *.unv *.uff);;All files (*)"));
    if (path.isEmpty()) return;
    const bool asks = needsChoice(headOf(path.toStdString(), {}));
    if (asks || (!openMeasured(path) && QFileInfo(path).isReadable())) askHowToRead(path);
  });
  connect(runs_, &RunsPanel::saveRequested, saving, &QAction::trigger);
  connect(runs_, &RunsPanel::saveRunRequested, this, [this](int row) { saveRun(row); });
  connect(runs_, &RunsPanel::compareRequested, this, [this] { showTab("comparison"); });
  connect(runs_, &RunsPanel::measuredRequested, measured, &QAction::trigger);
  connect(runs_, &RunsPanel::alignRequested, this, &MainWindow::alignByHand);
  connect(runs_, &RunsPanel::columnsRequested, this, [this](int row) {
    if (align_) align_->close();  // it lays the record that is there now
    askForColumns(store_, row, document_.description().motion.speed, figureStyle(requestedDark()), this);
  });
  connect(runs_, &RunsPanel::caseRequested, this, &MainWindow::openCaseOf);
  connect(runs_, &RunsPanel::removeRequested, this, &MainWindow::removeRun);
  connect(runs_, &RunsPanel::folderRequested, this,
          [](const QString& path) { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); });
  connect(runs_, &RunsPanel::openRequested, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a result"), QString(), tr("Results (*.h5)"));
    if (!path.isEmpty()) openResult(path);
  });
  menu->addSeparator();
  add(menu, tr("&Quit"), QKeySequence("Ctrl+Q"), "quit", this, &QWidget::close);
}

void MainWindow::fillRecentMenu() {
  recent_->clear();
  for (const QString& path : recentFiles()) recent_->addAction(path, this, [this, path] { openAny(path); });
  if (recent_->isEmpty()) recent_->addAction(tr("No recent files"))->setEnabled(false);
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undoStack().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setObjectName("undo");
  QAction* redo = document_.undoStack().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  redo->setObjectName("redo");
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  add(menu, tr("Restore r&un"), QKeySequence("Ctrl+Alt+Z"), "restoreRun", this, &MainWindow::restoreRun);
}

void MainWindow::makeRunMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Run"));
  add(menu, tr("&Run the case"), QKeySequence("F5"), "runAction", this, [this] {
    startRun();
  })->setShortcutContext(Qt::ApplicationShortcut);
  resumeAction_ =
      add(menu, tr("R&esume the stopped run"), QKeySequence("Ctrl+F5"), "resumeAction", this, [this] { resumeRun(); });
  resumeAction_->setToolTip(tr("The run of this case that was cancelled or interrupted when the program closed"));
  resumeAction_->setShortcutContext(Qt::ApplicationShortcut);
  add(menu, tr("&Pause or continue"), QKeySequence("Ctrl+Shift+F5"), "pauseAction", this, [this] {
    controller_.setPaused(!controller_.isPaused());
  })->setShortcutContext(Qt::ApplicationShortcut);
  add(menu, tr("&Cancel"), QKeySequence("Shift+F5"), "cancelAction", this, [this] {
    controller_.cancel();
  })->setShortcutContext(Qt::ApplicationShortcut);
  menu->addSeparator();
  QAction* live = menu->addAction(tr("&Live preview"), &preview_, &PreviewController::setOn);
  live->setShortcut(QKeySequence("F7"));
  live->setObjectName("livePreview");
  live->setCheckable(true);
  live->setToolTip(tr("Compute a preview on a coarse mesh after every change of the profile"));
  live->setEnabled(preview_.isThere());
  makeToolActions(*menu);
}

void MainWindow::makeFigureMenu() {
  QMenu* menu = menuBar()->addMenu(tr("F&igure"));
  add(menu, tr("&Copy picture and data"), QKeySequence("Ctrl+Shift+C"), "copyFigure", this,
      [this] { signals_->currentView()->copy(); });
  add(menu, tr("&Export…"), QKeySequence("Ctrl+Shift+E"), "exportFigure", this,
      [this] { signals_->currentView()->askForFile(); });
  add(menu, tr("Export &all…"), QKeySequence("Ctrl+Alt+E"), "exportAll", this, [this] { signals_->askForFolder(); });
  add(menu, tr("&Size of figures…"), QKeySequence("Ctrl+Alt+F"), "figureSize", this,
      [this] { signals_->askForSize(); });
  add(menu, tr("&Reset zoom"), QKeySequence("Ctrl+Shift+0"), "resetZoom", this,
      [this] { signals_->currentView()->resetZoom(); });
  add(menu, tr("C&ursors"), QKeySequence("Ctrl+Shift+U"), "toggleCursors", this, [this] { signals_->toggleCursors(); });
  add(menu, tr("Save rep&ort…"), QKeySequence("Ctrl+Alt+R"), "report", this, [this] { saveReport(); });
  menu->addSeparator();
  add(menu, tr("Save &picture of the model…"), QKeySequence("Ctrl+Alt+P"), "modelPicture", this,
      [this] { scene_->savePicture(); });
  add(menu, tr("Export &frames for ParaView…"), QKeySequence("Ctrl+Alt+V"), "vtkSeries", this,
      [this] { scene_->saveSeries(); });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  int index = 0;
  for (const QString& name : tabNames()) {
    QAction* action = menu->addAction(tr("Show %1").arg(tabTitle(name)), this, [this, name] { showTab(name); });
    action->setShortcut(tabKeys(index++));
    action->setObjectName("show " + name);
  }
  menu->addSeparator();
  int dockNumber = 0;
  for (QDockWidget* dock : {formDock_, signalsDock_, runDock_, runsDock_}) {
    QAction* action = dock->toggleViewAction();
    action->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+%1").arg(++dockNumber)));
    action->setObjectName("toggle " + dock->objectName());
    menu->addAction(action);
  }
  menu->addSeparator();
  add(menu, tr("Reset &layout"), QKeySequence("Ctrl+Alt+L"), "resetLayout", this, &MainWindow::resetLayout);
  add(menu, tr("&Fit profile to view"), QKeySequence("Ctrl+0"), "fit", this, [this] { profile_->plot()->fit(); });
  addPaneKeys(*this, [this] {
    std::vector<QWidget*> panes{middle_, right_, run_, runs_};
    if (!isNarrow_) panes.insert(panes.begin(), form_);
    return panes;
  });
  darkAction_ = menu->addAction(tr("&Dark"), this, [this](bool on) {
    QSettings().setValue("dark", on);
    setDark(on);
  });
  darkAction_->setCheckable(true);
  darkAction_->setChecked(requestedDark());
  darkAction_->setShortcut(QKeySequence("Ctrl+D"));
  darkAction_->setObjectName("dark");
}

// The page of what has the focus: of a key its table, else that of the panel around it; empty: the index.
QString MainWindow::helpOfFocus() const {
  const auto pages = std::initializer_list<std::pair<const QWidget*, const char*>>{
      {form_, "parameters.md"},         {profile_, "studio.md#profile"},
      {scene_, "exchange.md#paraview"}, {paper_, "validation.md"},
      {notes_, "studio.md#projects"},   {previewPanel_, "studio.md#live-preview"},
      {signals_, "studio.md#signals"},  {run_, "running.md#what-a-run-writes"},
      {runs_, "studio.md#runs"},        {comparison_, "studio.md#comparison"}};
  for (const auto& [name, window] : tools_)
    if (window->isVisible() && window->isActiveWindow())
      return name == "squats" || name == "estimate" ? "studio.md#long-records"
                                                    : "studio.md#studies-calibration-and-receptance";
  for (const QWidget* widget = QApplication::focusWidget(); widget; widget = widget->parentWidget()) {
    if (const auto* parameter = cases::findOnEitherSide(widget->objectName().toStdString()))
      return "parameters.md#" + QString::fromStdString(text::headingAnchor(parameter->group));
    for (const auto& [panel, page] : pages)
      if (widget == panel) return page;
  }
  return {};
}

void MainWindow::showHelp() {
  const QString page = helpOfFocus();
  if (!help_) help_ = new HelpWindow(helpPages(), this);
  if (!page.isEmpty()) help_->showPage(page);
  help_->show();
  help_->raise();
  help_->activateWindow();
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  add(menu, tr("&Contents"), QKeySequence("F1"), "help", this, &MainWindow::showHelp);
  add(menu, tr("&Quick tour"), QKeySequence("Shift+F1"), "tour", this, &MainWindow::showTour);
  add(menu, tr("&About Squat Studio"), QKeySequence("Ctrl+F1"), "about", this, [this] {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Squat Studio"),
                                tr("<b>Squat Studio %1</b><br>Draw a squat, roll a wheel over it, see the axle box "
                                   "acceleration.<br>After M. Molodova, Z. Li, A. Núñez and R. Dollevoet (2014).<br>"
                                   "GPL-3.0-or-later")
                                    .arg(QString::fromStdString(programVersionText())),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
  for (QAction* action : menuBar()->actions())
    if (action->menu()) action->menu()->setToolTipsVisible(true);
}

}  // namespace squat::studio
