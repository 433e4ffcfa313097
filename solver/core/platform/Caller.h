// solver/core/platform/Caller.h - the program that started this one to have a question answered (ChildProgram.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace squat::platform {

std::vector<std::byte> questionOfCaller();            // all of it
bool sendToCaller(std::span<const std::byte> bytes);  // false: it has ended, or does not listen any more

struct OwnLimits {
  std::size_t memory = 0;   // [bytes] beyond what this process has
  std::size_t seconds = 1;  // of computing; beyond it the process is ended
};
// From here on. Where the system can say so, the process writes no file and leaves no image of its memory.
void limitMyself(const OwnLimits& limits);

}  // namespace squat::platform
