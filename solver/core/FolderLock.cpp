#include "core/FolderLock.h"

#include "core/Errors.h"
#include "core/platform/Process.h"

namespace squat {

FolderLock::FolderLock(const std::string& folder, const std::string& owner) : lock_(folder + "/.squat-lock") {
  if (lock_.isTaken())
    throw CaseError({{"-o", folder, "a folder that no other run is writing to",
                      "In use by " + lock_.other() + ": wait until it has ended, or choose another folder"}});
  lock_.write(platform::processName(owner) + "\n");  // on a full disk the lock holds without a name
}

}  // namespace squat
