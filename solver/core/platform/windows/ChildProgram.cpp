#include "core/platform/ChildProgram.h"

#include <windows.h>

#include <string>
#include <utility>
#include <vector>

#include "core/platform/windows/Names.h"

namespace squat::platform {

namespace {

constexpr UINT stopped = ERROR_NOT_ENOUGH_QUOTA;  // the code of who was ended for computing too long

HANDLE handleOf(std::intptr_t number) { return reinterpret_cast<HANDLE>(number); }
std::intptr_t numberOf(HANDLE handle) { return reinterpret_cast<std::intptr_t>(handle); }

void close(std::intptr_t& number) {
  if (number != -1) ::CloseHandle(handleOf(number));
  number = -1;
}

// One end of each stays here, the other one is the child's.
struct Pipes {
  HANDLE questionOut = nullptr, questionIn = nullptr, answerOut = nullptr, answerIn = nullptr;
  bool open() {
    return ::CreatePipe(&questionIn, &questionOut, nullptr, 0) && ::CreatePipe(&answerIn, &answerOut, nullptr, 0) &&
           ::SetHandleInformation(questionIn, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT) &&
           ::SetHandleInformation(answerOut, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
  }
  ~Pipes() {
    for (HANDLE each : {questionOut, questionIn, answerOut, answerIn})
      if (each) ::CloseHandle(each);
  }
};

// The child gets the handles of `streams` and no other one; null where it cannot be started.
HANDLE started(const std::filesystem::path& program, HANDLE (&streams)[2]) {
  SIZE_T size = 0;
  ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
  std::vector<std::byte> room(size);
  STARTUPINFOEXW how{};
  how.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room.data());
  if (!::InitializeProcThreadAttributeList(how.lpAttributeList, 1, 0, &size)) return nullptr;
  how.StartupInfo.cb = sizeof how;
  how.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  how.StartupInfo.hStdInput = streams[0];
  how.StartupInfo.hStdOutput = streams[1];
  std::wstring words = L"\"" + program.filename().wstring() + L"\"";
  PROCESS_INFORMATION made{};
  const bool isMade =
      ::UpdateProcThreadAttribute(how.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, streams, sizeof streams,
                                  nullptr, nullptr) &&
      ::CreateProcessW(program.c_str(), words.data(), nullptr, nullptr, TRUE,
                       EXTENDED_STARTUPINFO_PRESENT | CREATE_NO_WINDOW, nullptr, nullptr, &how.StartupInfo, &made);
  const DWORD reason = ::GetLastError();
  ::DeleteProcThreadAttributeList(how.lpAttributeList);
  ::SetLastError(reason);
  if (!isMade) return nullptr;
  ::CloseHandle(made.hThread);
  return made.hProcess;
}

// The child ends with this process, however this one ends.
HANDLE commonFate(HANDLE child) {
  HANDLE job = ::CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (!job) return INVALID_HANDLE_VALUE;
  ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  ::AssignProcessToJobObject(job, child);
  return job;
}

// To a child that has died nothing can be sent; receive() will see that.
void sendAll(HANDLE channel, std::span<const std::byte> bytes) {
  DWORD sent = 0;
  while (!bytes.empty() && ::WriteFile(channel, bytes.data(), windows::pieceOf(bytes.size()), &sent, nullptr))
    bytes = bytes.subspan(sent);
}

}  // namespace

std::error_code ChildProgram::start(const std::filesystem::path& program, std::span<const std::byte> question) {
  Pipes pipes;
  if (!pipes.open()) return windows::lastError();
  HANDLE streams[2] = {pipes.questionIn, pipes.answerOut};
  HANDLE child = started(program, streams);
  if (!child) return windows::lastError();
  process_ = numberOf(child), fate_ = numberOf(commonFate(child)), hasEnded_ = false;
  source_ = numberOf(std::exchange(pipes.answerIn, nullptr));
  ::CloseHandle(std::exchange(pipes.questionIn, nullptr));  // so that the child's end ends the writing
  sendAll(pipes.questionOut, question);
  return {};
}

std::size_t ChildProgram::receive(std::span<std::byte> wanted) {
  std::size_t have = 0;
  while (have < wanted.size()) {
    DWORD got = 0;
    const auto size = windows::pieceOf(wanted.size() - have);
    if (!::ReadFile(handleOf(source_), wanted.data() + have, size, &got, nullptr) || got == 0) break;
    have += got;
  }
  return have;
}

bool ChildProgram::hasEnded() {
  if (!hasEnded_ && ::WaitForSingleObject(handleOf(process_), 0) == WAIT_OBJECT_0) waitForEnd();
  return hasEnded_;
}

void ChildProgram::waitForEnd() {
  if (hasEnded_) return;
  ::WaitForSingleObject(handleOf(process_), INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(handleOf(process_), &code);
  status_ = static_cast<int>(code);
  hasEnded_ = true;
  close(process_);
  close(fate_);
}

void ChildProgram::kill() {
  if (!hasEnded_) ::TerminateProcess(handleOf(process_), stopped);
  waitForEnd();
}

void ChildProgram::end() {
  close(source_);
  kill();
}

bool ChildProgram::wasStopped() const { return static_cast<UINT>(status_) == stopped; }

}  // namespace squat::platform
