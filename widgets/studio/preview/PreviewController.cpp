#include "studio/preview/PreviewController.h"

#include <QEventLoop>
#include <algorithm>

#include "core/ThreadTeam.h"

namespace squat::studio {

namespace {

constexpr int pictureInterval = 16;  // [ms]
// The mesh has some 14,000 elements: more threads would wait for each other longer than they compute.
constexpr int maximumThreads = 4;

}  // namespace

PreviewController::PreviewController(const PreviewSolver& solver, int threads, QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  pause_.setTimerType(Qt::PreciseTimer);
  connect(&pause_, &QTimer::timeout, this, &PreviewController::takeNews);
  if (!solver.isThere()) return;
  worker_ = std::make_unique<PreviewWorker>(solver, std::min(threadCount(threads), maximumThreads), [this] {
    if (!isPosted_.exchange(true)) QMetaObject::invokeMethod(this, &PreviewController::takeNews, Qt::QueuedConnection);
  });
}

PreviewController::~PreviewController() = default;

void PreviewController::setOn(bool on) {
  if (on_ == on) return;
  on_ = on;
  ask();
  Q_EMIT stateChanged();
}

void PreviewController::setHeld(bool held) {
  if (held_ == held) return;
  held_ = held;
  ask();
  Q_EMIT stateChanged();
}

void PreviewController::show(const cases::CaseDescription& open) {
  open_ = std::make_shared<const cases::CaseDescription>(open);
  if (on_ && !held_) ask();
}

void PreviewController::ask() {
  if (worker_) worker_->ask(on_ && !held_ ? open_ : nullptr);
}

// One event is under way at a time, and the next waits until the one before has been looked at for a while.
void PreviewController::takeNews() {
  if (pause_.isActive()) return;
  const qint64 passed = sinceLast_.isValid() ? sinceLast_.elapsed() : pictureInterval;
  if (passed < pictureInterval) return pause_.start(static_cast<int>(pictureInterval - passed));
  isPosted_ = false;
  if (!on_ || held_) return;
  sinceLast_.start();
  latest_ = worker_->take();
  Q_EMIT changed(latest_);
}

bool PreviewController::waitFor(int milliseconds) {
  // The worker is idle a moment before its last news are posted.
  const auto isTaken = [this] { return !worker_ || !on_ || held_ || worker_->take().phase == latest_.phase; };
  const auto isOver = [&] { return !isBusy() && !isPosted_ && isTaken(); };
  QEventLoop loop;
  QTimer look;
  connect(&look, &QTimer::timeout, &loop, [&] {
    if (isOver()) loop.quit();
  });
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  look.start(1);
  loop.exec();
  return isOver();
}

}  // namespace squat::studio
