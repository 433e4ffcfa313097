#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/Features.h"
#include "signals/SignalCatalogue.h"
#include "signals/ThirdOctaves.h"

namespace squat::plots {
namespace {

constexpr double highestShownFrequency = 2500;  // [Hz] a little beyond the filter's cut-off
constexpr double octavesFrom = 88;              // [Hz] edge below the band of 100 Hz
constexpr double octavesTo = 2900;              // [Hz] beyond the upper edge of the band of 2500 Hz
constexpr double reference = 1e-6;              // [m/s2] of levels, ISO 1683
constexpr double shownDecibels = 60;            // below the largest value

// The lines that the tables name, at the same frequencies.
std::vector<signals::SpectralPeak> linesOf(const results::AnalysedRecord& result) {
  if (result.frequency.size() < 3 || result.psd.size() != result.frequency.size()) return {};
  signals::PowerSpectrum spectrum;
  spectrum.frequency = result.frequency;
  spectrum.density = result.psd;
  return signals::namedLines(spectrum);
}

// A density or a power as a level [dB]; a gap where there is none.
double levelOf(double value) { return value > 0 ? 10 * std::log10(value / (reference * reference)) : NAN; }

// Labels of near lines of about the same height stand back to back, so that they do not touch.
void addLineLabels(Figure& figure, const std::vector<signals::SpectralPeak>& lines, analysis::SpectrumScale scale) {
  const bool decades = scale == analysis::SpectrumScale::logarithmic;
  const auto drawn = [&](const signals::SpectralPeak& line) {
    return scale == analysis::SpectrumScale::decibel ? levelOf(line.density) : line.density;
  };
  const auto height = [&](double value) { return decades ? std::log10(value) : value; };
  const QCPRange range = figure.yAxis->range();
  const double wide = 0.08 * figure.xAxis->range().size(), high = 0.08 * (height(range.upper) - height(range.lower));
  for (const auto& line : lines) {
    auto side = Qt::AlignHCenter;
    for (const auto& other : lines) {
      const double apart = line.frequency - other.frequency;
      if (apart == 0 || std::abs(apart) > wide || std::abs(height(drawn(line)) - height(drawn(other))) > high) continue;
      side = apart > 0 ? Qt::AlignLeft : Qt::AlignRight;
    }
    figure.addMark(addPointLabel(figure, line.frequency, drawn(line), QString::number(line.frequency, 'f', 0), side),
                   figure.graph(0));
  }
}

QString labelOf(analysis::SpectrumScale scale) {
  switch (scale) {
    case analysis::SpectrumScale::decibel:
      return QStringLiteral("PSD [dB re (1 µm/s²)²/Hz]");
    case analysis::SpectrumScale::thirdOctaves:
      return QStringLiteral("Level [dB re 1 µm/s²]");
    case analysis::SpectrumScale::linear:
    case analysis::SpectrumScale::logarithmic:
      break;
  }
  return QStringLiteral("PSD [(m/s²)²/Hz]");
}

signals::PowerSpectrum asSpectrum(const std::vector<double>& frequency, const std::vector<double>& density) {
  signals::PowerSpectrum spectrum;
  spectrum.frequency = frequency;
  spectrum.density = density;
  return spectrum;
}

std::vector<signals::OctaveBand> bandsWithin(const std::vector<double>& frequency) {
  return signals::thirdOctaveBands(octavesFrom, std::min(octavesTo, frequency.back()));
}

// A step from edge to edge for each band.
Curve octaveCurve(const std::vector<double>& frequency, const std::vector<double>& density) {
  Curve curve;
  if (frequency.size() < 2 || density.size() != frequency.size()) return curve;
  const auto bands = bandsWithin(frequency);
  const auto levels = signals::bandLevels(asSpectrum(frequency, density), bands, reference);
  for (std::size_t i = 0; i < bands.size(); ++i)
    for (const double edge : {bands[i].lowest, bands[i].highest}) {
      curve.x.push_back(edge);
      curve.y.push_back(std::isfinite(levels[i]) ? levels[i] : NAN);
    }
  return curve;
}

void setDecadeTicks(QCPAxis& axis, QCPAxis& opposite, const QSharedPointer<QCPAxisTicker>& ticker) {
  for (QCPAxis* each : {&axis, &opposite}) {
    each->setScaleType(QCPAxis::stLogarithmic);
    each->setTicker(ticker);
  }
}

// Bands that are narrower than what the stretch of the spectrum resolves (one over its time) are shaded: neighbours
// share their power.
void shadeUnresolved(Figure& figure, const results::AnalysedRecord& result,
                     const std::vector<signals::OctaveBand>& bands, double section) {
  const double length = section > 0 ? section : result.psdTo - result.psdFrom;
  const double time = result.speed > 0 ? length / result.speed : 0;
  if (!(time > 0)) return;
  double upTo = 0;
  for (const auto& band : bands)
    if (band.highest - band.lowest < 1 / time) upTo = band.highest;
  if (!(upTo > 0)) return;
  addBand(figure, bands.front().lowest, upTo);
  auto* remark = new QCPItemText(&figure);
  remark->position->setType(QCPItemPosition::ptAxisRectRatio);
  remark->position->setCoords(0.015, 0.02);
  remark->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  remark->setFont(figure.style().tickFont());
  remark->setColor(figure.style().muted);
  remark->setText(QStringLiteral("shaded: narrower than\n%1 Hz, the resolution").arg(1 / time, 0, 'f', 0));
  remark->setTextAlignment(Qt::AlignLeft);
  remark->setSelectable(false);
}

// The axis of frequencies with a tick at each band and the nominal frequency at every second one.
void setOctaveAxis(Figure& figure, const results::AnalysedRecord& result, double section) {
  const auto bands = bandsWithin(result.frequency);
  if (bands.empty()) return;
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (std::size_t i = 0; i < bands.size(); ++i)
    ticker->addTick(bands[i].middle, i % 2 == 0 ? QString::number(bands[i].nominal) : QString());
  setDecadeTicks(*figure.xAxis, *figure.xAxis2, ticker);
  figure.xAxis->setRange(bands.front().lowest, bands.back().highest);
  figure.xAxis2->setRange(figure.xAxis->range());
  shadeUnresolved(figure, result, bands, section);
}

}  // namespace

Curve spectrumCurve(const std::vector<double>& frequency, const std::vector<double>& density,
                    analysis::SpectrumScale scale) {
  if (scale == analysis::SpectrumScale::thirdOctaves) return octaveCurve(frequency, density);
  Curve curve;
  curve.x = frequency;
  curve.y = density;
  for (double& value : curve.y) {
    if (scale == analysis::SpectrumScale::decibel) value = levelOf(value);
    if (scale == analysis::SpectrumScale::logarithmic && !(value > 0)) value = NAN;
  }
  return curve;
}

void fitSpectrum(Figure& figure, analysis::SpectrumScale scale) {
  if (scale == analysis::SpectrumScale::linear) return fitDensity(figure);
  fitValues(figure, 0);
  const double top = figure.yAxis->range().upper;
  if (scale == analysis::SpectrumScale::logarithmic) {
    const double highest = top > 0 ? top : 1;
    setDecadeTicks(*figure.yAxis, *figure.yAxis2, QSharedPointer<QCPAxisTickerLog>::create());
    figure.yAxis->setNumberFormat("eb");  // powers of ten
    figure.yAxis->setNumberPrecision(0);
    figure.yAxis->setRange(highest * std::pow(10, -0.1 * shownDecibels), 3 * highest);
  } else {
    constexpr double tick = 10, room = 4;  // [dB] for the names of lines
    const double upper = tick * std::ceil((top + room) / tick);
    figure.yAxis->setRange(upper - shownDecibels, upper);
  }
  figure.yAxis2->setRange(figure.yAxis->range());
}

std::unique_ptr<Figure> psdFigure(const results::AnalysedRecord& result, const Style& style,
                                  analysis::SpectrumScale scale, double section) {
  auto figure = std::make_unique<Figure>("psd", style);
  figure->xAxis->setLabel("Frequency [Hz]");
  figure->yAxis->setLabel(labelOf(scale));
  const bool isThere = result.frequency.size() > 1 && result.psd.size() == result.frequency.size();
  if (!isThere) addNotice(*figure, "no spectrum in this result");
  const auto add = [&](const std::vector<double>& density, const QString& label, std::size_t colour, double width) {
    Curve curve = spectrumCurve(result.frequency, density, scale);
    curve.label = label;
    curve.colour = colour;
    curve.width = width;
    curve.front = colour == 0;
    addCurve(*figure, curve);
  };
  const bool isWhole = signals::hasRightSide(result);
  add(result.psd, result.psdWheel.empty() ? QString() : QString(isWhole ? "axle box, left" : "axle box"), 0, 1.2);
  if (result.psdWheel.size() == result.frequency.size() && !result.psdWheel.empty())
    add(result.psdWheel, isWhole ? "wheel, left" : "wheel centre", 1, 0.8);
  const double top =
      result.frequency.empty() ? highestShownFrequency : std::min(highestShownFrequency, result.frequency.back());
  figure->xAxis->setRange(0, std::max(top, 1.0));
  const bool octaves = scale == analysis::SpectrumScale::thirdOctaves;
  if (octaves && isThere) setOctaveAxis(*figure, result, section);
  fitSpectrum(*figure, scale);
  if (!octaves) addLineLabels(*figure, linesOf(result), scale);
  setCaption(*figure, result, ShownSide::left);
  return figure;
}

}  // namespace squat::plots
