// squat-studio as a program: help, version, wrong calls, and its window as a picture without a display.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"

namespace squat::studio {
namespace {

struct Outcome {
  int code = -1;
  QString out, error;
};

Outcome studio(const QStringList& arguments, const QString& scale = "1") {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
  environment.insert("QT_SCALE_FACTOR", scale);
  const QTemporaryDir runtime;  // Qt warns of one that is missing
  environment.insert("XDG_RUNTIME_DIR", runtime.path());
  program.setProcessEnvironment(environment);
  program.start(QStringLiteral(SQUAT_BINARY_DIR "/bin/squat-studio"), arguments);
  constexpr int patience = 120000;  // [ms]
  program.waitForFinished(patience);
  return {program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1,
          QString::fromUtf8(program.readAllStandardOutput()), QString::fromUtf8(program.readAllStandardError())};
}

TEST(Program, helpAndVersionNeedNoDisplay) {
  const Outcome help = studio({"--help"});
  EXPECT_EQ(help.code, 0) << help.error.toStdString();
  for (const char* word : {"--screenshot", "--case", "--result", "--tab", "RESULT.h5"})
    EXPECT_TRUE(help.out.contains(word)) << word;
  const Outcome version = studio({"--version"});
  EXPECT_EQ(version.code, 0) << version.error.toStdString();
  EXPECT_TRUE(version.out.contains("squat-studio ")) << version.out.toStdString();
}

TEST(Program, wrongCallsAreRefusedInOneSentence) {
  for (const QStringList& call :
       {QStringList{"--tab", "nowhere", "--screenshot", "x.png"}, QStringList{"--nonsense"},
        QStringList{"--size", "1280", "--screenshot", "x.png"}, QStringList{"light-defect"}}) {
    const Outcome outcome = studio(call);  // the last one lacks a display
    EXPECT_EQ(outcome.code, 2) << call.join(' ').toStdString();
    EXPECT_TRUE(outcome.error.startsWith("squat-studio: ")) << outcome.error.toStdString();
    EXPECT_EQ(outcome.error.trimmed().count('\n'), 0) << outcome.error.toStdString();
  }
}

TEST(Program, aPictureOfTheWindowAtPlainAndDoubleResolution) {
  const QTemporaryDir folder;
  const QString result = folder.filePath("run.h5");
  results::writeResult(result.toStdString(), tests::syntheticResult());
  const QString plain = folder.filePath("plain.png"), twice = folder.filePath("twice.png");
  const Outcome first = studio({"--screenshot", plain, "--result", result, "--tab", "aba_position"});
  ASSERT_EQ(first.code, 0) << first.error.toStdString();
  const Outcome second =
      studio({"--screenshot", twice, "--case", "light-defect", "--tab", "profile", "--size", "1280x700"}, "2");
  ASSERT_EQ(second.code, 0) << second.error.toStdString();
  const QImage one(plain), two(twice);
  EXPECT_GT(tests::inkShare(one), 0.1);
  EXPECT_GT(tests::inkShare(two), 0.1);
  EXPECT_EQ(two.size(), QSize(2560, 1400));
  EXPECT_GT(one.width(), 1280);
}

}  // namespace
}  // namespace squat::studio
