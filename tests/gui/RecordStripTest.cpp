// The strip along a long record: which marks the mouse finds, and whose keys it takes.
#include "studio/records/RecordStrip.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "plots/Style.h"
#include "studio/records/RecordView.h"

namespace squat::studio {
namespace {

// 100 m of a signal between 0 and 6 m/s2.
std::shared_ptr<records::Overview> hundredMetres() {
  records::RecordLayout layout;
  layout.channels = {{"aba", "m/s2"}};
  records::RecordBlock block;
  block.values.resize(1);
  for (int i = 0; i < 200; ++i) {
    block.position.push_back(0.5 * i + 0.05);
    block.values[0].push_back(i % 7);
  }
  auto overview = std::make_shared<records::Overview>();
  overview->add(layout, block);
  return overview;
}

// A joint and a squat, far from each other and below the legend.
constexpr double jointAt = 30, squatAt = 70, markHeight = 1;  // [m], [m], [m/s2]

ReportPointer jointAndSquat() {
  project::EventList list;
  list.records = {"ride.csv"};
  for (const bool isSquat : {false, true}) {
    project::ListedEvent event;
    event.position = isSquat ? squatAt : jointAt;
    event.record = "ride.csv";
    event.channel = "aba";
    event.kind = isSquat ? "squat" : "joint";
    event.severity = "light";
    event.sureness = 0.8, event.peak = markHeight, event.speed = 30;
    list.events.push_back(event);
  }
  return reportOf(list, {});
}

bool allMarksAreSeen(const plots::Figure& figure) {
  for (int i = 0; i < figure.graphCount(); ++i)
    if (!figure.graph(i)->visible()) return false;
  return figure.graphCount() == 3;  // the signal, squats, joints
}

void clickMark(plots::Figure& figure, double position) {
  figure.replot(QCustomPlot::rpImmediateRefresh);
  QTest::mouseClick(
      &figure, Qt::LeftButton, {},
      QPoint(qRound(figure.xAxis->coordToPixel(position)), qRound(figure.yAxis->coordToPixel(markHeight))));
}

TEST(RecordStrip, marksOfHiddenKindsAreNotPicked) {
  RecordStrip strip(plots::lightStyle());
  strip.resize(900, 300);
  strip.setVisible(true);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&strip));
  strip.follow(hundredMetres());
  strip.setReport(jointAndSquat());
  plots::Figure& figure = *strip.figure();
  ASSERT_TRUE(allMarksAreSeen(figure));
  const QSignalSpy picked(&strip, &RecordStrip::eventPicked);
  clickMark(figure, jointAt);
  ASSERT_EQ(picked.count(), 1);
  EXPECT_EQ(picked[0][0].toInt(), 0);
  ASSERT_TRUE(figure.toggleCurve(1));  // joints stand below squats in the legend
  clickMark(figure, jointAt);
  EXPECT_EQ(picked.count(), 1);
  clickMark(figure, squatAt);
  ASSERT_EQ(picked.count(), 2);
  EXPECT_EQ(picked[1][0].toInt(), 1);
  ASSERT_TRUE(figure.toggleCurve(1));
  clickMark(figure, jointAt);
  EXPECT_EQ(picked.count(), 3);
}

// As in the list: whoever has clicked a mark goes on with the same keys.
TEST(RecordStrip, keysLabelAndGoFromEventToEvent) {
  const QTemporaryDir folder;
  RecordView view(plots::lightStyle());
  view.follow(hundredMetres());
  view.setReport(jointAndSquat(), folder.path());
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  plots::Figure* figure = view.strip()->figure();
  ASSERT_TRUE(allMarksAreSeen(*figure));
  const QAbstractItemModel& list = *view.table()->model();
  const auto label = [&](int row) { return list.index(row, EventModel::seen).data().toString(); };
  view.table()->setCurrentIndex(list.index(0, 0));
  QTest::keyClick(figure, Qt::Key_1);
  QTest::keyClick(figure, Qt::Key_N);
  EXPECT_EQ(view.table()->currentIndex().row(), 1);
  QTest::keyClick(figure, Qt::Key_2);
  EXPECT_EQ(label(0), EventModel::labels()[1]);
  EXPECT_EQ(label(1), EventModel::labels()[2]);
  QTest::keyClick(figure, Qt::Key_9);  // no label
  EXPECT_EQ(label(1), EventModel::labels()[2]);
  QTest::keyClick(figure, Qt::Key_P);
  QTest::keyClick(figure, Qt::Key_0);
  EXPECT_EQ(label(0), "");
  EXPECT_TRUE(allMarksAreSeen(*figure));
  EXPECT_TRUE(figure->accessibleDescription().contains("label"));
  EXPECT_FALSE(figure->accessibleDescription().contains("curves"));
}

// The list is that of the record before, until this one is read.
TEST(RecordStrip, keysRestDuringASearch) {
  const QTemporaryDir folder;
  RecordView view(plots::lightStyle());
  view.setReport(jointAndSquat(), folder.path());
  view.table()->setCurrentIndex(view.table()->model()->index(0, 0));
  view.follow(hundredMetres());
  QTest::keyClick(view.strip()->figure(), Qt::Key_3);
  EXPECT_TRUE(view.model()->seenEvents().empty());
}

}  // namespace
}  // namespace squat::studio
