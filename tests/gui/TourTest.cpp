// The quick tour: shown once, every stop beside its part, ended by Escape.
#include <gtest/gtest.h>

#include <QAction>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "studio/project/NotesPanel.h"
#include "studio/window/QuickTour.h"

namespace squat::studio {
namespace {

class Tour : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tourSeen");
    window_.resize(1280, 700);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  void TearDown() override { QSettings().remove("tourSeen"); }
  QuickTour* tour() const { return window_.findChild<QuickTour*>(); }
  MainWindow window_{tests::services()};
};

TEST_F(Tour, isOfferedAtTheFirstStartAlone) {
  window_.offerTour();
  ASSERT_NE(tour(), nullptr);
  window_.activateWindow();
  window_.notes()->setFocus();  // Escape ends it wherever the focus is
  tests::press(window_, Qt::Key_Escape);
  EXPECT_TRUE(tests::passes([&] { return !tour(); }));
  window_.offerTour();
  EXPECT_EQ(tour(), nullptr);
  window_.findChild<QAction*>("tour")->trigger();  // when it is asked for
  EXPECT_NE(tour(), nullptr);
}

TEST_F(Tour, everyStopIsWholeAndBesideItsPart) {
  window_.showTour();
  QuickTour& card = *tour();
  auto* next = card.findChild<QPushButton*>("quickTourNext");
  auto* outline = window_.findChild<QWidget*>("quickTourOutline");
  ASSERT_NE(outline, nullptr);
  QStringList titles;
  const int stops = card.stops();  // the last step deletes the card
  for (int stop = 0; stop < stops; ++stop) {
    QTest::qWait(30);
    ASSERT_EQ(card.stop(), stop);
    const auto* words = card.findChild<QLabel*>("quickTourWords");
    titles << card.findChild<QLabel*>("quickTourTitle")->text();
    SCOPED_TRACE(titles.last().toStdString());
    EXPECT_TRUE(window_.rect().contains(card.geometry()));
    EXPECT_LE(words->heightForWidth(words->width()), words->height());
    EXPECT_TRUE(window_.rect().contains(outline->geometry()));
    EXPECT_GT(outline->width() * outline->height(), 5000);
    // Beside what it is about, which the user has to see.
    const QRect hidden = card.geometry() & outline->geometry();
    EXPECT_LT(hidden.width() * hidden.height(), 0.02 * outline->width() * outline->height());
    // Nothing shines through.
    const QImage seen = window_.grab().toImage();
    for (const QPoint& place : {QPoint(12, 8), QPoint(card.width() / 2, 8), QPoint(card.width() - 12, 8)})
      EXPECT_EQ(seen.pixelColor(card.pos() + place), card.palette().window().color());
    EXPECT_TRUE(card.accessibleDescription().contains(words->text()));
    tests::click(*next);
  }
  EXPECT_EQ(QSet<QString>(titles.begin(), titles.end()).size(), titles.size());
  EXPECT_TRUE(tests::passes([&] { return !tour(); }));  // "Finish"
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<QWidget*>("quickTourOutline"); }));
}

// Nothing is blocked: a run can be started under it.
TEST_F(Tour, theWindowStaysUsable) {
  window_.showTour();
  tests::press(window_, Qt::Key_F5);
  EXPECT_TRUE(tests::passes([&] { return window_.store().rowCount() == 1; }, 60000));
  EXPECT_NE(tour(), nullptr);
}

}  // namespace
}  // namespace squat::studio
