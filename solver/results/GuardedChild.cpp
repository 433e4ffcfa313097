#include "results/GuardedChild.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/Errors.h"
#include "results/Hdf5Handle.h"

namespace squat::results {

namespace {

void workInChild(const GuardedChild::Work& work, const ByteSink& send) {
  const auto sendText = [&](const std::string& text) { send(std::as_bytes(std::span(text))); };
  try {
    work(send);
  } catch (const FileError& error) {
    sendText(std::string(1, GuardedChild::refused) + error.location() + '\n' + error.what());
  } catch (...) {
    sendText(std::string(1, GuardedChild::refused) + "\nneeds more memory than allowed");
  }
}

}  // namespace

GuardedChild::GuardedChild(std::string path, const ChildLimits& limits, Work work)
    : path_(std::move(path)), limits_(limits), work_(std::move(work)) {
  start();
}

void GuardedChild::start() {
  const auto work = [this](const ByteSink& send) { workInChild(work_, send); };
  const auto error = [&] {
    const auto lock = hdf5::lockLibrary();  // so that the child finds the library at rest
    return child_.start(work, {limits_.memory, limits_.seconds});
  }();
  if (error) throw FileError(path_, "", "cannot be read: " + error.message());
}

void GuardedChild::awaitFirstByte() {
  using Waited = platform::ForkedReader::Waited;
  constexpr int replacements = 2;
  for (int replaced = 0; !hasBegun_ && replaced < replacements;) {
    const double before = child_.secondsComputed();
    const auto waited = child_.wait(std::chrono::milliseconds(limits_.patience));
    if (waited == Waited::untilBytes) break;
    if (waited == Waited::interrupted || child_.secondsComputed() > before) continue;
    child_.end();
    start();
    ++replaced;
  }
  hasBegun_ = true;
}

std::size_t GuardedChild::receive(std::span<std::byte> wanted) {
  awaitFirstByte();
  return child_.receive(wanted);
}

char GuardedChild::receiveKind() {
  char kind = 0;
  if (receive(std::as_writable_bytes(std::span(&kind, 1))) != 1) died();
  if (kind != refused) return kind;
  std::string text(4096, '\0');
  text.resize(receive(std::as_writable_bytes(std::span(text))));
  const auto split = std::min(text.find('\n'), text.size());
  const auto location = text.substr(0, split);
  auto what = split < text.size() ? text.substr(split + 1) : text;
  const auto prefix = path_ + (location.empty() ? "" : ", " + location) + ": ";  // FileError puts it before once more
  if (what.compare(0, prefix.size(), prefix) == 0) what.erase(0, prefix.size());
  throw FileError(path_, location, what);
}

void GuardedChild::died() {
  // A child that is still alive has sent what makes no sense; it may be waiting for us to read on.
  if (!child_.hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const bool endedByItself = child_.hasEnded();
  child_.kill();
  std::string what = "is damaged or malicious: reading it was stopped";
  if (endedByItself && child_.wasStopped()) what += " for taking too long";
  throw FileError(path_, "", what, "Use a file that this program has written");
}

}  // namespace squat::results
