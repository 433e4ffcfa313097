// solver/core/platform/File.h - open files, and their way to the disk. Errors are returned, in the generic category.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <system_error>

namespace squat::platform {

// Closed at its end, if not before. Processes that this one starts do not inherit it.
class File {
 public:
  enum class Access {
    read,     // opened without waiting: a named pipe must not hold the program
    replace,  // made with the rights that the user's mask leaves, or emptied
  };
  struct State {
    bool isRegular = false;  // no folder, pipe or device
    std::uint64_t size = 0;  // [bytes]
  };

  File(const std::string& path, Access access);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::error_code openingError() const { return openingError_; }  // none: it is open
  State state(std::error_code& error) const;
  // The next bytes, as many as come at once; 0: the end, or an error.
  std::size_t read(std::span<std::byte> into, std::error_code& error);
  // All of the bytes that begin at `from`; false where the file is shorter or cannot be read.
  bool readAt(std::uint64_t from, std::span<std::byte> into) const;
  std::error_code write(std::span<const std::byte> bytes);  // all of them
  std::error_code flush();                                  // what was written is on the disk then
  std::error_code close();  // to be called after writing: some file systems report a full disk only here

 private:
  int number_;  // of the open file; below 0: none
  std::error_code openingError_;
};

// Gives a file or folder another name; a file that had the name is gone then.
std::error_code rename(const std::string& from, const std::string& to);

// Makes durable that files in it were made, renamed or removed. Some file systems refuse, no harm.
void flushFolder(const std::string& folder);

bool mayRead(const std::string& path);

// Whether an error of writing says that the disk, the user's share of it or the largest size of a file is used up.
bool isLackOfRoom(std::error_code error);

}  // namespace squat::platform
