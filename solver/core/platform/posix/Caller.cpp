#include "core/platform/Caller.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/platform/posix/System.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SQUAT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SQUAT_SHADOW_MEMORY 1
#endif
#endif

namespace squat::platform {

namespace {

// The resources are numbers in one library and names in another.
template <typename Resource>
void limit(Resource resource, rlim_t maximum) {
  rlimit now{};
  if (::getrlimit(resource, &now) != 0) return;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? maximum : std::min(maximum, now.rlim_max);
  ::setrlimit(resource, &now);
}

}  // namespace

std::vector<std::byte> questionOfCaller() {
  std::vector<std::byte> question;
  for (;;) {
    const std::size_t have = question.size(), piece = std::size_t{1} << 16;
    question.resize(have + piece);
    const auto got = ::read(STDIN_FILENO, question.data() + have, piece);
    question.resize(have + static_cast<std::size_t>(std::max<long>(got, 0)));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return question;
  }
}

bool sendToCaller(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto sent = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

void limitMyself([[maybe_unused]] const OwnLimits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, limits.seconds);
#ifndef SQUAT_SHADOW_MEMORY  // sanitizers reserve terabytes of addresses
  limit(RLIMIT_AS, addressSpaceNow() + limits.memory + (std::size_t{96} << 20));
#endif
}

}  // namespace squat::platform
