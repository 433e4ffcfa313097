#include "studio/window/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace squat::studio {

QStringList recentFiles() {
  QStringList there;
  for (const QString& path : QSettings().value("recent").toStringList())
    if (QFileInfo::exists(path)) there << path;
  return there;
}

void addRecentFile(const QString& path) {
  constexpr int maximum = 10;
  QStringList paths = recentFiles();
  const QString whole = QFileInfo(path).absoluteFilePath();
  paths.removeAll(whole);
  paths.prepend(whole);
  QSettings().setValue("recent", QStringList(paths.mid(0, maximum)));
}

}  // namespace squat::studio
