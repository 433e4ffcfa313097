#include "studio/common/ProcessIdentity.h"

#include <QFile>

namespace squat::studio {
namespace {

QByteArray firstLine(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readLine() : QByteArray();
}

// Empty where no such process runs.
QString identityOf(const QString& process) {
  const QByteArray stat = firstLine("/proc/" + process + "/stat");  // 1234 (its name) S ... the 22nd is the start
  const auto fields = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
  if (fields.size() < 20) return {};
  if (fields[0] == "Z" || fields[0] == "X") return {};  // has ended; nobody has asked yet how
  const QString boot = QString::fromLatin1(firstLine("/proc/sys/kernel/random/boot_id").left(8));
  return QStringLiteral("%1-%2-%3").arg(process, QString::fromLatin1(fields[19]), boot);
}

}  // namespace

bool isAlive(const QString& identity) { return identity == identityOf(identity.section('-', 0, 0)); }

}  // namespace squat::studio
