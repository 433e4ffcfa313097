#include "core/platform/Caller.h"

#include <windows.h>
// After <windows.h>, whose types it needs.
#include <psapi.h>

#include <chrono>
#include <cstdint>
#include <thread>

#include "core/platform/windows/Names.h"

namespace squat::platform {

namespace {

double secondsComputed() {
  FILETIME start{}, end{}, kernel{}, user{};
  ::GetProcessTimes(::GetCurrentProcess(), &start, &end, &kernel, &user);
  const auto units = [](const FILETIME& time) {
    return std::uint64_t{time.dwHighDateTime} << 32U | time.dwLowDateTime;
  };
  return 1e-7 * static_cast<double>(units(kernel) + units(user));
}

// The limit that a job has counts no time in the system's own code.
void endAfter(std::size_t seconds) {
  std::thread([seconds] {
    while (secondsComputed() < static_cast<double>(seconds)) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ::TerminateProcess(::GetCurrentProcess(), ERROR_NOT_ENOUGH_QUOTA);
  }).detach();
}

void limitMemory(std::size_t more) {
  PROCESS_MEMORY_COUNTERS now{};
  ::GetProcessMemoryInfo(::GetCurrentProcess(), &now, sizeof now);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags =
      JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
  limits.ProcessMemoryLimit = now.PagefileUsage + more + (std::size_t{96} << 20);
  HANDLE job = ::CreateJobObjectW(nullptr, nullptr);  // held until the process ends
  if (!job) return;
  ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  ::AssignProcessToJobObject(job, ::GetCurrentProcess());
}

}  // namespace

std::vector<std::byte> questionOfCaller() {
  std::vector<std::byte> question;
  for (;;) {
    const std::size_t have = question.size();
    constexpr DWORD piece = 1U << 16U;
    question.resize(have + piece);
    DWORD got = 0;
    const bool isRead = ::ReadFile(::GetStdHandle(STD_INPUT_HANDLE), question.data() + have, piece, &got, nullptr) != 0;
    question.resize(have + got);
    if (!isRead || got == 0) return question;
  }
}

bool sendToCaller(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    DWORD sent = 0;
    if (!::WriteFile(::GetStdHandle(STD_OUTPUT_HANDLE), bytes.data(), windows::pieceOf(bytes.size()), &sent, nullptr) ||
        sent == 0)
      return false;
    bytes = bytes.subspan(sent);
  }
  return true;
}

void limitMyself(const OwnLimits& limits) {
  ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);  // no window that waits for somebody
  endAfter(limits.seconds);
  limitMemory(limits.memory);
}

}  // namespace squat::platform
