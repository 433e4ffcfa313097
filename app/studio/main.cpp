// squat-studio - the desktop program.
#include <QApplication>
#include <QDir>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <clocale>
#include <iostream>

#include "case/ShippedCases.h"
#include "commands/ExitCodes.h"
#include "commands/PaperTable.h"
#include "core/ProgramVersion.h"
#include "core/platform/Memory.h"
#include "simulation/RunCase.h"
#include "simulation/WarmState.h"
#include "studio/Arguments.h"
#include "studio/Screenshot.h"
#include "studio/common/EarlierSettings.h"
#include "studio/common/MessageBar.h"
#include "studio/window/MainWindow.h"

namespace {

std::vector<squat::studio::ComparedRow> comparedRows(const squat::results::RunResult& result) {
  std::vector<squat::studio::ComparedRow> rows;
  for (const auto& row : squat::commands::paperRows(result))
    rows.push_back({QString::fromStdString(row.what), QString::fromStdString(row.ours),
                    QString::fromStdString(row.paper), QString::fromStdString(row.verdict)});
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  squat::platform::keepMemorySteady();
  const bool pictureOnly = squat::studio::wantsScreenshot(argc, argv);
  const bool noDisplay = qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
  // A picture needs no display, so one that is named but not there must not matter.
  if ((pictureOnly && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) ||
      (squat::studio::wantsWords(argc, argv) && noDisplay))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  if (noDisplay && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    std::cerr << "squat-studio: no display found (DISPLAY and WAYLAND_DISPLAY are empty); use `squat` or "
                 "--screenshot, which need none\n";
    return squat::commands::kCaseWrong;
  }
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // strtod and printf of the solver keep the decimal point
  QApplication::setApplicationName("squat-studio");
  QApplication::setOrganizationDomain("squat-studio");  // the folder of the settings; those of other data stay
  QApplication::setApplicationVersion(QString::fromStdString(squat::programVersionText()));
  const QString icon = QString::fromStdString((squat::cases::resourcesFolder() / "icons/squat-studio.svg").string());
  QApplication::setWindowIcon(QIcon(icon));
  const squat::studio::Arguments arguments = squat::studio::readArguments();
  // The user's layout and recent files stay out of a picture, and a picture out of them.
  const QTemporaryDir settingsOfPicture;
  if (pictureOnly)
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settingsOfPicture.path());
  else
    squat::studio::takeSettingsFrom("Unknown Organization");  // where 0.3.0 and before had them

  squat::studio::StudioServices services;
  services.runner = squat::simulation::runCase;
  services.comparison = comparedRows;
  // A picture shows what was asked for, not how far a preview has come.
  if (!pictureOnly || arguments.tab == "preview")
    services.preview = {squat::simulation::makeWarmState, squat::simulation::rollOn, squat::simulation::runCase};
  if (!pictureOnly) {
    const QDir own(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    // A home folder may be shared: what another machine's processes have left is not ours to take.
    services.recoveryFolder = own.filePath("recovery/" + QString::fromLatin1(QSysInfo::machineUniqueId()));
    services.runsFolder = own.filePath("runs");
  }
  squat::studio::MainWindow window(services);
  if (arguments.dark) window.setDark(true);
  if (pictureOnly) window.resize(squat::studio::MainWindow::usualSize);  // a picture needs no screen
  if (!arguments.size.isEmpty()) window.resize(arguments.size);
  const bool opened = arguments.file.isEmpty() || window.openAny(arguments.file);
  if (!arguments.tab.isEmpty()) window.showTab(arguments.tab);
  if (pictureOnly) {
    if (!opened) {
      std::cerr << "squat-studio: " << window.messages()->text().toStdString() << '\n';
      return squat::commands::kFileWrong;
    }
    if (arguments.run && !squat::studio::runFirst(window)) {
      std::cerr << "squat-studio: " << window.messages()->text().toStdString() << '\n';
      return squat::commands::kRunFailed;
    }
    if (!arguments.tab.isEmpty()) window.showTab(arguments.tab);  // a run brings its signals to the front
    return squat::studio::takeScreenshot(window, arguments.screenshot) ? squat::commands::kDone
                                                                       : squat::commands::kFileWrong;
  }
  window.show();
  if (arguments.file.isEmpty()) {
    window.openLastProject();
    window.offerTour();
  }
  return QApplication::exec();
}
