// Reading with a child process between the file and us: whatever the file does to the HDF5 library, it does there.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "results/Hdf5.h"
#include "results/Hdf5Handle.h"
#include "results/Hdf5Reader.h"
#include "results/TreeStream.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SQUAT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SQUAT_SHADOW_MEMORY 1
#endif
#endif

namespace squat::results {

namespace {

constexpr char kTree = 'T';
constexpr char kRefused = 'E';

void limit(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? most : std::min(most, now.rlim_max);
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

void limitMyself(std::size_t fileBytes, const Hdf5Limits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  // One second and what honest unpacking of so many bytes takes (5 MB/s is ten times slower than measured).
  limit(RLIMIT_CPU, 1 + fileBytes / 5000000);
#ifndef SQUAT_SHADOW_MEMORY  // sanitizers reserve terabytes of addresses
  limit(RLIMIT_AS, addressSpaceNow() + limits.bytes + (std::size_t{96} << 20));
#else
  (void)limits;
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

[[noreturn]] void child(int out, const std::string& path, std::size_t fileBytes, const Hdf5Limits& limits) {
  const auto send = [out](std::span<const std::byte> bytes) { sendAll(out, bytes); };
  const auto sendText = [&](const std::string& text) { send(std::as_bytes(std::span(text))); };
  limitMyself(fileBytes, limits);
  try {
    const auto tree = hdf5::readTree(path, limits);
    sendText(std::string(1, kTree));
    encodeTree(tree, send);
  } catch (const FileError& error) {
    sendText(std::string(1, kRefused) + error.location() + '\n' + error.what());
  } catch (...) {
    sendText(std::string(1, kRefused) + "\nneeds more memory than allowed");
  }
  ::_exit(0);
}

class Pipe {
 public:
  explicit Pipe(const std::string& path) {
    if (::pipe2(ends_, O_CLOEXEC) != 0)
      throw FileError(path, "", std::string("cannot be read: ") + std::strerror(errno));
  }
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int end(int which) const { return ends_[which]; }
  void closeEnd(int which) {
    if (ends_[which] >= 0) ::close(ends_[which]);
    ends_[which] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
};

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

std::string receiveText(int descriptor) {
  std::string text(4096, '\0');
  text.resize(receive(descriptor, std::as_writable_bytes(std::span(text))));
  return text;
}

struct ChildEnd {  // waits for the child in any case
  pid_t process;
  int status = 0;
  bool waited = false;
  void wait() {
    while (!waited && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    waited = true;
  }
  ~ChildEnd() {
    if (!waited) ::kill(process, SIGKILL);
    wait();
  }
};

[[noreturn]] void childDied(const std::string& path, int status) {
  std::string what = "is damaged or made to do harm: reading it was stopped";
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    what += " for taking too long";
  throw FileError(path, "", what, "Use a file that this program has written");
}

}  // namespace

ArrayTree readOwnHdf5(const std::string& path, const Hdf5Limits& limits) {
  const auto lock = hdf5::lockLibrary();
  return hdf5::readTree(path, limits);
}

ArrayTree readHdf5(const std::string& path, const Hdf5Limits& limits) {
  std::error_code ignored;
  const auto fileBytes =
      std::filesystem::is_regular_file(path, ignored) ? std::filesystem::file_size(path, ignored) : 0;
  Pipe pipe(path);
  pid_t process = -1;
  {
    const auto lock = hdf5::lockLibrary();  // so that the child finds the library at rest
    process = ::fork();
    if (process == 0) child(pipe.end(1), path, fileBytes, limits);
  }
  if (process < 0) throw FileError(path, "", std::string("cannot be read: ") + std::strerror(errno));
  pipe.closeEnd(1);
  ChildEnd end{process};
  char kind = 0;
  if (receive(pipe.end(0), std::as_writable_bytes(std::span(&kind, 1))) != 1) {
    end.wait();
    childDied(path, end.status);
  }
  if (kind == kRefused) {
    const auto text = receiveText(pipe.end(0));
    const auto split = std::min(text.find('\n'), text.size());
    const auto location = text.substr(0, split);
    auto what = split < text.size() ? text.substr(split + 1) : text;
    const auto prefix = path + (location.empty() ? "" : ", " + location) + ": ";  // FileError puts it before once more
    if (what.compare(0, prefix.size(), prefix) == 0) what.erase(0, prefix.size());
    throw FileError(path, location, what);
  }
  const int source = pipe.end(0);
  try {
    auto tree =
        decodeTree([source](std::span<std::byte> wanted) { return receive(source, wanted); }, path, 2 * limits.bytes);
    end.wait();
    return tree;
  } catch (const FileError&) {
    pipe.closeEnd(0);
    end.wait();
    childDied(path, end.status);
  }
}

}  // namespace squat::results
