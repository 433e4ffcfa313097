#include "plots/Application.h"

#include <QApplication>
#include <clocale>
#include <cstdio>

namespace squat::plots {
namespace {

// A missing XDG_RUNTIME_DIR (servers, containers) is nothing that the user of a figure need hear of.
void leaveOutHousekeeping(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (!message.startsWith(QLatin1String("QStandardPaths: XDG_RUNTIME_DIR")))
    std::fprintf(stderr, "%s\n", qFormatLogMessage(type, context, message).toLocal8Bit().constData());
}

}  // namespace

void ensureApplication(int argc, char** argv) {
  if (QCoreApplication::instance()) return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // Qt keeps references to argc and argv for the life of the application, hence static.
  static char programName[] = "squat";
  static char* fallback[] = {programName, nullptr};
  static int count;
  count = argc > 0 && argv ? argc : 1;
  const QtMessageHandler before = qInstallMessageHandler(leaveOutHousekeeping);
  static QApplication* application = new QApplication(count, argc > 0 && argv ? argv : fallback);
  qInstallMessageHandler(before);
  application->setQuitOnLastWindowClosed(false);
  std::setlocale(LC_NUMERIC, "C");
}

}  // namespace squat::plots
