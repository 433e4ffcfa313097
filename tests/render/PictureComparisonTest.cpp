// The comparison with baselines fails for what a reader would see: in every figure, an erased curve, two swapped
// colours and a shifted label each change more pixels of the thumbnail than a baseline may differ in.
#include "render/PictureComparison.h"

#include <gtest/gtest.h>

#include <functional>

#include "plots/Application.h"
#include "plots/FigureFiles.h"
#include "plots/FigureSheet.h"
#include "plots/Figures.h"
#include "render/SyntheticLaboratory.h"
#include "render/SyntheticResult.h"

namespace squat {
namespace {

// Every figure as its baseline shows it.
std::vector<plots::FigureSheet> allSheets() {
  plots::ensureApplication();
  std::vector<plots::FigureSheet> sheets = tests::laboratorySheets();
  const auto result = tests::syntheticResult();
  for (const auto& name : plots::figureNames())
    if (auto figure = plots::makeFigure(name, result, plots::lightStyle()))
      sheets.push_back(plots::sheetOf(name, std::move(figure)));
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
    const auto range = plottable->getKeyRange(found);
    const auto axis = plottable->keyAxis()->range();
    if (found && range.upper >= axis.lower && range.lower <= axis.upper) list.push_back(plottable);
  }
  return list;
}

class EveryFigure : public testing::Test {
 protected:
  static void SetUpTestSuite() { sheets_ = new std::vector<plots::FigureSheet>(allSheets()); }
  static void TearDownTestSuite() { delete sheets_; }

  // Makes a change, looks, and takes it back: the picture must differ, and then be what it was.
  static void expectSeen(const plots::FigureSheet& sheet, const QImage& before, const std::string& what,
                         const std::function<void()>& change, const std::function<void()>& takeBack) {
    change();
    const auto found = tests::difference(pictureOf(sheet), before);
    takeBack();
    EXPECT_GT(found.pixels, 4 * tests::pixelsAllowed) << sheet.name << ": " << what;
    std::printf("%6lld pixels, %3d levels: %s, %s\n", found.pixels, found.largest, sheet.name.c_str(), what.c_str());
  }
  static inline std::vector<plots::FigureSheet>* sheets_ = nullptr;
};

TEST_F(EveryFigure, IsTheSameWhenDrawnAgain) {
  for (const auto& sheet : *sheets_) {
    const QImage first = pictureOf(sheet);
    EXPECT_EQ(tests::difference(first, pictureOf(sheet)).largest, 0) << sheet.name;
  }
}

TEST_F(EveryFigure, MissesAnErasedCurve) {
  int erased = 0;
  for (const auto& sheet : *sheets_) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels)
      for (auto* curve : drawn(*panel)) {
        const auto what = panel->name().toStdString() + " without '" + curve->name().toStdString() + "'";
        expectSeen(
            sheet, before, what, [&] { curve->setVisible(false); }, [&] { curve->setVisible(true); });
        ++erased;
      }
  }
  EXPECT_GT(erased, 60);
}

TEST_F(EveryFigure, MissesTheColoursOfTwoCurves) {
  int swapped = 0;
  for (const auto& sheet : *sheets_) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels) {
      const auto curves = drawn(*panel);
      for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
        auto *a = curves[i], *b = curves[i + 1];
        const QPen first = a->pen(), second = b->pen();
        if (first.color() == second.color() || first.style() == Qt::NoPen || second.style() == Qt::NoPen) continue;
        const auto paint = [](QCPAbstractPlottable* curve, QPen pen, const QColor& colour) {
          pen.setColor(colour);
          curve->setPen(pen);
        };
        expectSeen(
            sheet, before, panel->name().toStdString() + ", colours " + std::to_string(i) + " and the next",
            [&] { paint(a, first, second.color()), paint(b, second, first.color()); },
            [&] { a->setPen(first), b->setPen(second); });
        ++swapped;
      }
    }
  }
  EXPECT_GT(swapped, 10);
}

// By a millimetre of the printed figure, 1/96 inch each.
TEST_F(EveryFigure, MissesAShiftedLabel) {
  constexpr double millimetre = 96 / 25.4;
  int shifted = 0;
  for (const auto& sheet : *sheets_) {
    const QImage before = pictureOf(sheet);
    for (const auto& panel : sheet.panels) {
      auto* axis = panel->xAxis;
      const int padding = axis->labelPadding();
      if (!axis->label().isEmpty() && axis->visible()) {
        expectSeen(
            sheet, before, "axis label shifted", [&] { axis->setLabelPadding(padding + qRound(millimetre)); },
            [&] { axis->setLabelPadding(padding); });
        ++shifted;
      }
      for (int i = 0; i < panel->itemCount(); ++i) {
        auto* text = qobject_cast<QCPItemText*>(panel->item(i));
        if (!text || !text->visible()) continue;
        const QMargins margins = text->padding();
        expectSeen(
            sheet, before, "'" + text->text().toStdString() + "' shifted",
            [&] { text->setPadding(margins + QMargins(qRound(2 * millimetre), qRound(2 * millimetre), 0, 0)); },
            [&] { text->setPadding(margins); });
        ++shifted;
      }
    }
  }
  EXPECT_GT(shifted, 40);
}

}  // namespace
}  // namespace squat
