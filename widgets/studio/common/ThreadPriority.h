// widgets/studio/common/ThreadPriority.h - the window comes first when it and a computation want a core.
#pragma once

namespace squat::studio {

// Threads that the calling one starts from here on inherit it.
void giveWayToTheWindow();

}  // namespace squat::studio
