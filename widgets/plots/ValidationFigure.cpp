#include "plots/ValidationFigure.h"

#include <algorithm>
#include <cmath>

#include "plots/LineFigure.h"
#include "plots/UnitText.h"

namespace squat::plots {
namespace {

using statements::Judged;
using statements::Verdict;

constexpr double outside = 0.5;  // of a range, shown on either side of it

// 0 at the lower bound, 1 at the upper one; far above a lower bound without an upper one it nears 1.
double withinRange(const Judged& one) {
  const auto& s = one.statement;
  double share = 0;
  if (std::isinf(s.high))
    share = *one.value >= s.low ? 1 - s.low / *one.value : *one.value / s.low - 1;
  else if (std::isinf(s.low))
    share = *one.value / s.high;
  else
    share = (*one.value - s.low) / (s.high - s.low);
  return std::clamp(share, -outside, 1 + outside);
}

// Three digits; whole numbers where those would end before the point.
QString numberText(double value) {
  const bool large = std::abs(value) >= 1000 && std::abs(value) < 1e6;
  return large ? QString::number(value, 'f', 0) : QString::number(value, 'g', 3);
}

QString oursText(const Judged& one) {
  if (one.verdict == Verdict::notJudged) return "not judged";
  const QString range = "   (" + unitText(statements::rangeText(one.statement)) + ")";
  if (!one.value) return "none" + range;
  const auto& unit = one.statement.unit;
  const bool bare = unit.empty() || unit == "1" || unit == "ratio";
  return numberText(*one.value) + (bare ? QString() : " " + unitText(unit)) + range;
}

QSharedPointer<QCPAxisTickerText> ticksOf(const std::vector<Judged>& judged, bool names) {
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (std::size_t row = 0; row < judged.size(); ++row)
    ticker->addTick(static_cast<double>(row),
                    names ? QString::fromStdString(judged[row].statement.name) : oursText(judged[row]));
  return ticker;
}

void addMarks(Figure& figure, const std::vector<Judged>& judged, Verdict verdict, const QString& label,
              std::size_t colour, QCPScatterStyle::ScatterShape shape) {
  Curve curve{{}, {}, label + QStringLiteral(" (%1)").arg(countOf(judged, verdict)), colour, 1.4};
  for (std::size_t row = 0; row < judged.size(); ++row)
    if (judged[row].verdict == verdict && judged[row].value) {
      curve.x.push_back(withinRange(judged[row]));
      curve.y.push_back(static_cast<double>(row));
    }
  QCPGraph* graph = addCurve(figure, curve);
  graph->setLineStyle(QCPGraph::lsNone);
  const QColor ink = figure.style().curve(colour);
  graph->setScatterStyle(QCPScatterStyle(shape, QPen(ink, 1.4), ink, 6));
}

}  // namespace

FigureSheet validationFigure(const std::vector<Judged>& judged, const std::string& note, const Style& style) {
  auto figure = std::make_unique<Figure>("validation", style);
  const auto rows = static_cast<double>(judged.size());
  figure->setPrintedSize({180, 22 + 5.2 * std::max(1.0, rows)});
  figure->setCaption("Statements of the paper, judged at the axle box", QString::fromStdString(note));
  figure->xAxis->setLabel("Position in the accepted range (0: lower limit, 1: upper limit)");
  figure->xAxis->setRange(-outside - 0.1, 1 + outside + 0.1);
  figure->yAxis->setLabel(QString());
  addBand(*figure, 0, 1);
  addMarks(*figure, judged, Verdict::met, "met", 0, QCPScatterStyle::ssDisc);
  addMarks(*figure, judged, Verdict::notMet, "not met", 1, QCPScatterStyle::ssCross);
  for (QCPAxis* axis : {figure->yAxis, figure->yAxis2}) {
    axis->setTicker(ticksOf(judged, axis == figure->yAxis));
    axis->setTickLabels(true);
    axis->setSubTicks(false);
    axis->setRange(-0.7, std::max(0.7, rows - 0.3));
    axis->setRangeReversed(true);
  }
  return sheetOf("validation", std::move(figure));
}

}  // namespace squat::plots
