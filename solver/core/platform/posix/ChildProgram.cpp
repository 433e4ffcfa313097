#include "core/platform/ChildProgram.h"

#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

#include "core/platform/posix/System.h"

namespace squat::platform {

namespace {

// What this process ignores or blocks, a program that it starts would as well: there, everything is as by default.
void resetSignals(posix_spawnattr_t& attributes) {
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

// An error number, or 0.
int spawn(const std::string& program, int channel, pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO}) ::posix_spawn_file_actions_adddup2(&actions, channel, stream);
  resetSignals(attributes);
  std::string name = program;
  char* words[] = {name.data(), nullptr};
  const int error = ::posix_spawn(&process, program.c_str(), &actions, &attributes, words, environmentOfProcess());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

#if defined(MSG_NOSIGNAL)
constexpr int noSignal = MSG_NOSIGNAL;
#else
constexpr int noSignal = 0;  // the socket itself is marked (pairOfSockets)
#endif

// To a child that has died nothing can be sent; receive() will see that.
void sendAll(int channel, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto sent = ::send(channel, bytes.data(), bytes.size(), noSignal);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) break;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  ::shutdown(channel, SHUT_WR);
}

}  // namespace

// A socket, since writing to a pipe whose reader has died would end this process.
std::error_code ChildProgram::start(const std::filesystem::path& program, std::span<const std::byte> question) {
  int ends[2] = {-1, -1};
  if (const int error = pairOfSockets(ends); error != 0) return {error, std::generic_category()};
  pid_t process = -1;
  const int error = spawn(program.string(), ends[1], process);
  ::close(ends[1]);
  if (error != 0) {
    ::close(ends[0]);
    return {error, std::generic_category()};
  }
  process_ = process, source_ = ends[0], hasEnded_ = false;
  sendAll(ends[0], question);
  return {};
}

std::size_t ChildProgram::receive(std::span<std::byte> wanted) {
  std::size_t have = 0;
  while (have < wanted.size()) {
    const auto got = ::read(static_cast<int>(source_), wanted.data() + have, wanted.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

bool ChildProgram::hasEnded() {
  const auto process = static_cast<pid_t>(process_);
  if (!hasEnded_ && ::waitpid(process, &status_, WNOHANG) == process) hasEnded_ = true;
  return hasEnded_;
}

void ChildProgram::waitForEnd() {
  while (!hasEnded_ && ::waitpid(static_cast<pid_t>(process_), &status_, 0) < 0 && errno == EINTR) {
  }
  hasEnded_ = true;
}

void ChildProgram::kill() {
  if (!hasEnded_) ::kill(static_cast<pid_t>(process_), SIGKILL);
  waitForEnd();
}

void ChildProgram::end() {
  if (source_ != none) ::close(static_cast<int>(source_));
  source_ = none;
  kill();
}

bool ChildProgram::wasStopped() const {
  return WIFSIGNALED(status_) && (WTERMSIG(status_) == SIGXCPU || WTERMSIG(status_) == SIGKILL);
}

}  // namespace squat::platform
