#include "studio/common/ThreadPriority.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace squat::studio {

// Linux keeps the value for each thread.
void giveWayToTheWindow() {
  constexpr int politeness = 5;
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), politeness);
}

}  // namespace squat::studio
