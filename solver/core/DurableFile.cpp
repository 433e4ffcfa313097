#include "core/DurableFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/Errors.h"
#include "core/FileDescriptor.h"

namespace squat {

namespace {

namespace fs = std::filesystem;

std::string folderOf(const std::string& path) {
  const auto parent = fs::path(path).parent_path();
  return parent.empty() ? std::string(".") : parent.string();
}

std::string reasonText(int error) { return std::generic_category().message(error); }

[[noreturn]] void cannotWrite(const std::string& path, int error, std::size_t needed) {
  std::string what = "cannot be written: " + reasonText(error) + " (" + std::to_string(needed) + " bytes needed";
  struct statvfs space {};
  if (::statvfs(folderOf(path).c_str(), &space) == 0)
    what += ", " + std::to_string(static_cast<unsigned long long>(space.f_bavail) * space.f_frsize) + " free";
  what += ")";
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  throw FileError(path, "", what,
                  full ? "Free some space or choose another folder; what stood there before is untouched"
                       : "Check that the folder exists and may be written, or choose another one");
}

int writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

// The earlier file gets a second name before the new one takes the first: there is a file under `path` at all times.
void keepPrevious(const std::string& path) {
  const auto previous = path + ".previous";
  removeLeftOvers(previous);
  const auto link = partName(previous);
  ::unlink(link.c_str());
  if (::link(path.c_str(), link.c_str()) == 0)
    ::rename(link.c_str(), previous.c_str());
  else if (errno != ENOENT)
    ::rename(path.c_str(), previous.c_str());  // a file system without links
  // Renaming does nothing where both names stand for one file already (a kill between the two renames of last time).
  ::unlink(link.c_str());
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
      if (armed) ::unlink(file.c_str());
    }
  } remover{part};

  {
    const FileSizeSignalBlocked blocked;
    FileDescriptor file(part, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.get() < 0) {
      remover.armed = false;
      cannotWrite(path, errno, bytes.size());
    }
    int error = writeAll(file.get(), bytes);
    if (error == 0 && ::fsync(file.get()) != 0) error = errno;
    const int closing = file.closeNow();
    if (error != 0 || closing != 0) cannotWrite(path, error != 0 ? error : closing, bytes.size());
  }
  if (verify) verify(part);
  if (previous == Previous::kept) keepPrevious(path);
  if (::rename(part.c_str(), path.c_str()) != 0) cannotWrite(path, errno, bytes.size());
  remover.armed = false;
  const FileDescriptor folder(folderOf(path), O_RDONLY | O_DIRECTORY);
  if (folder.get() >= 0) ::fsync(folder.get());  // makes the rename itself durable; some file systems refuse, no harm
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
  // Not blocking: a named pipe must not hold the program.
  const FileDescriptor file(path, O_RDONLY | O_NONBLOCK);
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0)
    throw FileError(path, "", "cannot be read: " + reasonText(errno), "Check the path");
  if (!S_ISREG(status.st_mode)) throw FileError(path, "", "is not a regular file", "Name a file");
  if (static_cast<unsigned long long>(status.st_size) > largest)
    throw FileError(path, "", "is larger than the " + std::to_string(largest) + " bytes that are read", "Cut it down");
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t have = 0;
  while (have < text.size()) {
    const auto got = ::read(file.get(), text.data() + have, text.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileError(path, "", "cannot be read: " + reasonText(errno));
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  text.resize(have);
  return text;
}

}  // namespace squat
