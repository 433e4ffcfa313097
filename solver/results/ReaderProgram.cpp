#include "results/ReaderProgram.h"

#include <cstdlib>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "core/Errors.h"
#include "core/platform/ProgramPath.h"
#include "results/Hdf5Handle.h"

namespace squat::results {

namespace fs = std::filesystem;

namespace {

// Who asked does not listen any more.
struct NobodyListens {};

void sendBack(std::span<const std::byte> bytes) {
  if (!platform::sendToCaller(bytes)) throw NobodyListens();
}

void sendRefusal(const std::string& why) {
  const std::string text = kRefused + why;
  sendBack(std::as_bytes(std::span(text)));
}

void answer(const ReaderWorks& works, const ReaderCall& call) {
  const auto work = works.find(call.work);
  ReaderArguments arguments(call.arguments);
  try {
    if (work == works.end()) return sendRefusal("\ncannot be read: squat-reader belongs to another version");
    const auto lock = hdf5::lockLibrary();  // which silences the library, too
    work->second(arguments, sendBack);
  } catch (const FileError& error) {
    sendRefusal(error.location() + '\n' + error.what());
  } catch (const std::exception&) {
    sendRefusal("\nneeds more memory than allowed");
  }
}

}  // namespace

fs::path readerProgram() {
  if (const char* named = std::getenv("SQUAT_READER"); named && *named) return named;
  const auto program = platform::programPath(), library = platform::ownLibrary();
  const auto folder = (library.empty() ? program : library).parent_path();
  std::error_code none;
  for (const auto& place : {folder, folder.parent_path() / "libexec" / "squat-studio"})
    for (const char* name : {"squat-reader", "squat-reader.exe"})
      if (fs::is_regular_file(place / name, none)) return place / name;
  return {};
}

std::vector<std::byte> questionOf(const ReaderCall& call, const platform::OwnLimits& limits) {
  ReaderCall whole;
  whole.number(limits.memory).number(limits.seconds).text(call.work);
  whole.arguments.insert(whole.arguments.end(), call.arguments.begin(), call.arguments.end());
  return whole.arguments;
}

int answerCaller(const ReaderWorks& works) {
  const auto question = platform::questionOfCaller();
  try {
    ReaderArguments arguments(question);
    platform::OwnLimits limits;
    limits.memory = arguments.number();
    limits.seconds = arguments.number();
    ReaderCall call{arguments.text()};
    call.arguments = arguments.rest();
    platform::limitMyself(limits);
    answer(works, call);
  } catch (const std::exception&) {
    return 2;  // started by hand
  } catch (const NobodyListens&) {
    return 1;
  }
  return 0;
}

}  // namespace squat::results
