#include "results/GuardedChild.h"

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
#include <cstring>
#include <utility>

#include "core/Errors.h"
#include "results/Hdf5Handle.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SQUAT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SQUAT_SHADOW_MEMORY 1
#endif
#endif

namespace squat::results {

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

void limitMyself(const ChildLimits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, limits.seconds);
#ifndef SQUAT_SHADOW_MEMORY  // sanitizers reserve terabytes of addresses
  limit(RLIMIT_AS, addressSpaceNow() + limits.memory + (std::size_t{96} << 20));
#endif
  for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGPIPE, SIGXCPU})
    ::signal(number, SIG_DFL);
}

void sendAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto sent = ::write(descriptor, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) ::_exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

[[noreturn]] void child(int out, const ChildLimits& limits, const GuardedChild::Work& work) {
  const auto send = [out](std::span<const std::byte> bytes) { sendAll(out, bytes); };
  const auto sendText = [&](const std::string& text) { send(std::as_bytes(std::span(text))); };
  limitMyself(limits);
  try {
    work(send);
  } catch (const FileError& error) {
    sendText(std::string(1, GuardedChild::refused) + error.location() + '\n' + error.what());
  } catch (...) {
    sendText(std::string(1, GuardedChild::refused) + "\nneeds more memory than allowed");
  }
  ::_exit(0);
}

std::size_t receive(int descriptor, std::span<std::byte> wanted) {
  std::size_t have = 0;
  while (have < wanted.size()) {
    const auto got = ::read(descriptor, wanted.data() + have, wanted.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

double secondsComputed(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

GuardedChild::GuardedChild(std::string path, const ChildLimits& limits, Work work)
    : path_(std::move(path)), limits_(limits), work_(std::move(work)) {
  start();
}

void GuardedChild::start() {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) throw FileError(path_, "", std::string("cannot be read: ") + std::strerror(errno));
  {
    const auto lock = hdf5::lockLibrary();  // so that the child finds the library at rest
    process_ = ::fork();
    if (process_ == 0) {
      // Else the child holds its own pipe open: if its parent is killed, it waits for ever to write.
      ::close(ends[0]);
      child(ends[1], limits_, work_);
    }
  }
  ::close(ends[1]);
  source_ = ends[0];
  waited_ = false;
  if (process_ >= 0) return;
  const int reason = errno;
  ::close(source_);
  source_ = -1, waited_ = true;
  throw FileError(path_, "", std::string("cannot be read: ") + std::strerror(reason));
}

void GuardedChild::end() {
  if (source_ >= 0) ::close(source_);
  if (!waited_) ::kill(process_, SIGKILL);
  wait();
}

GuardedChild::~GuardedChild() { end(); }

void GuardedChild::awaitFirstByte() {
  constexpr int replacements = 2;
  for (int replaced = 0; !hasBegun_ && replaced < replacements;) {
    const double before = secondsComputed(process_);
    pollfd wanted{source_, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, limits_.patience);
    if (ready > 0) break;  // a byte, or its end
    if (ready < 0 || secondsComputed(process_) > before) continue;
    end();
    start();
    ++replaced;
  }
  hasBegun_ = true;
}

void GuardedChild::wait() {
  while (!waited_ && ::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  waited_ = true;
}

std::size_t GuardedChild::receive(std::span<std::byte> wanted) {
  awaitFirstByte();
  return results::receive(source_, wanted);
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
  if (!waited_ && ::waitpid(process_, &status_, WNOHANG) == process_) waited_ = true;
  if (!waited_) ::usleep(100000);
  if (!waited_ && ::waitpid(process_, &status_, WNOHANG) == process_) waited_ = true;
  if (!waited_) {
    ::kill(process_, SIGKILL);
    wait();
    status_ = 0;
  }
  std::string what = "is damaged or malicious: reading it was stopped";
  if (WIFSIGNALED(status_) && (WTERMSIG(status_) == SIGXCPU || WTERMSIG(status_) == SIGKILL))
    what += " for taking too long";
  throw FileError(path_, "", what, "Use a file that this program has written");
}

}  // namespace squat::results
