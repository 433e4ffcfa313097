// solver/core/platform/ForkedReader.h - a copy of this process that does one thing and sends what it found; its death
// harms nobody.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <system_error>

namespace squat::platform {

// Holds one child at a time. In the child no thread exists but the one that started it: a lock that another one held
// stays locked there for ever.
class ForkedReader {
 public:
  struct Limits {
    std::size_t memory = 0;   // [bytes] beyond what this process has
    std::size_t seconds = 1;  // of computing; beyond it the child is ended
  };
  using Send = std::function<void(std::span<const std::byte>)>;
  using Work = std::function<void(const Send&)>;
  enum class Waited { untilBytes, inVain, interrupted };  // untilBytes: or until the child's end

  ForkedReader() = default;
  ~ForkedReader() { end(); }
  ForkedReader(const ForkedReader&) = delete;
  ForkedReader& operator=(const ForkedReader&) = delete;

  // `work` runs in the child, which can write no file, and ends it when it returns or throws. No child may be left from
  // before. On an error there is no child.
  std::error_code start(const Work& work, const Limits& limits);
  Waited wait(std::chrono::milliseconds patience) const;  // for the next byte
  std::size_t receive(std::span<std::byte> wanted);       // fewer bytes than wanted: the child has ended
  double secondsComputed() const;                         // by the child so far

  bool hasEnded();
  void waitForEnd();
  void kill();  // and waits for its end
  void end();   // kills it; what it has sent is lost
  // Of a child that has ended: it was killed, for computing too long or by somebody else.
  bool wasStopped() const;

 private:
  int source_ = -1;  // what the child sends arrives here; below 0: closed
  int process_ = -1;
  int status_ = 0;
  bool hasEnded_ = true;
};

}  // namespace squat::platform
