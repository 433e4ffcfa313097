// Two signals as maps side by side.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include "gui/MadeUpRun.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/comparison/MapWindow.h"
#include "studio/signals/FigureView.h"

namespace squat::studio {
namespace {

ResultPointer runTimes(double factor) {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  for (const char* name : {"aba", "aba_filtered"})
    for (double& value : result->channel(name)->values) value *= factor;
  return result;
}

class Maps : public testing::Test {
 protected:
  void SetUp() override {
    window_.store().add({runTimes(1), "one", QString(), false});
    window_.store().add({runTimes(2), "two", QString(), false});
    window_.store().setReference(0);
    window_.showTab("comparison");
    window_.comparison()->findChild<QPushButton*>("Maps…")->click();
    maps_ = window_.comparison()->maps();
    ASSERT_NE(maps_, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(maps_));
  }
  QCPColorMap& map(std::size_t panel) const {
    plots::Figure& figure = *maps_->view(panel)->figure();
    for (int i = 0; i < figure.plottableCount(); ++i)
      if (auto* found = qobject_cast<QCPColorMap*>(figure.plottable(i))) return *found;
    throw std::runtime_error("no map");
  }
  MainWindow window_{tests::services()};
  MapWindow* maps_ = nullptr;
};

// Twice the amplitude is four times the power, 6.02 dB, wherever the signal is not faint; a thousandth of the largest
// power is added to both.
TEST_F(Maps, haveOneScaleAndTheirRatioInDecibels) {
  for (const int kind : {0, 1}) {
    auto* choice = maps_->findChild<QComboBox*>("mapKind");
    choice->setCurrentIndex(kind);
    Q_EMIT choice->activated(kind);
    EXPECT_EQ(map(0).dataRange(), map(1).dataRange());
    EXPECT_EQ(maps_->findChild<QLabel*>("mapProblem")->text(), "");
    const double largest = map(0).dataRange().upper;
    auto& first = *map(0).data();
    auto& second = *map(1).data();
    auto& ratio = *map(2).data();
    ASSERT_EQ(first.keySize(), ratio.keySize());
    ASSERT_EQ(first.valueSize(), ratio.valueSize());
    int strong = 0;
    for (int i = 0; i < first.keySize(); ++i)
      for (int k = 0; k < first.valueSize(); ++k) {
        // "two" is chosen beside "one", and laid on its axis by correlation: a thousandth of a sample off.
        EXPECT_NEAR(first.cell(i, k), 4 * second.cell(i, k), 1e-3 * largest);
        if (second.cell(i, k) < 0.1 * largest) continue;  // there the thousandth is 0.03 dB, the axis as much
        EXPECT_NEAR(ratio.cell(i, k), 6.02, 0.1);
        ++strong;
      }
    EXPECT_GT(strong, 50);
  }
}

TEST_F(Maps, areWholeAndExported) {
  for (const bool dark : {false, true}) {
    window_.setDark(dark);
    QTest::qWait(20);
    EXPECT_GT(tests::inkShare(maps_->grab().toImage()), 0.05);
  }
  window_.setDark(false);
  const QTemporaryDir folder;
  maps_->writeFile(folder.filePath("both.png"));
  const QImage picture(folder.filePath("both.png"));
  EXPECT_NEAR(picture.width(), 2 * 85 / 25.4 * 300, 8);  // two columns
  maps_->writeFile(folder.filePath("both.pdf"));
  EXPECT_GT(QFileInfo(folder.filePath("both.pdf")).size(), 10000);
}

// Chosen in the main window while the maps stand open.
TEST_F(Maps, takeTheSizeOfFiguresThatIsChosen) {
  const auto restored = qScopeGuard([] { storeFigureSize({}); });
  storeFigureSize({120, 80, 100});
  QEvent activation(QEvent::ActivationChange);  // the user comes back
  QApplication::sendEvent(maps_, &activation);
  const QTemporaryDir folder;
  maps_->view(0)->writeFile(folder.filePath("map.png"));
  const QImage picture(folder.filePath("map.png"));
  EXPECT_NEAR(picture.width(), 120 / 25.4 * 100, 1);
  EXPECT_NEAR(picture.height(), 80 / 25.4 * 100, 1);
}

// Aligned in time, as by squat compare: runs of two speeds have the same milliseconds, not the same millimetres.
TEST_F(Maps, standOverTimeAsTheComparisonDoes) {
  EXPECT_TRUE(maps_->view(0)->figure()->xAxis->label().contains("[ms]"));
  // 100 mm before the impact to 280 mm behind it, at the speed of the first.
  const double speed = window_.store().at(1).result->speed;
  const QCPRange shown = maps_->view(0)->figure()->xAxis->range();
  EXPECT_GE(shown.lower, -1e3 * 0.1 / speed - 0.1);
  EXPECT_LE(shown.upper, 1e3 * 0.28 / speed + 0.1);
  EXPECT_GT(shown.size(), 0.5 * 1e3 * 0.38 / speed);
}

TEST_F(Maps, keepTheirSignalsWhenAnotherOneGoes) {
  window_.store().add({runTimes(3), "three", QString(), false});
  maps_->choose(2, 1);
  const auto* first = maps_->findChild<QComboBox*>("mapFirst");
  const auto* second = maps_->findChild<QComboBox*>("mapSecond");
  EXPECT_EQ(first->currentText(), "three");
  window_.store().remove(0);
  EXPECT_EQ(first->currentText(), "three");
  EXPECT_EQ(second->currentText(), "two");
  EXPECT_TRUE(maps_->findChild<QPushButton*>("exportMaps")->isEnabled());
  window_.store().remove(1);  // the one that is shown
  EXPECT_NE(maps_->findChild<QLabel*>("mapProblem")->text(), "");
  EXPECT_FALSE(maps_->findChild<QPushButton*>("exportMaps")->isEnabled());
}

TEST_F(Maps, aSignalThatIsTooShortIsSaid) {
  auto brief = std::make_shared<results::RunResult>(*runTimes(1));
  brief->time.resize(8);
  brief->position.resize(8);
  for (auto& channel : brief->signals) channel.values.resize(8);
  const int row = window_.store().add({brief, "brief", QString(), false});
  maps_->choose(row, 0);
  const auto* problem = maps_->findChild<QLabel*>("mapProblem");
  EXPECT_NE(problem->text(), "");
  EXPECT_FALSE(problem->text().isEmpty());
}

}  // namespace
}  // namespace squat::studio
