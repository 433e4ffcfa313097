// widgets/plots/LineFigure.h - the few strokes that all line figures are made of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plots/Figure.h"
#include "results/RunResult.h"

namespace squat::plots {

struct Curve {
  std::vector<double> x, y;  // same length; not-a-number breaks the line
  QString label;             // empty: not in the legend
  std::size_t colour = 0;    // of Style::curve
  double width = 1.1;
  Qt::PenStyle line = Qt::SolidLine;
  bool front = false;  // above the other curves
  QColor own = {};     // valid: in place of the colour
};

std::vector<double> scaled(const std::vector<double>& values, double factor);

QCPGraph* addCurve(Figure& figure, const Curve& curve);

// Vertical band from `from` to `to` on the x axis, behind the curves.
void addBand(Figure& figure, double from, double to);

// Label above a point of the curve: centred, or beginning (Qt::AlignLeft) or ending (Qt::AlignRight) there.
QCPItemText* addPointLabel(Figure& figure, double x, double y, const QString& text,
                           Qt::AlignmentFlag side = Qt::AlignHCenter);

// Short text in the middle of the axes, e.g. why there is nothing to see. The figure owns it.
QCPItemText* addNotice(Figure& figure, const QString& text);
void clearNotices(Figure& figure);

// No curve has a point, and there is no map.
bool holdsNothing(Figure& figure);
// In place of axes that have nothing to show: what to do next. Nothing else is seen.
void showEmpty(Figure& figure, const QString& nextStep);

// Range of y over the curves' points with x in the x axis's range, widened by `margin` of its span on both sides;
// never empty.
void fitValues(Figure& figure, double margin = 0.06);
// Widens the range of y to zero.
void keepZeroInSight(Figure& figure);
// fitValues() with zero in sight; of a density, from zero, with room for the names of its lines.
void fitWithZero(Figure& figure);
void fitDensity(Figure& figure);

// "left side: " of a whole model's record, else empty.
QString noteOfLeftSide(const results::AnalysedRecord& result);

// Caption of every figure: title, and stem with hash; says so where the run is incomplete, and where of a whole model
// the left side alone is shown.
enum class ShownSide { every, left };
void setCaption(Figure& figure, const results::AnalysedRecord& result, ShownSide side = ShownSide::every);

// Stretch of the profile that is not flat [m]; empty (from == to == 0) for a smooth rail.
struct Extent {
  double from = 0, to = 0;
  bool empty() const { return !(to > from); }
};
Extent defectExtent(const results::RunResult& result);

// The stretch around the defect that signals are judged in [m]: the window of the PSD, or all of the record.
struct Window {
  double from = 0, to = 0;
};
Window judgedWindow(const results::AnalysedRecord& result);

}  // namespace squat::plots
