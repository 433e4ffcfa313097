// widgets/studio/common/ProcessIdentity.h - whose a file is that a process left: numbers of processes come back, these
// do not.
#pragma once

#include <QString>

namespace squat::studio {

// Whether the process of that number, start and boot ("4711-8123456-1a2b3c4d") is still there.
bool isAlive(const QString& identity);

}  // namespace squat::studio
