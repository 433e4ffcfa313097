#include "plots/DecayFigures.h"

#include <cmath>

#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

using receptance::RailDirection;

void useLogarithmicAxes(Figure& figure, double from, double to) {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (const double band : {100., 250., 500., 1000., 2000., 5000.}) ticker->addTick(band, QString::number(band));
  figure.xAxis->setScaleType(QCPAxis::stLogarithmic);
  figure.xAxis->setTicker(ticker);
  figure.xAxis->setLabel(QStringLiteral("Frequency [Hz]"));
  figure.xAxis->setRange(0.9 * from, 1.1 * to);
  figure.yAxis->setScaleType(QCPAxis::stLogarithmic);
  figure.yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  figure.yAxis->setNumberFormat(QStringLiteral("gb"));
  figure.yAxis->setNumberPrecision(0);
  figure.yAxis->setRange(0.1, 100);
}

void addMeasured(Figure& figure, const receptance::MeasuredDecayRates& measured, RailDirection direction) {
  Curve mean{{}, {}, QStringLiteral("measured, mean and range"), 1};
  Curve range{{}, {}, {}, 1, 0.8, Qt::DotLine};
  const auto& all = direction == RailDirection::vertical ? measured.vertical : measured.lateral;
  Curve highest = range;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].count == 0) continue;
    mean.x.push_back(measured.band[i]), mean.y.push_back(all[i].mean);
    range.x.push_back(measured.band[i]), range.y.push_back(all[i].lowest);
    highest.x.push_back(measured.band[i]), highest.y.push_back(all[i].highest);
  }
  if (mean.x.empty()) return;
  addCurve(figure, range), addCurve(figure, highest), addCurve(figure, mean);
}

std::unique_ptr<Figure> panel(const receptance::DecayRates& rates, const receptance::MeasuredDecayRates* measured,
                              RailDirection direction, const Style& style) {
  const bool vertical = direction == RailDirection::vertical;
  auto figure = std::make_unique<Figure>(
      vertical ? QStringLiteral("vertical decay rate") : QStringLiteral("lateral decay rate"), style);
  figure->yAxis->setLabel(vertical ? QStringLiteral("Vertical decay rate [dB/m]")
                                   : QStringLiteral("Lateral decay rate [dB/m]"));
  useLogarithmicAxes(*figure, rates.band.front(), rates.band.back());
  if (measured) addMeasured(*figure, *measured, direction);
  Curve limit{rates.band, {}, QStringLiteral("lower limit of ISO 3095"), 2, 1.1, Qt::DashLine};
  for (const double band : rates.band) limit.y.push_back(receptance::decayLimit(band, direction));
  addCurve(*figure, limit);
  Curve own{rates.band, vertical ? rates.vertical : rates.lateral, QStringLiteral("computed"), 0, 1.6};
  own.front = true;
  addCurve(*figure, own);
  return figure;
}

}  // namespace

FigureSheet decayFigures(const receptance::DecayRates& rates, const receptance::MeasuredDecayRates* measured,
                         const std::string& name, const std::string& title, const std::string& hash,
                         const Style& style) {
  FigureSheet sheet{name, {}, 1};
  sheet.panels.push_back(panel(rates, measured, RailDirection::vertical, style));
  sheet.panels.push_back(panel(rates, measured, RailDirection::lateral, style));
  sheet.panels.front()->setCaption(QString::fromStdString(title), QString::fromStdString(hash));
  alignAxes(sheet);
  return sheet;
}

}  // namespace squat::plots
