// A squat by class, form and size.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QTest>
#include <QToolButton>
#include <set>

#include "case/ParameterTable.h"
#include "case/Validation.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "plots/Figure.h"
#include "studio/common/NumberBox.h"
#include "studio/common/Theme.h"
#include "studio/profile/SquatDialog.h"

namespace squat::studio {
namespace {

// By the limits of detection/Severity.h: light to 35 mm and 0.10 mm, moderate to 60 mm and 0.25 mm, severe beyond.
TEST(SquatDialog, classAndSizeFollowEachOther) {
  SquatDialog dialog(cases::CaseDescription(), figureStyle(false));
  auto* severity = dialog.findChild<QComboBox*>("squatClass");
  auto* length = dialog.findChild<QDoubleSpinBox*>("squatLength");
  auto* depth = dialog.findChild<QDoubleSpinBox*>("squatDepth");
  for (int each = 0; each < 3; ++each) {
    severity->setCurrentIndex(each);
    Q_EMIT severity->activated(each);
    EXPECT_EQ(static_cast<int>(dialog.severity()), each);
    EXPECT_EQ(severity->currentIndex(), each);
  }
  struct Row {
    double length, depth;  // [mm]
    int severity;
  };
  for (const Row& row :
       {Row{35, 0.10, 0}, Row{36, 0.10, 1}, Row{35, 0.11, 1}, Row{60, 0.25, 1}, Row{61, 0.05, 2}, Row{20, 0.26, 2}}) {
    length->setValue(row.length);
    depth->setValue(row.depth);
    EXPECT_EQ(severity->currentIndex(), row.severity) << row.length << " x " << row.depth;
  }
}

TEST(SquatDialog, everyFormIsDrawnAndCanBeRun) {
  cases::CaseDescription base = cases::defaultCase();
  const auto warningsBefore = cases::validate(base).warnings.size();
  SquatDialog dialog(base, figureStyle(false));
  auto* form = dialog.findChild<QComboBox*>("squatForm");
  std::set<int> shapes;
  for (int each = 0; each < form->count(); ++each) {
    form->setCurrentIndex(each);
    Q_EMIT form->activated(each);
    const auto chosen = dialog.description();
    shapes.insert(static_cast<int>(chosen.defect.shape));
    const auto validation = cases::validate(chosen);
    EXPECT_TRUE(validation.problems.empty());
    EXPECT_LE(validation.warnings.size(), warningsBefore);  // no key without effect
    const auto* figure = dialog.findChild<plots::Figure*>();
    ASSERT_NE(figure, nullptr);
    ASSERT_GE(figure->graphCount(), 2);
    // Both curves in micrometres; the wheel goes no deeper than the rail.
    bool found = false;
    const QCPRange surface = figure->graph(0)->data()->valueRange(found),
                   path = figure->graph(1)->data()->valueRange(found);
    EXPECT_NEAR(surface.lower, -1e6 * chosen.defect.depth, 2);  // the deepest of the points that are drawn
    EXPECT_GE(path.lower, surface.lower - 1e-6);
  }
  EXPECT_EQ(shapes.size(), 4u);
}

// 5 mm long and 1 mm deep is a slope of 0.63, above the 0.5 that the mesh can carry.
TEST(SquatDialog, whatCannotBeRunIsSaid) {
  SquatDialog dialog(cases::defaultCase(), figureStyle(false));
  auto* length = dialog.findChild<QDoubleSpinBox*>("squatLength");
  auto* depth = dialog.findChild<QDoubleSpinBox*>("squatDepth");
  const auto* problem = dialog.findChild<QLabel*>("squatProblem");
  const auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  EXPECT_TRUE(ok->isEnabled());
  length->setValue(5);
  depth->setValue(1);
  ASSERT_FALSE(cases::validate(dialog.description()).problems.empty());
  EXPECT_FALSE(ok->isEnabled());
  EXPECT_FALSE(problem->text().isEmpty());
  length->setValue(40);
  depth->setValue(0.1);
  EXPECT_TRUE(ok->isEnabled());
  EXPECT_TRUE(problem->text().isEmpty());
}

TEST(SquatDialog, theDepthTakesADecimalComma) {
  SquatDialog dialog(cases::defaultCase(), figureStyle(false));
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  auto* depth = dialog.findChild<QDoubleSpinBox*>("squatDepth");
  depth->selectAll();
  QTest::keyClicks(depth, "0,26");
  EXPECT_EQ(depth->text(), "0.26 mm");
  EXPECT_EQ(dialog.findChild<QComboBox*>("squatClass")->currentIndex(), 2);  // deeper than 0.25 mm
  EXPECT_DOUBLE_EQ(dialog.description().defect.depth, 1e-3 * 0.26);
}

// A point is shown on every system, and what may stand between thousands is refused, not left out.
TEST(NumberBox, takesOneCommaOrPoint) {
  const QLocale before;
  for (const char* system : {"C", "en_GB", "de_DE"}) {
    SCOPED_TRACE(system);
    QLocale::setDefault(QLocale(system));
    NumberBox box;
    box.setRange(0, 1e6);
    box.setDecimals(3);
    box.setValue(1234.5);
    EXPECT_EQ(box.text(), "1234.500");
    EXPECT_EQ(box.valueFromText("0,15"), 0.15);
    EXPECT_EQ(box.valueFromText("0.15"), 0.15);
    int place = 0;
    for (const char* wrong : {"1,234.5", "1.234,5", "1,234,567"}) {
      QString text = wrong;
      EXPECT_EQ(box.validate(text, place), QValidator::Invalid) << wrong;
      box.fixup(text);
      EXPECT_EQ(text, wrong);
    }
  }
  QLocale::setDefault(before);
}

TEST(SquatDialog, theCaseTakesItAsOneStep) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto before = window.document().description();
  tests::click(*window.findChild<QToolButton*>("chooseSquat"));
  auto* dialog = window.findChild<SquatDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* severity = dialog->findChild<QComboBox*>("squatClass");
  severity->setCurrentIndex(1);
  Q_EMIT severity->activated(1);
  const auto chosen = dialog->description();
  dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  EXPECT_TRUE(sameCase(window.document().description(), chosen));
  EXPECT_FALSE(sameCase(before, chosen));
  window.document().undoStack().undo();
  EXPECT_TRUE(sameCase(window.document().description(), before));
}

}  // namespace
}  // namespace squat::studio
