// A report of what was found in long records, without a run.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "case/CaseFile.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "project/ProjectFile.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"

namespace squat::studio {
namespace {

// A ride whose squats were found, and no run: its list of events is enough for a report.
TEST(ReportOfEvents, needsNoRun) {
  const QTemporaryDir folder;
  const auto path = [&](const char* name) { return folder.filePath(name); };
  const auto write = [&](const char* name, const char* text) {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  write("ride.csv", "time [s],speed [m/s],aba [m/s2]\n0,30,1\n0.001,30,2\n0.002,30,1\n");
  write("squats.json", R"({"schema": "squat-detection", "schema_version": 1, "records": [{"path": "ride.csv"}],
    "events": [{"position_m": 100, "time_s": 1, "record": "ride.csv", "channel": "aba", "kind": "squat",
                "severity": "light", "length_mm": [45, 30, 60], "depth_mm": [0.2, 0.1, 0.3], "sureness": 0.8,
                "peak_m_s2": 60, "speed_m_s": 30, "passes": 1, "passes_there": 1}]})");
  project::Project project;
  project.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
  project.records.files = {path("ride.csv").toStdString()};
  project.records.events = path("squats.json").toStdString();
  project::writeProject(path("ride.squat-project").toStdString(), project);
  MainWindow window(tests::services());
  window.show();
  EXPECT_FALSE(window.saveReportTo(path("ride.pdf")));  // nothing to say yet
  ASSERT_TRUE(window.openProject(path("ride.squat-project"))) << window.messages()->text().toStdString();
  EXPECT_TRUE(window.findChild<QAction*>("report")->isEnabled());
  ASSERT_TRUE(window.saveReportTo(path("ride.pdf"))) << window.messages()->text().toStdString();
  QProcess text;
  text.start("pdftotext", {"-raw", path("ride.pdf"), "-"});
  ASSERT_TRUE(text.waitForFinished(60000));
  const QString pages = QString::fromUtf8(text.readAllStandardOutput());
  for (const char* part : {"Long records: 1 squat (1 light) and no other events.", "Squat at 100.00 m"})
    EXPECT_TRUE(pages.contains(part)) << part;
  window.closeProject();
  EXPECT_FALSE(window.findChild<QAction*>("report")->isEnabled());
}

}  // namespace
}  // namespace squat::studio
