// solver/core/platform/Cores.h - the cores of the machine and their caches.
#pragma once

namespace squat::platform {

int usableCores();        // that this process may run on; 0: not known
double lastLevelCache();  // [bytes] of all cores together; 0: not known

}  // namespace squat::platform
