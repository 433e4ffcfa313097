// solver/core/platform/ChildProgram.h - a program that does one thing for this one and sends what it found; its death
// harms nobody. Its own side is Caller.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <system_error>

namespace squat::platform {

// Holds one child at a time. It inherits neither files nor locks of this process, and no thread's.
class ChildProgram {
 public:
  ChildProgram() = default;
  ~ChildProgram() { end(); }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  // Starts `program`, whose standard input is the question and whose standard output comes here. No child may be left
  // from before. On an error there is no child; one that does not read its question is no error here.
  std::error_code start(const std::filesystem::path& program, std::span<const std::byte> question);
  std::size_t receive(std::span<std::byte> wanted);  // fewer bytes than wanted: the child has ended

  bool hasEnded();
  void waitForEnd();
  void kill();  // and waits for its end
  void end();   // kills it; what it has sent is lost
  // Of a child that has ended: it was killed, for computing too long or by somebody else.
  bool wasStopped() const;

 private:
  static constexpr std::intptr_t none = -1;
  std::intptr_t source_ = none;  // what the child sends arrives here
  std::intptr_t process_ = none;
  std::intptr_t fate_ = none;  // where the system ends a child together with what this names: Windows
  int status_ = 0;
  bool hasEnded_ = true;
};

}  // namespace squat::platform
