#include "core/platform/Process.h"

#include <windows.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <memory>

#include "core/platform/windows/Names.h"

namespace squat::platform {

namespace {

struct HandleCloser {
  void operator()(void* handle) const { ::CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, HandleCloser>;

Handle processOf(long number) {
  return Handle(::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION | SYNCHRONIZE, FALSE, static_cast<DWORD>(number)));
}

// Who still holds a handle of it keeps a process that has ended.
bool hasEnded(const Handle& process) { return ::WaitForSingleObject(process.get(), 0) == WAIT_OBJECT_0; }

// The start says the boot as well: it is a time of the calendar, in units of 100 ns. Empty where no such process runs.
std::string identityOf(const std::string& number) {
  long value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  const auto process = processOf(value);
  FILETIME start{}, end{}, kernel{}, user{};
  if (!process || hasEnded(process) || !::GetProcessTimes(process.get(), &start, &end, &kernel, &user)) return {};
  return number + "-" + std::to_string(std::uint64_t{start.dwHighDateTime} << 32U | start.dwLowDateTime) + "-0";
}

}  // namespace

long processNumber() { return static_cast<long>(::GetCurrentProcessId()); }

std::string hostName() {
  std::array<wchar_t, 128> host{};
  auto size = static_cast<DWORD>(host.size());
  if (!::GetComputerNameExW(ComputerNameDnsHostname, host.data(), &size)) return {};
  return windows::narrow(host.data()).substr(0, 64);
}

std::string processName(const std::string& owner) {
  return owner.substr(0, 100) + " (process " + std::to_string(processNumber()) + " on " + hostName() + ")";
}

bool isRunning(long number) {
  const auto process = processOf(number);
  return process ? !hasEnded(process) : ::GetLastError() != ERROR_INVALID_PARAMETER;
}

bool isAlive(const std::string& identity) { return identity == identityOf(identity.substr(0, identity.find('-'))); }

void endAtOnce(int code) {
  ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(code));
  ::ExitProcess(static_cast<UINT>(code));  // not reached; says to the compiler that nothing returns
}

}  // namespace squat::platform
