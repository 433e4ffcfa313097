#include "studio/runs/UnsavedResults.h"

#include <QDir>
#include <QFile>

#include "results/ResultFile.h"
#include "studio/common/ProcessIdentity.h"

namespace squat::studio {
namespace {

const QLatin1String resultEnding(".h5");

}  // namespace

KeptFile::~KeptFile() {
  if (!path_.isEmpty()) QFile::remove(path_);
}

// Whose it is, a number, and behind a blank the stem, as far as a file's name takes it.
QString UnsavedResults::nextFile(const QString& stem) {
  if (folder_.isEmpty()) return {};
  QDir().mkpath(folder_);      // where that fails, so does the writing, and that is noticed
  constexpr int longest = 60;  // a letter may take three bytes of the 255 that a name has
  QString name = stem.left(longest);
  if (name.size() > 0 && name.back().isHighSurrogate()) name.chop(1);
  name.replace('/', '_');
  return QDir(folder_).filePath(QStringLiteral("%1-%2 %3").arg(ownIdentity()).arg(++made_).arg(name) + resultEnding);
}

QString UnsavedResults::stemOf(const QString& file) {
  return QFileInfo(file).fileName().section(' ', 1).chopped(resultEnding.size());
}

void UnsavedResults::write(const QString& file, const results::RunResult& result) {
  if (file.isEmpty() || !result.complete) return;
  try {
    results::writeResult(file.toStdString(), result);
  } catch (const std::exception&) {
    // The disk is full, or memory is: the run's checkpoint stays then.
  }
}

QStringList UnsavedResults::takeLeft() {
  QStringList taken;
  if (folder_.isEmpty()) return taken;
  const auto entries = QDir(folder_).entryInfoList({"*" + resultEnding}, QDir::Files, QDir::Time | QDir::Reversed);
  for (const QFileInfo& entry : entries) {
    if (isAlive(entry.fileName().section(' ', 0, 0).section('-', 0, 2))) continue;
    const QString own = nextFile(stemOf(entry.fileName()));
    if (QFile::rename(entry.filePath(), own)) taken << own;
  }
  return taken;
}

QString UnsavedResults::putAside(const QString& file) {
  const QString aside = file + ".unreadable";
  return QFile::rename(file, aside) ? aside : file;
}

}  // namespace squat::studio
