#include "studio/window/Recovery.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>

#include "case/CaseFile.h"
#include "studio/common/ProcessIdentity.h"
#include "studio/document/CaseDocument.h"

namespace squat::studio {
namespace {

constexpr int delay = 3000;  // [ms] after the last change
const QLatin1String ending(".case");

}  // namespace

Recovery::Recovery(CaseDocument& document, const QString& folder, QObject* parent)
    : QObject(parent), document_(document), folder_(folder) {
  timer_.setSingleShot(true);
  timer_.setInterval(delay);
  connect(&timer_, &QTimer::timeout, this, &Recovery::saveNow);
  connect(&document_, &CaseDocument::changed, this, [this] { timer_.start(); });
  connect(&document_, &CaseDocument::titleChanged, this, [this] {
    if (!document_.isModified()) QFile::remove(file());
  });
}

Recovery::~Recovery() { QFile::remove(file()); }

QString Recovery::file() const { return QDir(folder_).filePath(ownIdentity() + ending); }

// The first line is the name of the case, the rest the case file.
void Recovery::saveNow() {
  timer_.stop();
  if (held_ || !document_.isModified() || !QDir().mkpath(folder_)) return;
  QSaveFile kept(file());
  if (!kept.open(QIODevice::WriteOnly)) return;
  kept.write("# " + document_.name().toUtf8() + "\n");
  kept.write(QByteArray::fromStdString(cases::writeCase(document_.description())));
  kept.commit();
}

void Recovery::setHeld(bool held) {
  held_ = held;
  if (held)
    QFile::remove(file());
  else
    saveNow();
}

std::optional<Recovery::Found> Recovery::take(const QString& folder) {
  std::optional<Found> found;
  const auto entries = QDir(folder).entryInfoList({"*" + ending}, QDir::Files, QDir::Time);
  for (const QFileInfo& entry : entries) {
    if (isAlive(entry.completeBaseName()) || found) continue;
    QFile kept(entry.filePath());
    if (kept.open(QIODevice::ReadOnly)) {
      const QString name = QString::fromUtf8(kept.readLine()).mid(2).trimmed();
      try {
        found = Found{cases::parseUnfinishedCase(kept.readAll().toStdString(), entry.fileName().toStdString()), name};
      } catch (const std::exception&) {
        // A copy that cannot be read is of no use to anybody.
      }
    }
    kept.remove();
  }
  return found;
}

}  // namespace squat::studio
