#include "core/platform/Threads.h"

#include <pthread/qos.h>

namespace squat::platform {

long timesCoreWasLost() { return 0; }  // counted for the whole process only

void giveWay() { ::pthread_set_qos_class_self_np(QOS_CLASS_UTILITY, 0); }

}  // namespace squat::platform
