// widgets/studio/common/ProcessIdentity.h - whose a file is that a process left: numbers of processes come back, these
// do not.
#pragma once

#include <QString>

namespace squat::studio {

// Number, start and boot of this process, two hyphens between: part of a file's name.
QString ownIdentity();

// Whether the process of that identity is still there.
bool isAlive(const QString& identity);

}  // namespace squat::studio
