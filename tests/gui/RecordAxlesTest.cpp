// Which channels of a long record are axle boxes: what is typed in the window does what --axle does, and is kept.
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "plots/Style.h"
#include "project/ProjectFile.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/records/RecordView.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

class RecordAxles : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tools");
    window_.show();
    window_.findChild<QAction*>("squatsAction")->trigger();
    tool_ = window_.tool("squats");
    tool_->setFolder(path("studio"));
    form_ = qobject_cast<DetectionForm*>(tool_->form());
    axles_ = form_->findChild<QLineEdit*>("axles");
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  // The example in two channels, whose names say no side: the second box feels nine tenths of the first, 1.6 ms later.
  void writeRecord() const {
    constexpr int later = 8;  // samples of 0.2 ms
    QFile example(QString::fromStdString((cases::resourcesFolder() / "records/example-record.csv").string()));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    QByteArray text = "time [s],\"box, 1 [m/s2]\",\"box, 2 [m/s2]\"\n";
    QList<double> before(later, 0.0);
    for (const QByteArray& line : example.readAll().split('\n')) {
      const auto fields = line.split(',');
      bool isNumber = false;
      const double value = fields.last().toDouble(&isNumber);
      if (fields.size() != 2 || !isNumber) continue;
      text += line + ',' + QByteArray::number(0.9 * before.takeFirst()) + '\n';
      before.append(value);
    }
    QFile record(path("record.csv"));
    ASSERT_TRUE(record.open(QIODevice::WriteOnly));
    record.write(text);
  }
  void search() {
    tool_->start();
    ASSERT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
    ASSERT_TRUE(form_->records()->model()->report()) << tool_->messages()->text().toStdString();
  }
  QByteArray ofTheCommand(const QStringList& axles) const {
    QProcess program;
    program.setWorkingDirectory(folder_.path());
    program.start(SQUAT_PROGRAM,
                  QStringList{"detect", path("record.csv"), "--speed", "30", "-o", "command", "--no-figures"} + axles);
    EXPECT_TRUE(program.waitForFinished(tests::patience));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    return read("command/squats.csv");
  }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  ToolWindow* tool_ = nullptr;
  DetectionForm* form_ = nullptr;
  QLineEdit* axles_ = nullptr;
};

TEST_F(RecordAxles, areThoseThatAreTyped) {
  ASSERT_NO_FATAL_FAILURE(writeRecord());
  form_->addRecord(path("record.csv"));
  form_->findChild<QDoubleSpinBox*>("recordSpeed")->setValue(30);
  axles_->setText("\"box, 2\",\"box, 1\"");
  ASSERT_NO_FATAL_FAILURE(search());
  EXPECT_EQ(read("studio/squats.csv"), ofTheCommand({"--axle", "\"box, 2\",\"box, 1\""}));
  const auto& report = *form_->records()->model()->report();
  int squats = 0;
  for (const auto& each : report.events) {
    if (each.event.kind != detection::Kind::squat) continue;
    ASSERT_TRUE(each.event.side);
    EXPECT_EQ(each.event.side->side(), detection::RailSide::right) << "the first box, here the right one, moves first";
    ++squats;
  }
  EXPECT_GE(squats, 6);  // seven are in it (example-record-truth.csv)
}

TEST_F(RecordAxles, thatCannotBeAreRefusedInWordsOfTheWindow) {
  ASSERT_NO_FATAL_FAILURE(writeRecord());
  form_->addRecord(path("record.csv"));
  form_->findChild<QDoubleSpinBox*>("recordSpeed")->setValue(30);
  const auto refusal = [&](const QString& typed) {
    axles_->setText(typed);
    tool_->start();
    EXPECT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
    return tool_->messages()->text() + tool_->messages()->details();
  };
  const QString ambiguous = refusal("box, 1,box, 2");
  EXPECT_TRUE(ambiguous.contains("axle boxes is box, 1,box, 2")) << ambiguous.toStdString();
  EXPECT_TRUE(ambiguous.contains("double quotes")) << ambiguous.toStdString();
  const QString unknown = refusal("left,right");
  EXPECT_TRUE(unknown.contains("no channel 'left'")) << unknown.toStdString();
  EXPECT_FALSE(form_->records()->model()->report());
}

TEST_F(RecordAxles, areKeptWithTheProjectAndTheWindow) {
  EXPECT_EQ(axles_->text(), "");
  EXPECT_TRUE(axles_->placeholderText().startsWith("automatic (by names)"));
  project::Project project;
  project.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
  project.records.files = {(cases::resourcesFolder() / "records/example-record.csv").string()};
  project.records.speed = 30;
  project.records.axles = "none";
  const auto file = path("day.squat-project").toStdString();
  project::writeProject(file, project);
  ASSERT_TRUE(window_.openProject(path("day.squat-project"))) << window_.messages()->text().toStdString();
  EXPECT_EQ(axles_->text(), "none");
  axles_->setText("a,b; c,d");
  EXPECT_EQ(form_->choices().axles, "a,b; c,d");
  window_.keeper()->saveNow();
  EXPECT_EQ(project::readProject(file).records.axles, "a,b; c,d");
  // The next window has what this one had.
  QSettings settings(path("settings.ini"), QSettings::IniFormat);
  form_->save(settings);
  DetectionForm next(plots::lightStyle());
  next.restore(settings);
  EXPECT_EQ(next.findChild<QLineEdit*>("axles")->text(), "a,b; c,d");
}

}  // namespace
}  // namespace squat::studio
