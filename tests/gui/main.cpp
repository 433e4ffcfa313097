// One program for all tests of windows; without QT_QPA_PLATFORM in the environment no display is needed.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <clocale>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // dialogs that can be typed into on every machine
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("squat-studio-tests");
  const QTemporaryDir settings;  // nobody's own settings are read or written
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QSettings().setValue("parameterLevel", 2);  // all keys can be typed into; the form's own tests choose
  return RUN_ALL_TESTS();
}
