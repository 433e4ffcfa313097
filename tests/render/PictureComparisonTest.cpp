// The comparison with baselines fails for what a reader would see: in every figure, an erased curve, two swapped
// colours and a shifted label each change more pixels of the thumbnail than a baseline may differ in.
#include "render/PictureComparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "plots/Application.h"
#include "plots/FigureFiles.h"
#include "plots/FigureRegistry.h"
#include "plots/FigureSheet.h"
#include "render/SyntheticResult.h"
#include "render/SyntheticSheets.h"

namespace squat {
namespace {

// Every figure as its baseline shows it.
std::vector<plots::FigureSheet> allSheets() {
  plots::ensureApplication();
  std::vector<plots::FigureSheet> sheets = tests::syntheticSheets();
  const auto result = tests::syntheticResult();
  for (const auto& row : plots::figureRegistry())
    if (row.build && row.applies(result))
      sheets.push_back(plots::sheetOf(row.name, plots::buildFigure(row, result, plots::lightStyle())));
  return sheets;
}

QImage pictureOf(const plots::FigureSheet& sheet) {
  return tests::thumbnail(plots::toImage(sheet, 200), sheet.panels.size() > 1 ? 420 : 251);
}

// What there is to see of a plot: curves and coloured maps that have data within the axes.
std::vector<QCPAbstractPlottable*> drawn(plots::Figure& figure) {
  std::vector<QCPAbstractPlottable*> list;
  for (int i = 0; i < figure.plottableCount(); ++i) {
    auto* plottable = figure.plottable(i);
    bool found = false;
    if (!plottable->visible()) continue;
    // The lower edge of a filled band is not drawn itself.
    const auto* graph = qobject_cast<const QCPGraph*>(plottable);
    if (graph && graph->pen().style() == Qt::NoPen && graph->scatterStyle().isNone() &&
        graph->brush().style() == Qt::NoBrush)
      continue;
    const auto range = plottable->getKeyRange(found);
    const auto axis = plottable->keyAxis()->range();
    if (found && range.upper >= axis.lower && range.lower <= axis.upper) list.push_back(plottable);
  }
  return list;
}

constexpr long long readable = 200;  // pixels at 200 dpi: 3 mm of a curve

// Pixels whose colour a reader sees change: by a sixth of the range of a channel.
long long clearlyChanged(const QImage& before, const QImage& after) {
  constexpr int clear = 42;
  long long count = 0;
  for (int y = 0; y < before.height(); ++y)
    for (int x = 0; x < before.width(); ++x) {
      const QRgb a = before.pixel(x, y), b = after.pixel(x, y);
      count += std::abs(qRed(a) - qRed(b)) > clear || std::abs(qGreen(a) - qGreen(b)) > clear ||
               std::abs(qBlue(a) - qBlue(b)) > clear;
    }
  return count;
}

class EveryFigure : public testing::Test {
 protected:
  static void SetUpTestSuite() { everySheet = new std::vector<plots::FigureSheet>(allSheets()); }
  static void TearDownTestSuite() { delete everySheet; }

  // Makes a change, looks, and takes it back: the thumbnail must differ where a reader would see the change in the
  // printed figure. Whether they would: curves may lie under others or beyond the axes.
  static bool expectSeen(const plots::FigureSheet& sheet, const QImage& before, const std::string& what,
                         const std::function<void()>& change, const std::function<void()>& takeBack) {
    const QImage printed = plots::toImage(sheet, 200);
    change();
    const bool isReadable = clearlyChanged(printed, plots::toImage(sheet, 200)) >= readable;
    const auto found = tests::difference(pictureOf(sheet), before);
    takeBack();
    if (isReadable) {
      EXPECT_GT(found.pixels, 4 * tests::pixelsAllowed) << sheet.name << ": " << what;
    }
    return isReadable;
  }
  static inline std::vector<plots::FigureSheet>* everySheet = nullptr;
};

TEST_F(EveryFigure, IsTheSameWhenDrawnAgain) {
  for (const auto& sheet : *everySheet) {
    const QImage first = pictureOf(sheet);
    EXPECT_EQ(tests::difference(first, pictureOf(sheet)).largest, 0) << sheet.name;
  }
}

TEST_F(EveryFigure, MissesAnErasedCurve) {
  int erased = 0;
  for (const auto& sheet : *everySheet) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels)
      for (auto* curve : drawn(*panel)) {
        const auto what = panel->name().toStdString() + " without '" + curve->name().toStdString() + "'";
        erased += expectSeen(
            sheet, before, what, [&] { curve->setVisible(false); }, [&] { curve->setVisible(true); });
      }
  }
  EXPECT_GT(erased, 60);
}

TEST_F(EveryFigure, MissesTheColoursOfTwoCurves) {
  int swapped = 0;
  for (const auto& sheet : *everySheet) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels) {
      const auto curves = drawn(*panel);
      for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
        auto *a = curves[i], *b = curves[i + 1];
        const QPen first = a->pen(), second = b->pen();
        // Neighbours on a graded scale of colours are alike on purpose.
        const QColor one = first.color(), other = second.color();
        const int apart = std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                    std::abs(one.blue() - other.blue())});
        if (apart < 48 || first.style() == Qt::NoPen || second.style() == Qt::NoPen) continue;
        const auto paint = [](QCPAbstractPlottable* curve, QPen pen, const QColor& colour) {
          pen.setColor(colour);
          curve->setPen(pen);
        };
        swapped += expectSeen(
            sheet, before, panel->name().toStdString() + ", colours " + std::to_string(i) + " and the next",
            [&] { paint(a, first, second.color()), paint(b, second, first.color()); },
            [&] { a->setPen(first), b->setPen(second); });
      }
    }
  }
  EXPECT_GT(swapped, 10);
}

// By a millimetre of the printed figure, 1/96 inch each.
TEST_F(EveryFigure, MissesAShiftedLabel) {
  constexpr double millimetre = 96 / 25.4;
  int shifted = 0;
  for (const auto& sheet : *everySheet) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels) {
      auto* axis = panel->xAxis;
      const int padding = axis->labelPadding();
      if (!axis->label().isEmpty() && axis->visible()) {
        shifted += expectSeen(
            sheet, before, "axis label shifted", [&] { axis->setLabelPadding(padding + qRound(millimetre)); },
            [&] { axis->setLabelPadding(padding); });
      }
      for (int i = 0; i < panel->itemCount(); ++i) {
        auto* text = qobject_cast<QCPItemText*>(panel->item(i));
        if (!text || !text->visible()) continue;
        const QMargins margins = text->padding();
        shifted += expectSeen(
            sheet, before, "'" + text->text().toStdString() + "' shifted",
            [&] { text->setPadding(margins + QMargins(qRound(2 * millimetre), qRound(2 * millimetre), 0, 0)); },
            [&] { text->setPadding(margins); });
      }
    }
  }
  EXPECT_GT(shifted, 40);
}

}  // namespace
}  // namespace squat
