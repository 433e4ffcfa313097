#include "studio/common/WorkFolder.h"

#include <QFileInfo>
#include <QStandardPaths>

namespace squat::studio {

QDir workFolder(const QString& project, const QString& caseFile) {
  if (!project.isEmpty()) return QFileInfo(project).dir();
  if (!caseFile.isEmpty()) return QFileInfo(caseFile).dir();
  return {QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)).filePath("Squat Studio")};
}

}  // namespace squat::studio
