// The way of a newcomer: from the first start to a named comparison of two profiles of their own, counted in clicks and
// keys.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "case/CaseDescription.h"
#include "case/Resolve.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/window/QuickTour.h"

namespace squat::studio {
namespace {

// The runs are made up: what they compute takes no clicks.
class Newcomer : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tourSeen");
    window_.resize(1280, 700);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  QString profile(const QString& name, const QByteArray& depth) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("position [mm],height [mm]\n-20,0\n-10,-0.05\n0,-" + depth + "\n10,-0.05\n20,0\n");
    return file.fileName();
  }
  void click(QWidget& target) {
    ++count_;
    tests::click(target);
  }
  void press(int key) {
    ++count_;
    tests::press(window_, key);
  }
  void type(const QString& text) {
    count_ += static_cast<int>(text.size());
    tests::type(window_, text);
  }
  void import(const QString& path) {
    tests::FileDialogTyping typing(path);
    click(*window_.findChild<QToolButton*>("importProfile"));
    ASSERT_TRUE(typing.done());
    count_ += 2;  // by mouse: the file, and "Open"
    auto* dialog = window_.findChild<QDialog*>("importDialog");
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
    click(*dialog->findChild<QPushButton*>("takeProfile"));
    ASSERT_TRUE(tests::passes([&] { return window_.findChild<QDialog*>("importDialog") == nullptr; }));
  }
  void run() {
    const int before = window_.store().rowCount();
    press(Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return window_.store().rowCount() > before; }, 60000));
  }
  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  int count_ = 0;
};

TEST_F(Newcomer, comparesTwoOwnProfilesWithinTwentyFiveClicksAndKeys) {
  window_.offerTour();
  auto* tour = window_.findChild<QuickTour*>();
  ASSERT_NE(tour, nullptr);
  click(*tour->findChild<QPushButton*>("quickTourClose"));
  ASSERT_NO_FATAL_FAILURE(import(profile("old.csv", "0.1")));
  click(*window_.findChild<QLineEdit*>("parameterSearch"));
  type("mesh.p");
  QWidget* mesh = window_.form()->row("mesh.preset")->editor();
  ASSERT_TRUE(mesh->isVisible());
  click(*mesh);
  type("t");
  press(Qt::Key_Return);
  ASSERT_NO_FATAL_FAILURE(run());
  ASSERT_NO_FATAL_FAILURE(import(profile("new.csv", "0.3")));
  ASSERT_NO_FATAL_FAILURE(run());
  click(*window_.findChild<QPushButton*>("Compare"));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.comparison()));
  ASSERT_TRUE(tests::passes([&] { return !window_.comparison()->isBusy(); }, 30000));
  const auto& table = *window_.comparison()->table()->model();
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.index(0, 0).data().toString(), "0.1 deep, 40 long");
  EXPECT_EQ(table.index(1, 0).data().toString(), "0.3 deep, 40 long");
  for (int row : {0, 1}) {
    EXPECT_EQ(window_.store().at(row).result->resolvedCase->description.mesh.preset, cases::MeshPreset::tiny);
    for (int column = 2; column < table.columnCount(); ++column)
      EXPECT_NE(table.index(row, column).data().toString(), "") << column;
  }
  RecordProperty("clicks_and_keys", count_);
  EXPECT_LE(count_, 25);  // 22 when this was written
}

}  // namespace
}  // namespace squat::studio
