// solver/core/platform/FileLock.h - one owner of a file at a time.
#pragma once

#include <string>

namespace squat::platform {

// An advisory lock of the operating system (flock) on a file, made where missing and removed at the end of its life; a
// process that dies loses the lock and leaves the file. Where the file system has no locks nothing is held, but the
// owner's text still stands in the file; where the file cannot be made there is neither.
class FileLock {
 public:
  explicit FileLock(std::string path);  // tries once
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool held() const { return isLocked_; }
  bool isTaken() const { return !other_.empty(); }
  const std::string& other() const { return other_; }  // what the one who holds it has written there
  const std::string& left() const { return left_; }    // what an owner that died has left there; empty: none did

  // Replaces what stands in the file, for others to read; on the disk when it returns. False where it
  // cannot be written.
  bool write(const std::string& text);
  std::string path() const { return path_; }

 private:
  std::string path_, other_, left_, written_;
  int file_ = -1;
  bool isLocked_ = false;
};

}  // namespace squat::platform
