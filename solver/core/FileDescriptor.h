// solver/core/FileDescriptor.h - what the writers of whole files share (DurableFile.h): descriptors, the signal of a
// limit of size, and what processes that were killed have left.
#pragma once

#include <signal.h>

#include <string>

namespace squat {

// Closed at its end, if not before. Below 0: none.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const std::string& path, int flags);  // opened; made with the rights that the user's mask leaves
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  int get() const { return number_; }
  int closeNow();  // 0 or the error: some file systems report a full disk only here

 private:
  int number_;
};

// Going beyond the limit of file size raises SIGXFSZ, which would end the process: blocked here, taken away after, so
// that it is an error of writing.
class FileSizeSignalBlocked {
 public:
  FileSizeSignalBlocked();
  ~FileSizeSignalBlocked();
  FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
  FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;

 private:
  sigset_t set_{}, before_{};
};

// The name under which a file or folder is written before it takes its own: PATH.part-PID.
std::string partName(const std::string& path);

// Removes PATH.part-PID, file or folder, of processes that no longer run.
void removeLeftOvers(const std::string& path);

}  // namespace squat
