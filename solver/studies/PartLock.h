// solver/studies/PartLock.h - one process a part, also on folders that several machines share.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "core/Monitor.h"
#include "core/platform/FileLock.h"
#include "studies/Partition.h"

namespace squat::studies {

inline constexpr std::chrono::milliseconds kPartBeat{5000};

// Holds FOLDER/COMMAND-slice-3-of-16.lock. Within one machine, and on shared file systems that pass flock() on to their
// server, the operating system's lock decides at once. Others keep such a lock to the machine: there the owner writes a
// new beat into the file again and again, and who finds the file of another machine waits for three beats whether it
// changes. No clock is read or compared. What remains: two machines that start the same part within the same moment on
// such a file system both compute it, until the first of them looks at the file and stops; the table is whole
// either way.
class PartLock {
 public:
  // Throws CaseError with the owner's name where another process computes the part.
  PartLock(const std::string& command, const Partition& part, const std::string& folder, std::chrono::milliseconds beat,
           Monitor& monitor);
  ~PartLock();
  PartLock(const PartLock&) = delete;
  PartLock& operator=(const PartLock&) = delete;

  // Throws CaseError where another machine has taken the file over.
  void requireOwn() const;

 private:
  void watchOther(Monitor& monitor) const;
  [[noreturn]] void refuse(const std::string& owner) const;
  void beatUntil(const std::stop_token& stop);

  platform::FileLock lock_;
  std::string part_, folder_, name_;
  std::chrono::milliseconds beat_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::jthread beating_;  // last: ends first
};

}  // namespace squat::studies
