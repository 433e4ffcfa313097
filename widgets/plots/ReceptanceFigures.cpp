#include "plots/ReceptanceFigures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

void setFrequencyAxis(Figure& figure, const receptance::TrackReceptance& r) {
  figure.xAxis->setLabel(QStringLiteral("Frequency [Hz]"));
  figure.xAxis->setRange(0, r.frequency.back());
}

// What a decibel counts from, as usual for each quantity.
struct Reference {
  double value;
  QString name, label;
};
Reference referenceOf(receptance::ReceptanceQuantity quantity) {
  switch (quantity) {
    case receptance::ReceptanceQuantity::mobility:
      return {1e-6, QStringLiteral("mobility of the track"), QStringLiteral("Mobility [dB re 1 µm/(N s)]")};
    case receptance::ReceptanceQuantity::accelerance:
      return {1e-3, QStringLiteral("accelerance of the track"), QStringLiteral("Accelerance [dB re 1 mm/(N s²)]")};
    default:
      return {1e-9, QStringLiteral("receptance of the track"), QStringLiteral("Receptance [dB re 1 nm/N]")};
  }
}

std::unique_ptr<Figure> magnitudes(const receptance::TrackReceptance& r, receptance::ReceptanceQuantity quantity,
                                   const Style& style) {
  const auto zero = referenceOf(quantity);
  auto figure = std::make_unique<Figure>(zero.name, style);
  figure->yAxis->setLabel(zero.label);
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    Curve curve{r.frequency, {}, QString::fromStdString(r.points[i].name), i};
    for (const auto& value : receptance::asQuantity(r.frequency, r.points[i].receptance, quantity))
      curve.y.push_back(20 * std::log10(std::abs(value) / zero.value));
    addCurve(*figure, curve);
  }
  setFrequencyAxis(*figure, r);
  fitValues(*figure);
  return figure;
}

std::unique_ptr<Figure> phases(const receptance::TrackReceptance& r, receptance::ReceptanceQuantity quantity,
                               const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("phase"), style);
  figure->yAxis->setLabel(QStringLiteral("Phase [°]"));
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    Curve curve{r.frequency, {}, {}, i};
    for (const auto& value : receptance::asQuantity(r.frequency, r.points[i].receptance, quantity))
      curve.y.push_back(std::arg(value) * 180 / std::numbers::pi);
    addCurve(*figure, curve);
  }
  setFrequencyAxis(*figure, r);
  const bool transfers =
      std::any_of(r.points.begin(), r.points.end(), [](const auto& p) { return p.struck != p.read; });
  const double turned = 90 * static_cast<int>(quantity);
  if (transfers)
    figure->yAxis->setRange(-185, 185);
  else
    figure->yAxis->setRange(-185 + turned, 5 + turned);
  return figure;
}

// A stroke from zero for every mode, broken where both sides move oppositely.
std::unique_ptr<Figure> modes(const receptance::TrackReceptance& r, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("modes of the wheelset"), style);
  figure->yAxis->setLabel(QStringLiteral("Mode shape [1/√kg]"));
  const struct {
    const char* label;
    double model::HarmonicMode::*share;
  } shares[] = {{"axle box", &model::HarmonicMode::boxAmplitude},
                {"wheel centre", &model::HarmonicMode::wheelAmplitude},
                {"contact", &model::HarmonicMode::contactAmplitude}};
  double width = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    width = 0.004 * r.frequency.back() * static_cast<double>(i);  // side by side
    for (const auto centre : {model::Centre::symmetric, model::Centre::antisymmetric}) {
      const bool alike = centre == model::Centre::symmetric;
      Curve curve{{},
                  {},
                  QString::fromUtf8(shares[i].label) + (alike ? "" : ", antisymmetric"),
                  i,
                  alike ? 2.0 : 1.2,
                  alike ? Qt::SolidLine : Qt::DotLine};
      for (const auto& mode : r.modes) {
        if (mode.centre != centre) continue;
        curve.x.insert(curve.x.end(), {mode.frequency + width, mode.frequency + width, mode.frequency + width});
        curve.y.insert(curve.y.end(), {0, std::abs(mode.*(shares[i].share)), NAN});
      }
      if (!curve.x.empty()) addCurve(*figure, curve);
    }
  }
  setFrequencyAxis(*figure, r);
  fitValues(*figure);
  return figure;
}

}  // namespace

FigureSheet receptanceFigures(const receptance::TrackReceptance& receptance, const std::string& name,
                              const std::string& title, const std::string& hash, const Style& style,
                              receptance::ReceptanceQuantity quantity) {
  FigureSheet sheet{name, {}, 1};
  sheet.panels.push_back(magnitudes(receptance, quantity, style));
  sheet.panels.push_back(phases(receptance, quantity, style));
  if (!receptance.modes.empty()) sheet.panels.push_back(modes(receptance, style));
  sheet.panels.front()->setCaption(QString::fromStdString(title), QString::fromStdString(hash));
  alignAxes(sheet);
  return sheet;
}

}  // namespace squat::plots
