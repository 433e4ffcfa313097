// widgets/studio/common/WorkFolder.h - where files of the work go that the user has not named.
#pragma once

#include <QDir>
#include <QString>

namespace squat::studio {

// Beside the project; without one, beside the file of the case; of a case that is in no file yet, in the folder "Squat
// Studio" of the user's documents. Both paths may be empty.
QDir workFolder(const QString& project, const QString& caseFile);

}  // namespace squat::studio
