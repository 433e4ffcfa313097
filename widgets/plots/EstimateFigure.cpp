#include "plots/EstimateFigure.h"

#include <cmath>

#include "estimation/Estimation.h"
#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

constexpr double toMillimetres = 1e3, toMicrometres = 1e6;

// Where the wheel feels the rail, or where it does not; gaps elsewhere, but for the samples that join both.
Curve heights(const estimation::Estimate& estimate, bool isFelt) {
  const auto& profile = estimate.profile;
  Curve curve;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const bool joins =
        !isFelt && ((i > 0 && !profile[i - 1].isFelt) || (i + 1 < profile.size() && !profile[i + 1].isFelt));
    curve.x.push_back(toMillimetres * profile[i].position);
    curve.y.push_back(profile[i].isFelt == isFelt || joins ? toMicrometres * profile[i].height : NAN);
  }
  return curve;
}

void addBounds(Figure& figure, const estimation::Estimate& estimate, const Style& style) {
  Curve lower, upper;
  for (const auto& sample : estimate.profile) {
    lower.x.push_back(toMillimetres * sample.position), upper.x.push_back(toMillimetres * sample.position);
    lower.y.push_back(toMicrometres * sample.lower), upper.y.push_back(toMicrometres * sample.upper);
  }
  lower.label = QStringLiteral("90 %");
  QCPGraph* below = addCurve(figure, lower);
  QCPGraph* above = addCurve(figure, upper);
  for (QCPGraph* graph : {below, above}) graph->setPen(QPen(style.muted, 0.5));
  below->setBrush(style.band);
  below->setChannelFillGraph(above);
}

std::unique_ptr<Figure> profilePanel(const estimation::Estimate& estimate, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("estimated profile"), style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(QStringLiteral("Height [µm]"));
  addBounds(*figure, estimate, style);
  Curve felt = heights(estimate, true), unfelt = heights(estimate, false);
  felt.label = QStringLiteral("estimate");
  addCurve(*figure, felt);
  unfelt.line = Qt::DashLine;
  for (const auto& sample : estimate.profile)
    if (!sample.isFelt) unfelt.label = QStringLiteral("not felt");
  if (!unfelt.label.isEmpty()) addCurve(*figure, unfelt);
  if (!estimate.profile.empty())
    figure->xAxis->setRange(toMillimetres * estimate.profile.front().position,
                            toMillimetres * estimate.profile.back().position);
  fitValues(*figure);
  figure->showLegend(true);
  return figure;
}

std::unique_ptr<Figure> passagePanel(const estimation::ExplainedPassage& passage, const Style& style) {
  auto figure = std::make_unique<Figure>(QString::fromStdString(passage.name), style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(QStringLiteral("Acceleration [m/s²]"));
  const auto position = scaled(passage.position, toMillimetres);
  addCurve(*figure, {position, passage.measured, QStringLiteral("measured"), 1});
  addCurve(*figure, {position, passage.computed, QStringLiteral("computed"), 0});
  if (!position.empty()) figure->xAxis->setRange(position.front(), position.back());
  fitValues(*figure);
  figure->showLegend(true);
  return figure;
}

}  // namespace

FigureSheet estimateFigure(const estimation::Estimate& estimate, const Style& style) {
  FigureSheet sheet{"estimate", {}, 1};
  sheet.panels.push_back(profilePanel(estimate, style));
  for (const auto& passage : estimate.passages) {
    sheet.panels.push_back(passagePanel(passage, style));
    sheet.panels.back()->setCaption(QString::fromStdString(passage.name), {});
  }
  for (const auto& panel : sheet.panels) panel->setPrintedSize({120, 55});
  return sheet;
}

}  // namespace squat::plots
