// The live preview in the main window: what starts it, what it gives way to, where it is seen.
#include <QAction>
#include <QSettings>
#include <QTabWidget>

#include "studio/preview/PreviewPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {

void MainWindow::connectPreview() {
  auto* action = findChild<QAction*>("livePreview");
  connect(&preview_, &PreviewController::stateChanged, this, [this, action] {
    action->setChecked(preview_.isOn());
    QSettings().setValue("preview", preview_.isOn());
  });
  preview_.setOn(QSettings().value("preview", true).toBool());
  action->setChecked(preview_.isOn());
  connect(&document_, &CaseDocument::changed, this, [this] {
    preview_.show(document_.description());
    offerPreview();
  });
  connect(&controller_, &RunController::started, this, [this] { preview_.setHeld(true); });
  connect(&controller_, &RunController::ended, this, [this] { preview_.setHeld(false); });
  connect(&store_, &RunStore::currentChanged, this, [this] {
    previewOffered_ = false;
    right_->setCurrentWidget(signals_);
  });
  preview_.show(document_.description());
}

// Comes to the front with the first change after a run was shown; where the user turns to the run again, it stays
// there.
void MainWindow::offerPreview() {
  if (previewOffered_ || !preview_.isThere() || !preview_.isOn()) return;
  previewOffered_ = true;
  right_->setCurrentWidget(previewPanel_);
}

}  // namespace squat::studio
