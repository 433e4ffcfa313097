#include "studies/PartLock.h"

#include <filesystem>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/platform/Process.h"

namespace squat::studies {
namespace {

constexpr int kBeatsToWait = 3;
constexpr std::size_t kLargestLock = 1000;

// Opened anew: shared file systems look at the server's copy then.
std::string textAt(const std::string& path) {
  try {
    return readWholeFile(path, kLargestLock);
  } catch (const FileError&) {
    return {};
  }
}

// "squat study slice:3/16 (process 4711 on HOST)" of a file with a beat behind it.
std::string ownerIn(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string textWithBeat(const std::string& name, unsigned long beat) {
  return name + "\nbeat " + std::to_string(beat) + "\n";
}

}  // namespace

PartLock::PartLock(const std::string& command, const Partition& part, const std::string& folder,
                   std::chrono::milliseconds beat, Monitor& monitor)
    : lock_(folder + "/" + stemOf(part, command) + ".lock"),
      part_(toText(part)),
      folder_(folder),
      name_(platform::processName("squat " + command + " --partition " + part_)),
      beat_(beat) {
  if (lock_.isTaken()) refuse(ownerIn(lock_.other()));
  const bool isOfThisMachine = ownerIn(lock_.left()).ends_with(" on " + platform::hostName() + ")");
  if (!lock_.left().empty() && !(lock_.held() && isOfThisMachine)) watchOther(monitor);
  lock_.write(textWithBeat(name_, 0));
  beating_ = std::jthread([this](const std::stop_token& stop) { beatUntil(stop); });
}

PartLock::~PartLock() = default;

void PartLock::refuse(const std::string& owner) const {
  throw CaseError({{"--partition", part_, "a part that no other process computes in " + folder_,
                    "It is computed by " + owner + ": wait until that has ended"}});
}

void PartLock::watchOther(Monitor& monitor) const {
  const auto first = textAt(lock_.path());
  monitor.message("part " + part_ + " was begun by " + ownerIn(first) + ": watching whether it still runs");
  const auto end = std::chrono::steady_clock::now() + kBeatsToWait * beat_;
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(beat_ / 10);
    if (const auto now = textAt(lock_.path()); !now.empty() && now != first) refuse(ownerIn(now));
  }
}

void PartLock::beatUntil(const std::stop_token& stop) {
  std::unique_lock guard(mutex_);
  for (unsigned long beat = 1; !changed_.wait_for(guard, stop, beat_, [] { return false; }); ++beat) {
    if (stop.stop_requested()) return;
    if (ownerIn(textAt(lock_.path())) == name_) lock_.write(textWithBeat(name_, beat));
  }
}

void PartLock::requireOwn() const {
  const auto text = textAt(lock_.path());
  if (!text.empty() && ownerIn(text) != name_) refuse(ownerIn(text));
}

}  // namespace squat::studies
