// solver/core/FolderLock.h - one owner of an output folder at a time.
#pragma once

#include <string>

#include "core/platform/FileLock.h"

namespace squat {

// Holds FOLDER/.squat-lock, a FileLock with the owner's name in it, until the end of its life; a process that dies
// loses it. Throws CaseError that names the owner where another process, or another lock of this one, holds it. The
// folder must exist. Where the file system has no locks, or the file cannot be made, there is no owner and nothing is
// refused.
class FolderLock {
 public:
  // `owner` says what writes there, for the message to the other: "squat run light-defect".
  FolderLock(const std::string& folder, const std::string& owner);
  bool held() const { return lock_.held(); }

 private:
  platform::FileLock lock_;
};

}  // namespace squat
