// What figures show, asked from the objects.
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <cmath>
#include <memory>

#include "colours/ColourTables.h"
#include "plots/Application.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureFiles.h"
#include "plots/LineFigure.h"
#include "plots/SleeperSpans.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "signals/Features.h"

namespace squat {
namespace {

class FigureContent : public testing::Test {
 protected:
  static void SetUpTestSuite() { plots::ensureApplication(); }
  static std::vector<QString> labels(const plots::Figure& figure) {
    std::vector<QString> texts;
    for (int i = 0; i < figure.itemCount(); ++i)
      if (const auto* text = qobject_cast<QCPItemText*>(figure.item(i))) texts.push_back(text->text());
    return texts;
  }
  results::RunResult result_ = tests::syntheticResult();
};

TEST_F(FigureContent, abaAgainstPositionShowsTheJudgedWindow) {
  const auto figure = plots::abaPositionFigure(result_, plots::lightStyle());
  EXPECT_DOUBLE_EQ(figure->xAxis->range().lower, -100);
  EXPECT_DOUBLE_EQ(figure->xAxis->range().upper, 280);
  // The largest of the axle box's samples is inside and the curve has them all.
  const auto& box = *result_.signal("aba_filtered");
  EXPECT_EQ(figure->graph(0)->dataCount(), static_cast<int>(box.size()));
  EXPECT_GT(figure->yAxis->range().upper, *std::max_element(box.begin(), box.end()));
}

TEST_F(FigureContent, defectReachesFromItsFirstToItsLastSlope) {
  // The made-up profile is flat but for -25 to 65 mm; its raster is 0.75 mm.
  const auto extent = plots::defectExtent(result_);
  EXPECT_NEAR(extent.from, -0.025, 2e-3);
  EXPECT_NEAR(extent.to, 0.065, 2e-3);
  result_.profileHeight.assign(result_.profileHeight.size(), 0.0);
  EXPECT_TRUE(plots::defectExtent(result_).empty());
}

TEST_F(FigureContent, psdNamesItsPeaks) {
  const auto texts = labels(*plots::psdFigure(result_, plots::lightStyle()));
  // Lines at 300, 640 and 1000 Hz on a raster of 7.8 Hz.
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_NEAR(texts[0].toDouble(), 300, 4);
  EXPECT_NEAR(texts[1].toDouble(), 1000, 4);
  EXPECT_NEAR(texts[2].toDouble(), 640, 4);
}

// Two lines 84 Hz apart are both named, ripple of a fiftieth is not, and the numbers are those of the tables.
TEST_F(FigureContent, psdNamesNeighboursAndNoRipple) {
  const auto bell = [](double f, double at, double height) { return height * std::exp(-std::pow((f - at) / 20, 2)); };
  for (std::size_t i = 0; i < result_.frequency.size(); ++i) {
    const double f = result_.frequency[i];
    result_.psd[i] = bell(f, 250, 4) + bell(f, 334, 5) + bell(f, 749, 3) + bell(f, 1500, 0.08) + bell(f, 1720, 0.1);
  }
  const auto texts = labels(*plots::psdFigure(result_, plots::lightStyle()));
  signals::PowerSpectrum spectrum;
  spectrum.frequency = result_.frequency;
  spectrum.density = result_.psd;
  const auto lines = signals::namedLines(spectrum);
  ASSERT_EQ(texts.size(), 3u);
  const double expected[] = {334, 250, 749};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(texts[i].toDouble(), expected[i], 2);  // a raster of 7.8 Hz, the vertex of a parabola
    EXPECT_EQ(texts[i], QString::number(lines[i].frequency, 'f', 0));
  }
}

TEST_F(FigureContent, contactForceShowsZero) {
  const auto figure = plots::contactForceFigure(result_, plots::lightStyle());
  EXPECT_LE(figure->yAxis->range().lower, 0);
  EXPECT_GT(figure->yAxis->range().upper, 87.8);  // kN
}

TEST_F(FigureContent, tracksideShowsRailAndSleeperInTheJudgedWindow) {
  const auto figure = plots::tracksideFigure(result_, plots::lightStyle());
  ASSERT_EQ(figure->graphCount(), 2);
  EXPECT_EQ(figure->xAxis->range(), QCPRange(-100, 280));
  const auto& rail = *result_.signal("rail_acceleration");
  ASSERT_EQ(figure->graph(0)->dataCount(), static_cast<int>(rail.size()));
  const auto highest = std::max_element(rail.begin(), rail.end());
  const auto& drawn = *figure->graph(0)->data()->at(static_cast<int>(highest - rail.begin()));
  EXPECT_DOUBLE_EQ(drawn.value, *highest);
  EXPECT_DOUBLE_EQ(drawn.key, 1e3 * result_.position[static_cast<std::size_t>(highest - rail.begin())]);
  EXPECT_GT(figure->yAxis->range().upper, *highest);
}

TEST_F(FigureContent, permanentChangeShowsTheGrooveInMicrometres) {
  const auto figure = plots::permanentChangeFigure(result_, plots::lightStyle());
  // The made-up groove: 2 um along the rail, 3 um behind the dip.
  EXPECT_LT(figure->yAxis->range().lower, -2.9);
  EXPECT_GT(figure->yAxis->range().lower, -4);
  EXPECT_EQ(figure->graphCount(), 2);
}

TEST_F(FigureContent, residualStressRunsDownwards) {
  const auto figure = plots::residualStressFigure(result_, plots::lightStyle());
  EXPECT_TRUE(figure->yAxis->rangeReversed());
  EXPECT_LT(figure->xAxis->range().lower, -290);  // MPa, at the surface
}

TEST_F(FigureContent, anElasticRailHasNoMark) {
  result_.permanent = {};
  for (const auto& figure : {plots::permanentChangeFigure(result_, plots::lightStyle()),
                             plots::residualStressFigure(result_, plots::lightStyle())})
    EXPECT_TRUE(plots::toSvg(*figure).contains("no plastic flow"));
}

TEST_F(FigureContent, sleepersAreFoundFromTheSurface) {
  const auto spans = plots::sleeperSpans(result_.surface);
  ASSERT_EQ(spans.size(), 5u);
  EXPECT_NEAR(spans[2].from, -0.13, 1e-6);
  EXPECT_NEAR(spans[2].to, 0.13, 1e-6);
}

TEST_F(FigureContent, anIncompleteRunSaysSo) {
  result_.complete = false;
  result_.stopReason = "cancelled";
  const auto figure = plots::abaTimeFigure(result_, plots::lightStyle());
  EXPECT_TRUE(plots::toSvg(*figure).contains("incomplete (cancelled)"));
}

TEST_F(FigureContent, notANumberDoesNotSpoilTheAxes) {
  for (auto& channel : result_.signals) channel.values[200] = NAN;
  const auto figure = plots::abaPositionFigure(result_, plots::lightStyle());
  EXPECT_TRUE(std::isfinite(figure->yAxis->range().size()));
  EXPECT_GT(tests::inkShare(plots::toImage(*figure)), 0.03);
}

TEST_F(FigureContent, aConstantSignalHasARange) {
  for (auto& channel : result_.signals) std::fill(channel.values.begin(), channel.values.end(), 0.0);
  EXPECT_GT(plots::abaTimeFigure(result_, plots::lightStyle())->yAxis->range().size(), 0);
}

// Of a whole model: left and right beside each other, on one scale of colours and over the same stretch. The right
// wheel presses half as hard here, at as many points.
TEST_F(FigureContent, bothContactsOfAWholeModelStandBesideEachOther) {
  auto right = result_.patches.at(0);
  int under = 0;
  for (float& pressure : right.pressure) under += pressure > 0, pressure *= 0.5f;
  const auto alone = plots::patchTable(result_);
  result_.patches[0].right = std::make_shared<const results::PatchSnapshot>(right);
  const auto figure = plots::patchFigure(result_, plots::lightStyle());
  ASSERT_EQ(figure->axisRectCount(), 2);
  EXPECT_EQ(labels(*figure), (std::vector<QString>{"left", "right"}));
  const char* map = "viridis";
  for (int side = 0; side < 2; ++side) {
    int count = 0;
    for (int i = 0; i < figure->itemCount(); ++i) {
      const auto* box = qobject_cast<QCPItemRect*>(figure->item(i));
      if (!box || box->topLeft->keyAxis() != figure->axisRect(side)->axis(QCPAxis::atBottom)) continue;
      ++count;
      EXPECT_EQ(box->clipAxisRect(), figure->axisRect(side));
      if (std::abs(box->topLeft->key() + box->bottomRight->key()) > 1e-6 ||
          std::abs(box->topLeft->value() + box->bottomRight->value()) > 1e-6)
        continue;
      const auto colour = colours::colourAt(map, side == 0 ? 1 : 0.5);  // in the middle
      EXPECT_NEAR(box->brush().color().greenF(), colour.green, 0.01) << side;
      EXPECT_NEAR(box->brush().color().blueF(), colour.blue, 0.01) << side;
    }
    EXPECT_EQ(count, under) << side;
  }
  figure->xAxis->setRange(-3, 5);
  EXPECT_EQ(figure->axisRect(1)->axis(QCPAxis::atBottom)->range(), QCPRange(-3, 5));
  figure->axisRect(1)->axis(QCPAxis::atLeft)->setRange(-2, 1);
  EXPECT_EQ(figure->yAxis->range(), QCPRange(-2, 1));
  figure->settleLayout(figure->printedUnits());
  EXPECT_NEAR(figure->axisRect(0)->width(), figure->axisRect(1)->width(), 1);
  const auto both = plots::patchTable(result_);
  EXPECT_TRUE(both.startsWith("side,along [m],"));
  EXPECT_EQ(both.count("left,"), alone.count('\n') - 1);
  EXPECT_EQ(both.count("right,"), alone.count('\n') - 1);
}

// One wheel may lift off its rail while the other one rolls.
TEST_F(FigureContent, aWheelOfTwoThatLiftsSaysSoInItsOwnAxes) {
  auto lifted = result_.patches.at(0);
  for (auto* values : {&lifted.x, &lifted.y, &lifted.pressure}) values->clear();
  result_.patches[0].right = std::make_shared<const results::PatchSnapshot>(lifted);
  const auto figure = plots::patchFigure(result_, plots::lightStyle());
  EXPECT_EQ(labels(*figure), (std::vector<QString>{"left", "right", "no contact at this moment"}));
  EXPECT_GT(figure->graphCount(), 0);  // slip on the left
  auto other = result_.patches[0];
  other.x.swap(lifted.x), other.y.swap(lifted.y), other.pressure.swap(lifted.pressure);
  other.right = std::make_shared<const results::PatchSnapshot>(lifted);
  result_.patches[0] = other;
  EXPECT_EQ(plots::shownPatch(result_), &result_.patches[0]);
}

TEST_F(FigureContent, zoomedCurvesStayInsideTheAxesOfTheSvg) {
  const auto figure = plots::abaPositionFigure(result_, plots::lightStyle());
  figure->yAxis->setRange(-5, 5);  // the impact runs far out of this
  const QByteArray svg = plots::toSvg(*figure);
  EXPECT_TRUE(svg.contains("<clipPath"));
  EXPECT_GE(svg.count("clip-path=\"url(#"), 2);
}

// Positions of a line are counted in kilometres; the ticks stand for what they are, to the digit.
TEST_F(FigureContent, ticksFarFromZeroAreToldApart) {
  const plots::Figure figure("far", plots::lightStyle());
  for (const QCPRange range : {QCPRange(12345600, 12345700), QCPRange(12345600, 12345613),
                               QCPRange(-1e6 - 0.4, -1e6 + 0.4), QCPRange(-40, 90)}) {
    QVector<double> ticks;
    QVector<QString> texts;
    figure.xAxis->ticker()->generate(range, QLocale::c(), 'g', figure.xAxis->numberPrecision(), ticks, nullptr, &texts);
    ASSERT_GT(ticks.size(), 2);
    ASSERT_EQ(texts.size(), ticks.size());
    for (int i = 0; i < ticks.size(); ++i)
      EXPECT_NEAR(QString(texts[i]).replace(QChar(0x2212), '-').toDouble(), ticks[i], 1e-6 * range.size())
          << texts[i].toStdString();
  }
}

// Runs that are laid over each other are told apart by what stands at the end of their names.
TEST_F(FigureContent, namesInALegendAreWhole) {
  auto figure = plots::abaPositionFigure(result_, plots::lightStyle());
  const QStringList names{"light-defect #1", "light-defect-two #2", "a third run of this case #3", "measured-tim.csv"};
  for (const auto& name : names) plots::addCurve(*figure, {{0, 1}, {0, 1}, name, 2});
  const QSize units = figure->printedUnits();
  figure->settleLayout(units);
  const QFontMetrics metrics(figure->style().tickFont());
  const QRect seen(QPoint(0, 0), units);
  std::vector<QRect> locations;
  for (const auto& name : names)
    for (int i = 0; i < figure->legend->itemCount(); ++i) {
      auto* item = qobject_cast<QCPPlottableLegendItem*>(figure->legend->item(i));
      if (!item || item->plottable()->name() != name) continue;
      EXPECT_TRUE(seen.contains(item->rect())) << name.toStdString();
      EXPECT_GE(item->rect().width(), metrics.boundingRect(name).width()) << name.toStdString();
      for (const QRect& other : locations) EXPECT_FALSE(other.intersects(item->rect())) << name.toStdString();
      locations.push_back(item->rect());
    }
  EXPECT_EQ(locations.size(), 4u);
}

TEST_F(FigureContent, aNameLongerThanTheFigureKeepsBothEnds) {
  auto figure = plots::abaPositionFigure(result_, plots::lightStyle());
  const QString name = "light-defect with a corrugation and sleepers of timber, 40 m/s, at the third attempt #4";
  plots::addCurve(*figure, {{0, 1}, {0, 1}, name, 2});
  const QString drawn = QString::fromUtf8(plots::toSvg(*figure));
  EXPECT_FALSE(drawn.contains(name));
  EXPECT_TRUE(drawn.contains(QRegularExpression(">light-defect[^<]*" + QString(QChar(0x2026)) + "[^<]*#4<")))
      << drawn.left(3000).toStdString();
  EXPECT_EQ(figure->graph(figure->graphCount() - 1)->name(), name);  // for tables
}

TEST_F(FigureContent, exactlyAsSeenTakesTheSizeOnScreen) {
  const auto figure = plots::psdFigure(result_, plots::darkStyle());
  const QImage image = plots::toImage(*figure, 96, {700, 400});
  EXPECT_EQ(image.size(), QSize(700, 400));
  EXPECT_EQ(image.pixelColor(1, 1), plots::darkStyle().background);
}

}  // namespace
}  // namespace squat
