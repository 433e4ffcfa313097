// solver/results/GuardedChild.h - work on an untrusted file, in a child process whose death is an
// error here: libraries that read such files are not proof against damage.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "core/platform/ForkedReader.h"
#include "results/TreeStream.h"

namespace squat::results {

struct ChildLimits {
  std::size_t memory = 0;   // [bytes] beyond what this process has
  std::size_t seconds = 1;  // of computing
  int patience = 5000;      // [ms] without computing and without a byte: it is taken for stuck
};

class GuardedChild {
 public:
  // `work` runs in the child and sends bytes. A FileError that it throws is thrown here by receiveKind; anything else,
  // its death and its end, as well. A child that is stuck before its first byte is replaced, twice at most: a thread
  // that does not exist in it may have held a lock when it was forked. So `work` must be callable until the first byte
  // is received.
  using Work = std::function<void(const ByteSink&)>;
  GuardedChild(std::string path, const ChildLimits& limits, Work work);

  // The child sends one byte before each thing; this reads it.
  char receiveKind();
  std::size_t receive(std::span<std::byte> wanted);  // fewer bytes than wanted: the child has ended
  // Waits for the child and throws FileError saying how it ended.
  [[noreturn]] void died();
  void wait() { child_.waitForEnd(); }

  static constexpr char refused = 'E';

 private:
  void start();
  void awaitFirstByte();
  std::string path_;
  ChildLimits limits_;
  Work work_;
  bool hasBegun_ = false;
  platform::ForkedReader child_;  // which ends the child
};

}  // namespace squat::results
