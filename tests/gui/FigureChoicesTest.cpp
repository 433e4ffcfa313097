// What a user chooses beside a figure: scale of the spectrum, moment of the contact patch, what part is enlarged.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <cmath>

#include "gui/Hands.h"
#include "render/SyntheticResult.h"
#include "studio/common/Theme.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/CursorPair.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

// Two moments: at the impact a patch of 2 x 1 points, before it one point with a higher pressure, farther out.
ResultPointer seenRun() {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  const auto patch = [](const char* name, double position, std::vector<float> x, std::vector<float> pressure) {
    results::PatchSnapshot made;
    made.name = name;
    made.position = position;
    made.time = 0.01 + position / 30;
    made.y.assign(x.size(), 0);
    made.area.assign(x.size(), 4e-6f);
    made.slipping.assign(x.size(), 0);
    made.x = std::move(x);
    made.pressure = std::move(pressure);
    return made;
  };
  result->patches = {patch("frame 001", -0.02, {0.008f}, {9e8f}), patch("impact", 0.003, {0, 0.002f}, {4e8f, 3e8f})};
  return result;
}

class FigureChoices : public testing::Test {
 protected:
  void SetUp() override {
    store_.add({seenRun(), "run", {}, false});
    panel_.resize(700, 500);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
  }
  plots::Figure& figure(const QString& name) {
    panel_.showTab(name);
    plots::Figure& shown = *panel_.view(name)->figure();
    shown.replot(QCustomPlot::rpImmediateRefresh);
    return shown;
  }
  // From one share of the axes to another, with a step between as a hand makes it.
  static void drag(plots::Figure& figure, Qt::MouseButton button, QPointF from, QPointF to) {
    const QRect room = figure.axisRect()->rect();
    const auto place = [&](QPointF share) {
      return QPoint(room.left() + qRound(share.x() * room.width()), room.top() + qRound(share.y() * room.height()));
    };
    QTest::mousePress(&figure, button, {}, place(from));
    QMouseEvent half(QEvent::MouseMove, place(0.5 * (from + to)), figure.mapToGlobal(place(0.5 * (from + to))),
                     Qt::NoButton, button, {});
    QApplication::sendEvent(&figure, &half);
    QMouseEvent whole(QEvent::MouseMove, place(to), figure.mapToGlobal(place(to)), Qt::NoButton, button, {});
    QApplication::sendEvent(&figure, &whole);
    QTest::mouseRelease(&figure, button, {}, place(to));
  }
  RunStore store_;
  SignalsPanel panel_{store_, figureStyle(false)};
};

TEST_F(FigureChoices, theLeftButtonEnlargesABox) {
  plots::Figure& shown = figure("aba_position");
  const QCPRange x = shown.xAxis->range(), y = shown.yAxis->range();
  drag(shown, Qt::LeftButton, {0.25, 0.2}, {0.75, 0.6});
  EXPECT_NEAR(shown.xAxis->range().lower, x.lower + 0.25 * x.size(), tests::pixel * x.size());
  EXPECT_NEAR(shown.xAxis->range().upper, x.lower + 0.75 * x.size(), tests::pixel * x.size());
  EXPECT_NEAR(shown.yAxis->range().upper, y.upper - 0.2 * y.size(), tests::pixel * y.size());
  EXPECT_NEAR(shown.yAxis->range().lower, y.upper - 0.6 * y.size(), tests::pixel * y.size());
  EXPECT_EQ(shown.xAxis2->range(), shown.xAxis->range());
  panel_.view("aba_position")->resetZoom();
  EXPECT_EQ(shown.xAxis->range(), x);
  EXPECT_EQ(shown.yAxis->range(), y);
}

TEST_F(FigureChoices, aFlatBoxEnlargesOneAxisAndAClickNone) {
  plots::Figure& shown = figure("aba_position");
  const QCPRange x = shown.xAxis->range(), y = shown.yAxis->range();
  drag(shown, Qt::LeftButton, {0.3, 0.5}, {0.6, 0.505});
  EXPECT_NEAR(shown.xAxis->range().size(), 0.3 * x.size(), 2 * tests::pixel * x.size());
  EXPECT_EQ(shown.yAxis->range(), y);
  panel_.view("aba_position")->resetZoom();
  drag(shown, Qt::LeftButton, {0.5, 0.5}, {0.505, 0.505});
  EXPECT_EQ(shown.xAxis->range(), x);
  EXPECT_EQ(shown.yAxis->range(), y);
}

// On linear and logarithmic axes: what was under the button follows it.
TEST_F(FigureChoices, theMiddleButtonMovesTheView) {
  for (const char* name : {"aba_position", "scalogram"}) {
    SCOPED_TRACE(name);
    plots::Figure& shown = figure(name);
    const QRect room = shown.axisRect()->rect();
    const auto at = [&](double x, double y) {
      return QPointF(shown.xAxis->pixelToCoord(room.left() + x * room.width()),
                     shown.yAxis->pixelToCoord(room.top() + y * room.height()));
    };
    const QPointF seen = at(0.5, 0.5);
    drag(shown, Qt::MiddleButton, {0.5, 0.5}, {0.7, 0.6});
    const QPointF now = at(0.7, 0.6);
    EXPECT_NEAR(now.x(), seen.x(), tests::pixel * shown.xAxis->range().size());
    EXPECT_NEAR(now.y(), seen.y(), tests::pixel * shown.yAxis->range().size());
  }
}

TEST_F(FigureChoices, aCursorThatIsDraggedDrawsNoBox) {
  plots::Figure& shown = figure("aba_position");
  panel_.toggleCursors();
  const QCPRange x = shown.xAxis->range();
  CursorPair& cursors = *panel_.view("aba_position")->cursors();
  const double before = cursors.location(0);  // at 0.4 of the axis
  drag(shown, Qt::LeftButton, {0.4, 0.5}, {0.5, 0.7});
  EXPECT_NEAR(cursors.location(0), before + 0.1 * x.size(), tests::pixel * x.size());
  EXPECT_EQ(shown.xAxis->range(), x);
}

// A density of 1 (m/s2)2/Hz is 120 dB re (1 um/s2)2/Hz.
TEST_F(FigureChoices, theSpectrumHasFourScales) {
  auto* scale = panel_.findChild<QComboBox*>("spectrumScale");
  ASSERT_NE(scale, nullptr);
  ASSERT_EQ(scale->count(), 4);
  const auto curve = [&] { return *figure("psd").graph(0)->data(); };
  const auto linear = curve();
  scale->setCurrentIndex(1);
  EXPECT_EQ(figure("psd").yAxis->scaleType(), QCPAxis::stLogarithmic);
  EXPECT_EQ(figure("psd").xAxis->scaleType(), QCPAxis::stLinear);
  scale->setCurrentIndex(2);
  const auto decibel = curve();
  ASSERT_EQ(decibel.size(), linear.size());
  int compared = 0;
  for (int i = 0; i < linear.size(); ++i) {
    const double density = linear.at(i)->value;
    if (!(density > 0)) continue;
    EXPECT_NEAR(decibel.at(i)->value, 120 + 10 * std::log10(density), 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 100);
  EXPECT_EQ(figure("psd").yAxis->range().size(), 60);  // [dB] shown
  scale->setCurrentIndex(3);
  plots::Figure& octaves = figure("psd");
  EXPECT_EQ(octaves.xAxis->scaleType(), QCPAxis::stLogarithmic);
  const auto steps = curve();
  EXPECT_EQ(steps.size() % 2, 0);
  EXPECT_NEAR(steps.at(1)->key / steps.at(0)->key, std::pow(10, 0.1), 1e-9);  // edges of one band
  scale->setCurrentIndex(0);
  EXPECT_EQ(figure("psd").xAxis->scaleType(), QCPAxis::stLinear);
}

// Over 0.38 m at 30 m/s a spectrum resolves 79 Hz, over half of that 158 Hz: what is narrower is shaded.
TEST_F(FigureChoices, shadedBandsFollowTheSection) {
  panel_.findChild<QComboBox*>("spectrumScale")->setCurrentIndex(3);
  const auto remark = [&] {
    const plots::Figure& shown = figure("psd");
    for (int i = 0; i < shown.itemCount(); ++i)
      if (const auto* text = qobject_cast<QCPItemText*>(shown.item(i)); text && text->text().startsWith("shaded"))
        return text->text().toStdString();
    return std::string();
  };
  const double speed = store_.currentResult()->speed;
  panel_.findChild<QDoubleSpinBox*>("psdFrom")->setValue(-100);
  panel_.findChild<QDoubleSpinBox*>("psdTo")->setValue(280);
  const auto resolution = [&](double length) { return std::to_string(std::lround(speed / length)) + " Hz"; };
  EXPECT_NE(remark().find(resolution(0.38)), std::string::npos) << remark();
  panel_.findChild<QDoubleSpinBox*>("psdTo")->setValue(90);
  EXPECT_NE(remark().find(resolution(0.19)), std::string::npos) << remark();
}

TEST_F(FigureChoices, anotherRunIsDrawnInTheSameScale) {
  auto other = std::make_shared<results::RunResult>(tests::syntheticResult());
  for (const char* name : {"aba", "aba_filtered"})
    for (double& value : other->channel(name)->values) value *= 10;
  store_.add({other, "strong", {}, false});
  store_.setData(store_.index(0), Qt::Checked, Qt::CheckStateRole);
  panel_.findChild<QComboBox*>("spectrumScale")->setCurrentIndex(3);
  plots::Figure& shown = figure("psd");
  ASSERT_GE(shown.graphCount(), 2);
  const auto& strong = *shown.graph(0)->data();
  const auto& weak = *shown.graph(shown.graphCount() - 1)->data();
  ASSERT_EQ(strong.size(), weak.size());
  for (int i = 0; i < strong.size(); ++i)  // ten times the amplitude is 20 dB
    EXPECT_NEAR(strong.at(i)->value - weak.at(i)->value, 20, 1e-6);
}

TEST_F(FigureChoices, theSliderShowsThePatchAtEachMoment) {
  auto* slider = panel_.findChild<QSlider*>("patchMoment");
  const auto* words = panel_.findChild<QLabel*>("patchMomentText");
  ASSERT_NE(slider, nullptr);
  figure("contact_patch");
  EXPECT_EQ(slider->maximum(), 1);
  EXPECT_EQ(slider->value(), 1);  // the impact
  EXPECT_EQ(words->text(), "impact: 3.0 mm, 10.10 ms");
  const auto cells = [&] {
    const plots::Figure& shown = figure("contact_patch");
    int count = 0;
    for (int i = 0; i < shown.itemCount(); ++i) count += qobject_cast<QCPItemRect*>(shown.item(i)) != nullptr;
    return count;
  };
  EXPECT_EQ(cells(), 2);
  slider->setValue(0);
  EXPECT_EQ(words->text(), "frame 001: -20.0 mm, 9.33 ms");
  EXPECT_EQ(cells(), 1);
  const QCPRange first = figure("contact_patch").xAxis->range();
  slider->setValue(1);
  EXPECT_EQ(cells(), 2);
  EXPECT_EQ(figure("contact_patch").xAxis->range(), first);  // one scale for all moments
  // A run that goes from the list changes nothing of what is seen.
  slider->setValue(0);
  store_.add({seenRun(), "other", {}, false});
  store_.setCurrent(0);
  slider->setValue(0);
  store_.remove(1);
  EXPECT_EQ(slider->value(), 0);
  EXPECT_NEAR(first.upper, 1.25 * 8, 1e-4);  // mm, the farthest point with a margin of a quarter
  // Another run begins at its own impact.
  auto bare = std::make_shared<results::RunResult>(*seenRun());
  bare->patches.pop_back();
  store_.add({bare, "bare", {}, false});
  EXPECT_FALSE(slider->isEnabled());
  EXPECT_EQ(panel_.settings().moment, -1);
}

}  // namespace
}  // namespace squat::studio
