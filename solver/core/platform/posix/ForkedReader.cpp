#include "core/platform/ForkedReader.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <initializer_list>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SQUAT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SQUAT_SHADOW_MEMORY 1
#endif
#endif

namespace squat::platform {

namespace {

void limit(int resource, rlim_t maximum) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? maximum : std::min(maximum, now.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

[[maybe_unused]] std::size_t addressSpaceNow() {
  unsigned long pages = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limitMyself(const ForkedReader::Limits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, limits.seconds);
#ifndef SQUAT_SHADOW_MEMORY  // sanitizers reserve terabytes of addresses
  limit(RLIMIT_AS, addressSpaceNow() + limits.memory + (std::size_t{96} << 20));
#endif
  for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGPIPE, SIGXCPU})
    ::signal(number, SIG_DFL);
}

void sendAll(int out, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto sent = ::write(out, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) ::_exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

[[noreturn]] void child(int out, const ForkedReader::Work& work, const ForkedReader::Limits& limits) {
  limitMyself(limits);
  try {
    work([out](std::span<const std::byte> bytes) { sendAll(out, bytes); });
  } catch (...) {
    // It would unwind what belongs to the parent: its locks and files would be removed.
    ::_exit(1);
  }
  ::_exit(0);
}

}  // namespace

std::error_code ForkedReader::start(const Work& work, const Limits& limits) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return {errno, std::generic_category()};
  process_ = ::fork();
  if (process_ == 0) {
    // Else the child holds its own pipe open: if its parent is killed, it waits for ever to write.
    ::close(ends[0]);
    child(ends[1], work, limits);
  }
  const int reason = errno;
  ::close(ends[1]);
  hasEnded_ = process_ < 0;
  if (!hasEnded_) {
    source_ = ends[0];
    return {};
  }
  ::close(ends[0]);
  return {reason, std::generic_category()};
}

ForkedReader::Waited ForkedReader::wait(std::chrono::milliseconds patience) const {
  pollfd wanted{source_, POLLIN, 0};
  const int ready = ::poll(&wanted, 1, static_cast<int>(patience.count()));
  return ready > 0 ? Waited::untilBytes : ready == 0 ? Waited::inVain : Waited::interrupted;
}

std::size_t ForkedReader::receive(std::span<std::byte> wanted) {
  std::size_t have = 0;
  while (have < wanted.size()) {
    const auto got = ::read(source_, wanted.data() + have, wanted.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

double ForkedReader::secondsComputed() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool ForkedReader::hasEnded() {
  if (!hasEnded_ && ::waitpid(process_, &status_, WNOHANG) == process_) hasEnded_ = true;
  return hasEnded_;
}

void ForkedReader::waitForEnd() {
  while (!hasEnded_ && ::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  hasEnded_ = true;
}

void ForkedReader::kill() {
  if (!hasEnded_) ::kill(process_, SIGKILL);
  waitForEnd();
}

void ForkedReader::end() {
  if (source_ >= 0) ::close(source_);
  source_ = -1;
  kill();
}

bool ForkedReader::wasStopped() const {
  return WIFSIGNALED(status_) && (WTERMSIG(status_) == SIGXCPU || WTERMSIG(status_) == SIGKILL);
}

}  // namespace squat::platform
