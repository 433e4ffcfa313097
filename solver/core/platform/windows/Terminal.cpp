#include "core/platform/Terminal.h"

#include <fcntl.h>
#include <io.h>
#include <stdio.h>
#include <windows.h>

#include <initializer_list>

namespace squat::platform {

bool isTerminal(std::FILE* stream) { return ::_isatty(::_fileno(stream)) != 0; }

std::size_t columnsOfTerminal(std::FILE* stream) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  HANDLE console = reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream)));
  if (!::GetConsoleScreenBufferInfo(console, &info)) return 0;
  return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

// What is printed has the same bytes as elsewhere: no carriage returns, and UTF-8.
void keepStandardStreamsOpen() {
  for (FILE* stream : {stdin, stdout, stderr}) {
    if (::_fileno(stream) < 0) static_cast<void>(::freopen("NUL", stream == stdin ? "rb" : "wb", stream));
    ::_setmode(::_fileno(stream), _O_BINARY);
  }
  ::SetConsoleOutputCP(CP_UTF8);
}

}  // namespace squat::platform
