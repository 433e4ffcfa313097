// Where the parts of the main window stand, and who gets the width that is added to it.
#include <QDockWidget>
#include <QLayout>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <numeric>

#include "studio/document/ParameterForm.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/tools/ToolTabs.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {
namespace {

constexpr int usualForm = 320, usualSignals = 480;  // [pixels] widths in a window of MainWindow::usualSize
// Of the width that is added to the window: signals are what is looked at. The middle gets the rest.
constexpr double shareOfSignals = 0.65;

constexpr const char* firstSizes = "firstSizes";      // property of a splitter
constexpr const char* signalsWidth = "signalsWidth";  // in the settings: of the window, of the signals in it

}  // namespace

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* inside, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(inside);
  addDockWidget(area, dock);
  return dock;
}

// The case at the left in full height, signals at the right, the run and the list of runs side by side below.
void MainWindow::makeDocks() {
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  formDock_ = addDock("caseDock", tr("Case"), form_, Qt::LeftDockWidgetArea);
  signalsDock_ = addDock("signalsDock", tr("Signals"), right_, Qt::RightDockWidgetArea);
  runDock_ = addDock("runDock", tr("Run"), run_, Qt::BottomDockWidgetArea);
  runsDock_ = addDock("runsDock", tr("Runs"), runs_, Qt::BottomDockWidgetArea);
  divideRoom();
}

void MainWindow::divideRoom() {
  splitDockWidget(runDock_, runsDock_, Qt::Horizontal);
  resizeDocks({formDock_, signalsDock_}, {usualForm, usualSignals}, Qt::Horizontal);
  resizeDocks({runDock_, runsDock_}, {540, 580}, Qt::Horizontal);
  resizeDocks({runDock_}, {250}, Qt::Vertical);
  anchor_ = {usualSize.width(), usualSignals};
}

// As at the first start, in a window of the size that it has now.
void MainWindow::resetLayout() {
  for (QDockWidget* dock : {formDock_, signalsDock_, runDock_, runsDock_}) dock->setFloating(false);
  addDockWidget(Qt::LeftDockWidgetArea, formDock_);
  addDockWidget(Qt::RightDockWidgetArea, signalsDock_);
  addDockWidget(Qt::BottomDockWidgetArea, runDock_);
  addDockWidget(Qt::BottomDockWidgetArea, runsDock_);
  divideRoom();
  formWasShown_ = true;
  formDock_->setVisible(!isNarrow_);
  for (QDockWidget* dock : {signalsDock_, runDock_, runsDock_}) dock->show();
  for (QSplitter* splitter : findChildren<QSplitter*>()) {
    auto sizes = splitter->property(firstSizes).value<QList<int>>();
    if (sizes.isEmpty() || sizes.size() != splitter->count()) continue;
    const auto now = splitter->sizes();  // of this window, which may be larger: the first part gets what is more
    sizes[0] += std::accumulate(now.begin(), now.end(), 0) - std::accumulate(sizes.begin(), sizes.end(), 0);
    splitter->setSizes(sizes);
  }
  shareWidth();
  toolTabs()->reset();
}

void MainWindow::takeLayout() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  restoreState(settings.value("state").toByteArray());
  const QSize kept = settings.value(signalsWidth).toSize();
  if (kept.isValid()) anchor_ = kept;
}

void MainWindow::keepLayout() {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  setNarrow(false);  // the state is that of a wide window
  settings.setValue("state", saveState());
  settings.setValue(signalsWidth, anchor_);
}

bool MainWindow::signalsAreBeside() const {
  return !signalsDock_->isFloating() && !signalsDock_->isHidden() &&
         dockWidgetArea(signalsDock_) == Qt::RightDockWidgetArea;
}

// By the width that the user gave the signals last: a window that is made small and large again looks as before.
void MainWindow::shareWidth() {
  if (!signalsAreBeside()) return;
  const int wanted = anchor_.height() + qRound(shareOfSignals * (width() - anchor_.width()));
  resizeDocks({signalsDock_}, {std::max(wanted, signalsDock_->minimumSizeHint().width())}, Qt::Horizontal);
  layout()->activate();
  sharedWidth_ = signalsDock_->width();
}

// A handle between docks is dragged on the window itself, which sees the button go up, as it does after other clicks.
bool MainWindow::event(QEvent* event) {
  const bool handled = QMainWindow::event(event);
  if (event->type() == QEvent::MouseButtonRelease && signalsAreBeside() && signalsDock_->width() != sharedWidth_)
    anchor_ = {width(), sharedWidth_ = signalsDock_->width()};
  if (event->type() == QEvent::Show && !wasShown_) {
    wasShown_ = true;
    QTimer::singleShot(0, this, [this] {  // once they have their sizes
      for (QSplitter* splitter : findChildren<QSplitter*>())
        splitter->setProperty(firstSizes, QVariant::fromValue(splitter->sizes()));
    });
  }
  return handled;
}

// Where form, middle and signals have no room beside each other, the form is the first tab of the middle.
void MainWindow::setNarrow(bool narrow) {
  if (narrow == isNarrow_) return;
  isNarrow_ = narrow;
  if (narrow) {
    formWasShown_ = !formDock_->isHidden();
    formDock_->hide();
    formDock_->setWidget(nullptr);
    middle_->insertTab(0, form_, formDock_->windowTitle());
  } else {
    middle_->removeTab(middle_->indexOf(form_));
    formDock_->setWidget(form_);
    formDock_->setVisible(formWasShown_);
    form_->show();
    resizeDocks({formDock_, signalsDock_}, {form_->minimumWidth(), right_->minimumSizeHint().width()}, Qt::Horizontal);
  }
  formDock_->toggleViewAction()->setEnabled(!narrow);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  setNarrow(event->size().width() < widthOfAll_);
  QMainWindow::resizeEvent(event);
  shareWidth();
}

}  // namespace squat::studio
