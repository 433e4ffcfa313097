#include "results/GuardedChild.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/Errors.h"
#include "results/ReaderProgram.h"

namespace squat::results {

GuardedChild::GuardedChild(std::string path, const ChildLimits& limits, const ReaderCall& call,
                           const std::filesystem::path& program)
    : path_(std::move(path)) {
  const auto question = questionOf(call, {limits.memory, limits.seconds});
  const auto reader = program.empty() ? readerProgram() : program;
  if (reader.empty())
    throw FileError(path_, "", "cannot be read: the program squat-reader is missing, which stands beside the others",
                    "Install Squat Studio again");
  if (const auto error = child_.start(reader, question))
    throw FileError(path_, "", "cannot be read: squat-reader does not start: " + error.message());
}

char GuardedChild::receiveKind() {
  char kind = 0;
  if (receive(std::as_writable_bytes(std::span(&kind, 1))) != 1) died();
  if (kind != kRefused) return kind;
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
  // One that is still alive has sent what makes no sense; it may be waiting for us to read on.
  if (!child_.hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const bool endedByItself = child_.hasEnded();
  child_.kill();
  std::string what = "is damaged or malicious: reading it was stopped";
  if (endedByItself && child_.wasStopped()) what += " for taking too long";
  throw FileError(path_, "", what, "Use a file that this program has written");
}

}  // namespace squat::results
