#include "core/DurableFile.h"

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/Errors.h"
#include "core/PartFile.h"
#include "core/platform/File.h"
#include "core/platform/Signals.h"

namespace squat {

namespace {

namespace fs = std::filesystem;

std::string folderOf(const std::string& path) {
  const auto parent = fs::path(path).parent_path();
  return parent.empty() ? std::string(".") : parent.string();
}

[[noreturn]] void cannotWrite(const std::string& path, std::error_code error, std::size_t needed) {
  std::string what = "cannot be written: " + error.message() + " (" + std::to_string(needed) + " bytes needed";
  std::error_code notKnown;
  const auto space = fs::space(folderOf(path), notKnown);
  if (!notKnown) what += ", " + std::to_string(space.available) + " free";
  what += ")";
  throw FileError(path, "", what,
                  platform::isLackOfRoom(error)
                      ? "Free some space or choose another folder; what stood there before is untouched"
                      : "Check that the folder exists and may be written, or choose another one");
}

// The earlier file gets a second name before the new one takes the first: there is a file under `path` at all times.
void keepPrevious(const std::string& path) {
  const auto previous = path + ".previous";
  removeLeftOvers(previous);
  const auto link = partName(previous);
  std::error_code linking;
  std::remove(link.c_str());
  fs::create_hard_link(path, link, linking);
  if (!linking)
    platform::rename(link, previous);
  else if (linking != std::errc::no_such_file_or_directory)
    platform::rename(path, previous);  // a file system without links
  // Renaming does nothing where both names stand for one file already (a kill between the two renames of last time).
  std::remove(link.c_str());
}

}  // namespace

void writeDurably(const std::string& path, std::span<const std::byte> bytes,
                  const std::function<void(const std::string&)>& verify, Previous previous) {
  removeLeftOvers(path);
  const auto part = partName(path);
  struct Remover {
    const std::string& file;
    bool armed = true;
    ~Remover() {
      if (armed) std::remove(file.c_str());
    }
  } remover{part};

  {
    const platform::FileSizeSignalBlocked blocked;
    platform::File file(part, platform::File::Access::replace);
    if (file.openingError()) {
      remover.armed = false;
      cannotWrite(path, file.openingError(), bytes.size());
    }
    auto error = file.write(bytes);
    if (!error) error = file.flush();
    const auto closing = file.close();
    if (error || closing) cannotWrite(path, error ? error : closing, bytes.size());
  }
  if (verify) verify(part);
  if (previous == Previous::kept) keepPrevious(path);
  if (const auto renaming = platform::rename(part, path)) cannotWrite(path, renaming, bytes.size());
  remover.armed = false;
  platform::flushFolder(folderOf(path));  // makes the rename itself durable
}

void writeDurably(const std::string& path, std::string_view text) {
  writeDurably(path, std::as_bytes(std::span(text)));
}

void keepInputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (const auto& input : inputs)
    for (const auto& output : outputs) {
      std::error_code ignored;
      if (fs::equivalent(input, output, ignored))
        throw CaseError({{"-o", output, "a folder in which no file that is written replaces one that was read",
                          "Choose another folder, for example -o out"}});
    }
}

void makeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw FileError(folder, "", "the folder cannot be made: " + (error ? error.message() : "a file has its name"),
                    "Choose another folder with -o");
}

std::string readWholeFile(const std::string& path, std::size_t largest) {
  platform::File file(path, platform::File::Access::read);
  auto error = file.openingError();
  const auto state = error ? platform::File::State() : file.state(error);
  if (error) throw FileError(path, "", "cannot be read: " + error.message(), "Check the path");
  if (!state.isRegular) throw FileError(path, "", "is not a regular file", "Name a file");
  if (state.size > largest)
    throw FileError(path, "", "is larger than the " + std::to_string(largest) + " bytes that are read", "Cut it down");
  std::string text(static_cast<std::size_t>(state.size), '\0');
  std::size_t have = 0;
  while (have < text.size()) {
    const auto got = file.read(std::as_writable_bytes(std::span(text).subspan(have)), error);
    if (error) throw FileError(path, "", "cannot be read: " + error.message());
    if (got == 0) break;
    have += got;
  }
  text.resize(have);
  return text;
}

}  // namespace squat
