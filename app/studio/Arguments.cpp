#include "studio/Arguments.h"

#include <QCommandLineParser>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "studio/window/MainWindow.h"

namespace squat::studio {
namespace {

constexpr int wrongCall = 2;

[[noreturn]] void refuse(const QString& sentence) {
  std::cerr << "squat-studio: " << sentence.toStdString() << '\n';
  std::exit(wrongCall);
}

QSize sizeFrom(const QString& text) {
  constexpr int largest = 8000;  // [pixels]
  const QStringList numbers = text.split('x');
  const QSize size(numbers.value(0).toInt(), numbers.value(1).toInt());
  if (numbers.size() != 2 || size.isEmpty() || size.width() > largest || size.height() > largest)
    refuse(QStringLiteral("--size is “%2”, must be two numbers up to %1, such as 1280x700").arg(largest).arg(text));
  return size;
}

}  // namespace

bool wantsScreenshot(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], "--screenshot", 12) == 0) return true;
  return false;
}

bool wantsWords(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    for (const char* each : {"-h", "--help", "--help-all", "-v", "--version"})
      if (std::strcmp(argv[i], each) == 0) return true;
  return false;
}

Arguments readArguments() {
  QCommandLineParser parser;
  parser.setApplicationDescription("Draw a squat, roll a wheel over it, see the axle box acceleration.");
  const QCommandLineOption help = parser.addHelpOption();
  const QCommandLineOption version = parser.addVersionOption();
  const QCommandLineOption screenshot("screenshot", "Save the window as a PNG and exit; needs no display.", "OUT.png");
  const QCommandLineOption caseFile("case", "Case to open (path or name of a shipped case).", "CASE");
  const QCommandLineOption resultFile("result", "Result to open.", "RESULT.h5");
  const QCommandLineOption tab("tab", "Tab to show: " + MainWindow::tabNames().join(", ") + ".", "NAME");
  const QCommandLineOption dark("dark", "Use dark colours.");
  const QCommandLineOption size("size", "Size of the window, such as 1280x700.", "WIDTHxHEIGHT");
  const QCommandLineOption run("run", "Run the case before the screenshot is taken.");
  parser.addOptions({screenshot, caseFile, resultFile, tab, dark, size, run});
  parser.addPositionalArgument("file", "Case, result or project to open.", "[CASE|RESULT.h5|NAME.squat-project]");
  if (!parser.parse(QCoreApplication::arguments())) refuse(parser.errorText());
  if (parser.isSet(help) || parser.isSet("help-all")) parser.showHelp(0);
  if (parser.isSet(version)) parser.showVersion();
  const QStringList files = parser.positionalArguments() + parser.values(caseFile) + parser.values(resultFile);
  if (files.size() > 1) refuse("give one case, result or project; found " + files.join(", "));
  Arguments arguments{files.value(0),    parser.value(screenshot),
                      parser.value(tab), parser.isSet(dark),
                      parser.isSet(run), parser.isSet(size) ? sizeFrom(parser.value(size)) : QSize()};
  if (!arguments.tab.isEmpty() && !MainWindow::tabNames().contains(arguments.tab))
    refuse(QStringLiteral("--tab is “%1”, must be one of %2").arg(arguments.tab, MainWindow::tabNames().join(", ")));
  if (arguments.run && !parser.isSet(screenshot)) refuse("--run needs --screenshot; in the window press F5");
  if (parser.isSet(screenshot) && arguments.screenshot.isEmpty()) refuse("--screenshot needs the name of a PNG file");
  return arguments;
}

}  // namespace squat::studio
