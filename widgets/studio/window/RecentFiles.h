// widgets/studio/window/RecentFiles.h - cases and results that were opened last.
#pragma once

#include <QStringList>

namespace squat::studio {

// The ten last ones, newest first, kept in the user's settings; files that are gone are left out.
QStringList recentFiles();
void addRecentFile(const QString& path);

}  // namespace squat::studio
