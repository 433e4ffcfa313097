// widgets/studio/preview/PreviewController.h - previews of the open case, in the thread of the window.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>

#include "studio/preview/PreviewWorker.h"

namespace squat::studio {

// Whatever is computed is computed elsewhere; pictures come at most some sixty times a second.
class PreviewController : public QObject {
  Q_OBJECT
 public:
  // A solver that is not there: nothing ever happens. `threads` as RunOptions'.
  PreviewController(const PreviewSolver& solver, int threads, QObject* parent = nullptr);
  ~PreviewController() override;  // cancels and waits

  void setOn(bool on);
  // While a whole run needs the machine, or the window closes.
  void setHeld(bool held);
  // The case that is open, after every change of it.
  void show(const cases::CaseDescription& open);
  bool isOn() const { return on_; }
  bool isHeld() const { return held_; }
  bool isThere() const { return worker_ != nullptr; }
  bool isBusy() const { return worker_ && worker_->isBusy(); }
  bool waitFor(int milliseconds);  // runs the event loop until nothing is under way; false where it still is
  const Preview& latest() const { return latest_; }

 Q_SIGNALS:
  void changed(const squat::studio::Preview& preview);
  void stateChanged();  // on or off, held or not

 private:
  void ask();
  void takeNews();

  Preview latest_;
  std::shared_ptr<const cases::CaseDescription> open_;
  bool on_ = true, held_ = false;
  QTimer pause_;
  QElapsedTimer sinceLast_;
  std::atomic<bool> isPosted_{false};
  std::unique_ptr<PreviewWorker> worker_;  // last: it calls into the others until it has ended
};

}  // namespace squat::studio
