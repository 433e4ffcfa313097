#include "studio/preview/PreviewWorker.h"

#include <chrono>
#include <utility>

#include "case/BeforeDefect.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "core/platform/Threads.h"
#include "signals/SignalCatalogue.h"
#include "studio/preview/GrowingCurve.h"
#include "studio/preview/PreviewCase.h"

namespace squat::studio {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds betweenPictures{12};  // a screen shows 60 a second
constexpr std::chrono::milliseconds blindness{200};       // of a drag that restarts the preview all the time
constexpr double behindDefect = 0.02;                     // [m] from its end: the impact has been seen

simulation::RunOptions bareOptions(int threads) {
  simulation::RunOptions options;
  options.threads = threads;
  options.wheelsetModes = options.snapshots = false;
  return options;
}

// A picture with what is known before the wheel rolls.
Preview pictureOf(const cases::CaseDescription& description) {
  Preview picture;
  const auto surface = cases::surfaceOf(description);
  picture.from = -description.motion.runUp, picture.to = description.motion.beyond;
  picture.defectFrom = surface.first(), picture.defectTo = surface.last();
  return picture;
}

// True where the state that is made for one case serves the other as well.
bool haveSameStart(const cases::CaseDescription& open, const cases::CaseDescription& made) {
  if (!whyNoPreview(open).empty()) return false;
  const auto other = previewCase(open);
  return cases::defectZone(other) == cases::defectZone(made) && cases::differencesBeforeDefect(other, made).empty();
}

// How far a phase of the preparation is into the whole, roughly as they take their time.
double shareOf(const Progress& progress) {
  const std::pair<const char*, std::pair<double, double>> phases[] = {{"mesh", {0, 0.1}},
                                                                      {"stable step", {0.1, 0.2}},
                                                                      {"equilibrium", {0.2, 0.5}},
                                                                      {"initial velocities", {0.5, 0.7}},
                                                                      {"rolling", {0.7, 1}}};
  for (const auto& [name, part] : phases)
    if (progress.phase == name) return part.first + (part.second - part.first) * progress.fraction;
  return 0;
}

bool concernsTheState(const CaseError& error) { return error.problems().front().key == "--warm"; }

}  // namespace

// A state in the making goes on for a newer wish that it serves too.
class PreviewWorker::StartMonitor : public Monitor {
 public:
  StartMonitor(PreviewWorker& worker, const Wish& wish, const cases::CaseDescription& made, bool isShown)
      : worker_(worker), wish_(wish), made_(made), isShown_(isShown) {}
  bool cancelled() override {
    if (worker_.isNewest(judged_)) return cancelled_;
    judged_ = worker_.newest();
    cancelled_ = !judged_.open || !haveSameStart(*judged_.open, made_);
    return cancelled_;
  }
  void report(const Progress& progress) override {
    if (!isShown_) return;
    auto picture = pictureOf(made_);
    picture.phase = PreviewPhase::preparing;
    picture.text = progress.phase;
    picture.fraction = shareOf(progress);
    worker_.publish(cancelled_ ? wish_ : judged_, std::move(picture));
  }

 private:
  PreviewWorker& worker_;
  const Wish wish_;
  const cases::CaseDescription& made_;
  const bool isShown_;
  Wish judged_ = wish_;
  bool cancelled_ = false;
};

class PreviewWorker::RollMonitor : public Monitor {
 public:
  RollMonitor(const PreviewWorker& worker, const Wish& wish, const double& position, double seenAt)
      : worker_(worker), wish_(wish), position_(position), seenAt_(seenAt) {}
  bool cancelled() override {
    if (worker_.isNewest(wish_)) return false;
    const bool isPatient = worker_.patientFor_ == wish_.number && position_ < seenAt_;
    return !isPatient || !worker_.newest().open;
  }

 private:
  const PreviewWorker& worker_;
  const Wish& wish_;
  const double& position_;  // [m] of the newest sample
  const double seenAt_;     // [m]
};

PreviewWorker::PreviewWorker(PreviewSolver solver, int threads, std::function<void()> changed)
    : solver_(std::move(solver)),
      threads_(threads),
      changed_(std::move(changed)),
      start_(solver_, bareOptions(threads)),
      thread_([this] { work(); }) {}

PreviewWorker::~PreviewWorker() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    wish_ = {nullptr, ++newest_};
  }
  wake_.notify_all();
  thread_.join();
}

void PreviewWorker::ask(std::shared_ptr<const cases::CaseDescription> open) {
  {
    const std::lock_guard lock(mutex_);
    wish_ = {std::move(open), ++newest_};
    busy_ = wish_.open != nullptr;
  }
  wake_.notify_all();
}

Preview PreviewWorker::take() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

PreviewWorker::Wish PreviewWorker::newest() const {
  const std::lock_guard lock(mutex_);
  return wish_;
}

void PreviewWorker::work() {
  platform::giveWay();  // to the window
  lastSeen_ = Clock::now();
  unsigned long served = 0;
  while (true) {
    Wish wish;
    {
      std::unique_lock lock(mutex_);
      if (wish_.number == served) {
        wake_.wait(lock, [&] { return closing_ || wish_.number != served; });
        lastSeen_ = Clock::now();  // what has rested is not blind
      }
      if (closing_) return;
      wish = wish_;
    }
    served = wish.number;
    if (wish.open) serve(wish);
  }
}

// What an earlier wish has to say comes too late, except where a drag would see nothing else.
bool PreviewWorker::mayPublish(const Wish& wish) const {
  return wish_.number == wish.number || (patientFor_ == wish.number && wish_.open);
}

void PreviewWorker::publish(const Wish& wish, Preview preview) {
  {
    const std::lock_guard lock(mutex_);
    if (!mayPublish(wish)) return;
    const bool isEnd = preview.phase == PreviewPhase::done || preview.phase == PreviewPhase::unavailable;
    if (isEnd && wish_.number == wish.number) busy_ = false;
    latest_ = std::move(preview);
  }
  changed_();
}

void PreviewWorker::refuse(const Wish& wish, const std::string& sentence) {
  Preview picture;
  picture.phase = PreviewPhase::unavailable;
  picture.text = sentence;
  publish(wish, std::move(picture));
}

void PreviewWorker::serve(const Wish& wish) {
  try {
    preview(wish);
  } catch (const CaseError& error) {
    refuse(wish, concernsTheState(error) ? "No preview: the profile rises so high that the wheel touches it too early."
                                         : "No preview: " + toText(error.problems().front()) + ".");
  } catch (const std::bad_alloc&) {
    refuse(wish, "No preview: not enough memory.");
  } catch (const std::exception& error) {
    refuse(wish, std::string("No preview: ") + error.what() + ".");
  }
}

void PreviewWorker::preview(const Wish& wish) {
  if (const auto why = whyNoPreview(*wish.open); !why.empty()) return refuse(wish, why);
  const auto description = previewCase(*wish.open);
  StartMonitor monitor(*this, wish, description, !start_.serves(description));
  const auto state = start_.stateFor(description, monitor);
  if (!state || !isNewest(wish)) return;
  results::RunResult result;
  try {
    result = roll(wish, description, state);
  } catch (const CaseError& error) {
    if (!concernsTheState(error) || state == start_.first()) throw;
    result = roll(wish, description, start_.first());
  }
  if (!result.complete || !isNewest(wish)) return;
  auto picture = pictureOf(description);
  picture.phase = PreviewPhase::done;
  picture.position = result.position;
  if (const auto* filtered = result.signal(signals::names::axleBoxFiltered)) picture.acceleration = *filtered;
  picture.result = std::make_shared<const results::RunResult>(std::move(result));
  publish(wish, std::move(picture));
}

results::RunResult PreviewWorker::roll(const Wish& wish, const cases::CaseDescription& description,
                                       std::shared_ptr<const simulation::WarmState> state) {
  GrowingCurve curve(*state, description.output.rate, description.output.filterCutoff);
  auto picture = pictureOf(description);
  picture.phase = PreviewPhase::rolling;
  const double seenAt = picture.defectTo + behindDefect;
  double reached = picture.from;
  patientFor_ = Clock::now() - lastSeen_ > blindness ? wish.number : 0;
  auto last = Clock::now();
  const auto show = [&] {
    picture.position = curve.position(), picture.acceleration = curve.filtered();
    publish(wish, picture);
  };
  show();
  auto options = bareOptions(threads_);
  options.sampled = [&](double position, double acceleration) {
    curve.add(position, acceleration);
    const auto now = Clock::now();
    const bool isSeenNow = reached < seenAt && position >= seenAt;
    reached = position;
    if (isSeenNow) lastSeen_ = now;
    if (now - last < betweenPictures && !isSeenNow) return;
    last = now;
    show();
  };
  options.warm = std::move(state);
  RollMonitor monitor(*this, wish, reached, seenAt);
  return solver_.run(description, options, monitor, nullptr);
}

}  // namespace squat::studio
