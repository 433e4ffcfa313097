#include <algorithm>
#include <cmath>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/Errors.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "plots/SleeperSpans.h"
#include "scenario/DefectSurface.h"

namespace squat::plots {
namespace {

constexpr double surroundings = 0.04;  // [m] shown on both sides of the defect
constexpr double stripHeight = 0.07;   // share of the axes' height taken by the sleepers below

void addSleeper(Figure& figure, const Span& span, double from, double to) {
  const double left = std::max(span.from * 1e3, from), right = std::min(span.to * 1e3, to);
  if (right <= left) return;
  auto* box = new QCPItemRect(&figure);
  for (QCPItemPosition* corner : {box->topLeft, box->bottomRight}) {
    corner->setTypeX(QCPItemPosition::ptPlotCoords);
    corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  box->topLeft->setCoords(left, 1 - stripHeight);
  box->bottomRight->setCoords(right, 1);
  box->setPen(Qt::NoPen);
  QColor fill = figure.style().muted;
  fill.setAlpha(90);
  box->setBrush(fill);
  auto* label = new QCPItemText(&figure);
  label->position->setTypeX(QCPItemPosition::ptPlotCoords);
  label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(0.5 * (left + right), 1 - 0.5 * stripHeight);
  label->setFont(figure.style().captionFont());
  label->setColor(figure.style().text);
  label->setText("sleeper");
}

// A defect of several lines is shown line by line; they stand in the case that the result carries.
void addLines(Figure& figure, const results::RunResult& result) {
  if (!result.resolvedCase) return;  // a case that this version does not take any more: the running line alone
  const auto& surface = result.resolvedCase->scenario.defectSurface;
  std::size_t colour = 2;
  for (const double lateral : surface.lateralLines()) {
    Curve curve;
    for (const double x : result.profilePosition) curve.y.push_back(surface.height(x, lateral) * 1e6);
    curve.x = scaled(result.profilePosition, 1e3);
    curve.label = QString("line at %1 mm").arg(lateral * 1e3, 0, 'g', 3);
    curve.colour = colour++;
    curve.width = 0.9;
    addCurve(figure, curve);
  }
}

// The tread of a wheel that is not round, unrolled: at each position the material that lies below the axle there, at
// the middle of the running band. Returns the stretch of its dip [m]; empty where the wheel is round.
Extent addTread(Figure& figure, const results::RunResult& result) {
  if (!result.resolvedCase) return {};
  const auto& scenario = result.resolvedCase->scenario;
  const auto& tread = scenario.tread;
  if (tread.isRound()) return {};
  const auto curve = tread.curveAt(0);
  Curve drawn;
  for (const double x : result.profilePosition)
    drawn.y.push_back(curve.at(tread.angleAt(x, scenario.wheelset.radius)).height * 1e6);
  drawn.x = scaled(result.profilePosition, 1e3);
  drawn.label = "tread of the wheel, unrolled";
  drawn.colour = 3;
  drawn.width = 1.3;
  addCurve(figure, drawn);
  if (!tread.isLocal()) return {};
  return {tread.position() - tread.dipBefore(), tread.position() + tread.dipBehind()};
}

// What the wheel rolls on where the rail is not smooth.
void addIrregularity(Figure& figure, const results::RunResult& result) {
  if (!result.resolvedCase || result.resolvedCase->scenario.irregularity.isSmooth()) return;
  const auto& irregularity = result.resolvedCase->scenario.irregularity;
  Curve curve;
  for (std::size_t i = 0; i < result.profilePosition.size(); ++i)
    curve.y.push_back(1e6 * (result.profileHeight[i] + irregularity.height(result.profilePosition[i])));
  curve.x = scaled(result.profilePosition, 1e3);
  curve.label = "with the irregularity of the rail";
  curve.colour = 4;
  curve.width = 0.9;
  addCurve(figure, curve);
}

// The path is that over the defect (simulation/Describe.cpp).
QString pathLabel(const results::RunResult& result) {
  const bool rough = result.resolvedCase && !result.resolvedCase->scenario.irregularity.isSmooth();
  return rough ? "path of a rigid wheel, without the irregularity" : "path of a rigid wheel";
}

}  // namespace

std::unique_ptr<Figure> defectProfileFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("defect_profile", style);
  figure->xAxis->setLabel("Position along the rail [mm]");
  figure->yAxis->setLabel("Height [µm]");
  double from = -0.1, to = 0.1;
  const Extent defect = defectExtent(result), flat = addTread(*figure, result);
  if (defect.empty() && flat.empty()) {
    const bool rough = result.resolvedCase && !result.resolvedCase->scenario.irregularity.isSmooth();
    addNotice(*figure, rough ? "no defect" : "smooth rail: no defect");
  } else {
    from = std::min(defect.empty() ? flat.from : defect.from, flat.empty() ? defect.from : flat.from) - surroundings;
    to = std::max(defect.empty() ? flat.to : defect.to, flat.empty() ? defect.to : flat.to) + surroundings;
  }
  const std::vector<double> x = scaled(result.profilePosition, 1e3);
  figure->xAxis->setRange(from * 1e3, to * 1e3);
  if (!x.empty()) addCurve(*figure, {x, scaled(result.profileHeight, 1e6), "rail surface", 0, 1.3});
  if (result.wheelPath.size() == x.size() && !x.empty())
    addCurve(*figure, {x, scaled(result.wheelPath, 1e6), pathLabel(result), 1, 1.0, Qt::DashLine});
  addLines(*figure, result);
  addIrregularity(*figure, result);
  fitValues(*figure, 0.1);
  const QCPRange range = figure->yAxis->range();
  figure->yAxis->setRange(range.lower - stripHeight * range.size(), range.upper);
  for (const Span& span : sleeperSpans(result.surface)) addSleeper(*figure, span, from * 1e3, to * 1e3);
  setCaption(*figure, result, ShownSide::left);
  return figure;
}

}  // namespace squat::plots
