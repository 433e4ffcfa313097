// solver/results/GuardedChild.h - work on an untrusted file, in another program whose death is an error here: libraries
// that read such files are not proof against damage.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/platform/ChildProgram.h"
#include "results/ReaderCall.h"

namespace squat::results {

struct ChildLimits {
  std::size_t memory = 0;   // [bytes] beyond what the program has at its beginning
  std::size_t seconds = 1;  // of computing
};

class GuardedChild {
 public:
  // A FileError of the work is thrown here by receiveKind; anything else that ends it, as well. `program`: by default
  // readerProgram() (ReaderProgram.h).
  GuardedChild(std::string path, const ChildLimits& limits, const ReaderCall& call,
               const std::filesystem::path& program = {});

  // The program sends one byte before each thing; this reads it.
  char receiveKind();
  std::size_t receive(std::span<std::byte> wanted) { return child_.receive(wanted); }  // fewer bytes: it has ended
  // Waits for its end and throws FileError saying how it ended.
  [[noreturn]] void died();
  void wait() { child_.waitForEnd(); }

 private:
  std::string path_;
  platform::ChildProgram child_;  // which ends the program
};

}  // namespace squat::results
