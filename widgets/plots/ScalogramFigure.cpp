#include <algorithm>
#include <cmath>

#include "analysis/Maps.h"
#include "colours/ColourTables.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "plots/MapFigure.h"
#include "plots/ScalogramGrid.h"
#include "plots/UnitText.h"
#include "signals/Resample.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

constexpr double lowestShown = 50, highestShown = 3000;  // [Hz] shown at most
constexpr std::size_t maximumColumns = 2000;             // of a short-time transform: more than a figure has pixels

QCPColorGradient gradientOf(const std::string& map) {
  QCPColorGradient gradient;
  gradient.clearColorStops();
  constexpr int stops = 64;
  for (int i = 0; i <= stops; ++i) {
    const double share = static_cast<double>(i) / stops;
    const colours::Rgb colour = colours::colourAt(map, share);
    gradient.setColorStopAt(share, QColor::fromRgbF(colour.red, colour.green, colour.blue));
  }
  return gradient;
}

// Readable by those who do not tell red from green.
QCPColorGradient divergingGradient() {
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0, QColor(33, 102, 172));
  gradient.setColorStopAt(0.25, QColor(146, 197, 222));
  gradient.setColorStopAt(0.5, QColor(255, 255, 255));
  gradient.setColorStopAt(0.75, QColor(244, 165, 130));
  gradient.setColorStopAt(1, QColor(178, 24, 43));
  return gradient;
}

QSharedPointer<QCPAxisTickerText> frequencyTicks(double from, double to) {
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (double tick : {10, 20, 50, 100, 200, 300, 500, 1000, 2000, 3000, 5000, 10000})
    if (tick >= 0.999 * from && tick <= 1.001 * to) ticker->addTick(tick, QString::number(tick));
  return ticker;
}

void addColourScale(Figure& figure, QCPColorMap& map, const QString& label) {
  auto* scale = new QCPColorScale(&figure);
  figure.addBeside(scale);
  scale->setType(QCPAxis::atRight);
  scale->setBarWidth(8);
  map.setColorScale(scale);
  scale->axis()->setLabel(label);
  scale->axis()->setLabelFont(figure.style().labelFont());
  scale->axis()->setTickLabelFont(figure.style().tickFont());
  scale->axis()->setLabelColor(figure.style().text);
  scale->axis()->setTickLabelColor(figure.style().text);
  scale->axis()->setNumberFormat("gb");
  scale->axis()->setTickLength(3, 0);
  scale->axis()->setSubTicks(false);
  scale->axis()->setTickLabelPadding(3);
  scale->axis()->setLabelPadding(2);
  for (QCPAxis* axis : {scale->axis()}) {
    axis->setBasePen(QPen(figure.style().axis, 0.8));
    axis->setTickPen(QPen(figure.style().axis, 0.8));
  }
  auto* group = new QCPMarginGroup(&figure);
  figure.axisRect()->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMinimumMargins(QMargins(4, 0, 4, 0));
}

// Below the curve of the cone the ends of the record count: shaded, bounded by a dashed line.
void addCone(Figure& figure, const ScalogramGrid& grid, const QColor& colour) {
  if (grid.cone.empty()) return;
  std::vector<double> clipped(grid.cone);
  for (double& frequency : clipped) frequency = std::clamp(frequency, grid.frequencyFrom, grid.frequencyTo);
  QCPGraph* floor = addCurve(
      figure, {{grid.positionFrom * 1e3, grid.positionTo * 1e3}, {grid.frequencyFrom, grid.frequencyFrom}, QString()});
  floor->setPen(Qt::NoPen);
  std::vector<double> position(clipped.size());
  for (std::size_t i = 0; i < position.size(); ++i)
    position[i] = 1e3 * (grid.positionFrom + (grid.positionTo - grid.positionFrom) * static_cast<double>(i) /
                                                 static_cast<double>(position.size() - 1));
  QCPGraph* edge = addCurve(figure, {position, clipped, QString()});
  edge->setPen(QPen(colour, 0.9, Qt::DashLine));
  edge->setBrush(QColor(255, 255, 255, 90));
  edge->setName("cone of influence");
  edge->setChannelFillGraph(floor);
}

}  // namespace

std::unique_ptr<Figure> mapFigure(const results::AnalysedRecord& result, const Style& style, const MapLook& look) {
  auto figure = std::make_unique<Figure>(look.name, style);
  figure->setPrintedSize({85, 62});
  figure->xAxis->setLabel("Position of the wheel [mm]");
  figure->yAxis->setLabel("Frequency [Hz]");
  setCaption(*figure, result, ShownSide::left);
  const Window window = judgedWindow(result);
  const ScalogramGrid grid = scalogramGrid(result, window.from, window.to, lowestShown, highestShown);
  if (grid.power.empty()) {
    addNotice(*figure, QStringLiteral("no %1 in this result").arg(look.name));
    return figure;
  }
  auto* map = new QCPColorMap(figure->xAxis, figure->yAxis);
  map->data()->setSize(grid.columns, grid.rows);
  map->data()->setRange(QCPRange(grid.positionFrom * 1e3, grid.positionTo * 1e3),
                        QCPRange(grid.frequencyFrom, grid.frequencyTo));
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      map->data()->setCell(column, row, grid.power[static_cast<std::size_t>(row) * grid.columns + column]);
  map->setInterpolate(true);
  map->setTightBoundary(true);
  map->removeFromLegend();
  addColourScale(*figure, *map, look.label);
  map->setGradient(look.diverging ? divergingGradient() : gradientOf(style.colourMap));
  map->setDataRange(look.high > look.low ? QCPRange(look.low, look.high)
                                         : QCPRange(0, grid.largestPower > 0 ? grid.largestPower : 1));
  addCone(*figure, grid, look.diverging ? QColor(110, 110, 110) : QColor(Qt::white));
  figure->yAxis->setScaleType(QCPAxis::stLogarithmic);
  figure->yAxis->setTicker(frequencyTicks(grid.frequencyFrom, grid.frequencyTo));
  figure->yAxis2->setScaleType(QCPAxis::stLogarithmic);
  figure->yAxis2->setTicker(figure->yAxis->ticker());
  figure->yAxis->setRange(grid.frequencyFrom, grid.frequencyTo);
  figure->yAxis2->setRange(figure->yAxis->range());
  figure->xAxis->setRange(grid.positionFrom * 1e3, grid.positionTo * 1e3);
  for (QCPAxis* axis : {figure->xAxis, figure->yAxis}) axis->grid()->setVisible(false);
  return figure;
}

namespace {

// That of the signal that the map was made from: a measured one may be no acceleration.
std::string signalUnit(const results::AnalysedRecord& result) {
  for (const auto& channel : result.signals)
    if (channel.name == signals::names::axleBoxFiltered) return channel.unit;
  return "m/s2";
}

QString scaleLabel(const QString& quantity, const results::AnalysedRecord& result) {
  return quantity.arg(unitText(signalUnit(result)));
}

}  // namespace

std::unique_ptr<Figure> scalogramFigure(const results::AnalysedRecord& result, const Style& style) {
  return mapFigure(result, style, {"scalogram", scaleLabel("Wavelet power [(%1)² s]", result)});
}

std::unique_ptr<Figure> amplitudeScalogramFigure(const results::AnalysedRecord& result, const Style& style) {
  return mapFigure(result, style, {"scalogram", scaleLabel("Wavelet power [(%1)²]", result)});
}

std::unique_ptr<Figure> stftFigure(const results::AnalysedRecord& result, const Style& style, std::size_t segment,
                                   std::size_t hop) {
  results::AnalysedRecord local;
  local.stem = result.stem;
  local.title = result.title;
  local.caseHash = result.caseHash;
  local.complete = result.complete;
  local.stopReason = result.stopReason;
  local.psdFrom = result.psdFrom;
  local.psdTo = result.psdTo;
  local.position = result.position;
  const std::vector<double>* values = result.signal(signals::names::axleBoxFiltered);
  if (values && values->size() == result.time.size() && values->size() > segment && result.time.size() > 1) {
    signals::StftOptions options;
    options.segment = segment;
    options.hop = std::max(hop > 0 ? hop : std::max<std::size_t>(1, segment / 32), values->size() / maximumColumns);
    options.transformLength = 8 * segment;
    std::vector<std::string> notes;
    const auto stft = *analysis::stftMap(signals::seriesOf(result, signals::names::axleBoxFiltered), options, notes);
    // Row 0 is the mean, which has no place on a logarithmic axis.
    local.scalogramFrequency.assign(stft.frequency.begin() + 1, stft.frequency.end());
    local.scalogramPower.assign(stft.density.begin() + static_cast<std::ptrdiff_t>(stft.time.size()),
                                stft.density.end());
    local.scalogramTime = stft.time;
    for (double time : stft.time)
      local.scalogramPosition.push_back(signals::interpolateLinear(result.time, result.position, time));
  }
  auto figure = mapFigure(local, style, {"stft", scaleLabel("Power density [(%1)²/Hz]", result)});
  setCaption(*figure, result, ShownSide::left);
  return figure;
}

}  // namespace squat::plots
