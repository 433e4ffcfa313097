// The quick tour: what it says of each part of the window.
#include <QDockWidget>
#include <QMenuBar>
#include <QSettings>

#include "studio/profile/ProfileEditor.h"
#include "studio/window/MainWindow.h"
#include "studio/window/QuickTour.h"

namespace squat::studio {

void MainWindow::showTour() {
  const auto tab = [this](const QString& name, QWidget* part) {
    return [this, name, part] {
      showTab(name);
      return part;
    };
  };
  const auto dock = [](QDockWidget* part) {
    return [part]() -> QWidget* {
      part->show();
      part->raise();
      return part;
    };
  };
  std::vector<QuickTour::Stop> stops{
      {tr("The case"),
       tr("A case describes track, vehicle, motion and defect. The form shows a dozen basic keys; Advanced and Expert "
          "show more. F1 explains the key that has the focus. File > Shipped cases holds examples."),
       [this] { return showForm(); }},
      {tr("The defect"),
       tr("Choose a shape and move its sliders, or import a measured profile, and drag its points. The second curve is "
          "the path of a rigid wheel, which does not reach the bottom of short hollows: the axle box feels this path."),
       tab("profile", profile_)},
      {tr("Live preview"),
       tr("After every change a coarse model rolls over the defect, so that you see what the change does to the "
          "signal before you run the case. F7 turns it on and off."),
       tab("preview", signalsDock_)},
      {tr("The run"),
       tr("F5 runs the case. You see the curves grow, and the time left. A run can be paused, cancelled and resumed, "
          "even after the program was closed."),
       dock(runDock_)},
      {tr("The signals"),
       tr("Acceleration (ABA), spectrum (PSD), scalogram (CWT) and more, a tab each. Drag with the left button to "
          "enlarge, with the middle button to move. Figures are exported in the size that you choose in the menu "
          "Figure."),
       tab("aba_position", signalsDock_)},
      {tr("Runs and measured signals"),
       tr("Runs are named by what differs between their cases. Tick some to overlay them, overlay a measured signal "
          "(Ctrl+M), and press Compare to see the numbers side by side."),
       dock(runsDock_)},
      {tr("Your work"),
       tr("File > Save project keeps cases, runs, measured signals and notes together, and saves them as you work. The "
          "menu Run has studies, calibration, track receptance and the search for squats in long records. Help > "
          "Contents (F1) opens the manual."),
       [this]() -> QWidget* { return menuBar(); }}};
  QSettings().setValue("tourSeen", true);
  if (tour_)
    tour_->go(0);
  else
    tour_ = new QuickTour(std::move(stops), *this);
}

void MainWindow::offerTour() {
  if (!QSettings().value("tourSeen").toBool()) showTour();
}

}  // namespace squat::studio
