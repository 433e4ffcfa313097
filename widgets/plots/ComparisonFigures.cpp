#include "plots/ComparisonFigures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "analysis/AnalysisFiles.h"
#include "plots/AxisTicker.h"
#include "plots/LineFigure.h"
#include "plots/MapComparison.h"
#include "plots/ShownStretch.h"
#include "plots/UnitText.h"

namespace squat::plots {
namespace {

constexpr double comparedUpTo = 2500;  // [Hz]
constexpr double minimumShare = 1e-3;  // of the second's largest density, for a ratio

void setPlaceAxis(Figure& figure, const signals::Comparison& c) {
  figure.xAxis->setLabel(c.inPosition ? "Position relative to the impact [mm]" : "Time relative to the impact [ms]");
  const double perMetre = c.inPosition ? 1e3 : 1e3 / std::max(1e-3, c.firstFeatures.speed);
  if (!c.axis.empty())
    figure.xAxis->setRange(std::max(1e3 * c.axis.front(), -shownBefore * perMetre),
                           std::min(1e3 * c.axis.back(), shownAfter * perMetre));
}

void setDecades(Figure& figure) {
  for (QCPAxis* axis : {figure.yAxis, figure.yAxis2}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis->setNumberPrecision(0);
  }
}

std::unique_ptr<Figure> overlay(const signals::Comparison& c, const Style& style) {
  auto figure = std::make_unique<Figure>("overlay", style);
  setPlaceAxis(*figure, c);
  figure->yAxis->setLabel(QStringLiteral("Acceleration [%1]").arg(unitText(c.unit)));
  const auto axis = scaled(c.axis, 1e3);
  addCurve(*figure, {axis, c.second, QString::fromStdString(c.secondName), 1, 0.9});
  addCurve(*figure, {axis, c.first, QString::fromStdString(c.firstName), 0, 1.2, Qt::SolidLine, true});
  fitValues(*figure);
  figure->setCaption(
      "(a) both signals",
      QStringLiteral("peak ratio %1, correlation %2").arg(c.peakRatio, 0, 'f', 2).arg(c.correlation, 0, 'f', 2));
  return figure;
}

std::unique_ptr<Figure> difference(const signals::Comparison& c, bool smooth, const Style& style) {
  auto figure = std::make_unique<Figure>("difference", style);
  setPlaceAxis(*figure, c);
  figure->yAxis->setLabel(QStringLiteral("Difference [%1]").arg(unitText(c.unit)));
  addCurve(*figure, {scaled(c.axis, 1e3), c.difference, QString(), 2, 1.1});
  fitValues(*figure);
  figure->setCaption(smooth ? "(b) with defect minus smooth track" : "(b) first minus second",
                     QStringLiteral("maximum %1 %2").arg(c.differencePeak, 0, 'g', 3).arg(unitText(c.unit)));
  return figure;
}

std::unique_ptr<Figure> densities(const signals::Comparison& c, bool smooth, const Style& style) {
  auto figure = std::make_unique<Figure>("densities", style);
  figure->xAxis->setLabel("Frequency [Hz]");
  figure->yAxis->setLabel(QStringLiteral("PSD [(%1)²/Hz]").arg(unitText(c.unit)));
  figure->xAxis->setRange(0, comparedUpTo);
  addCurve(*figure,
           {c.secondSpectrum.frequency, c.secondSpectrum.density, QString::fromStdString(c.secondName), 1, 0.9});
  addCurve(*figure, {c.firstSpectrum.frequency, c.firstSpectrum.density, QString::fromStdString(c.firstName), 0, 1.2,
                     Qt::SolidLine, true});
  fitValues(*figure);
  const double top = figure->yAxis->range().upper;
  figure->yAxis->setRange(0, top);
  if (smooth && top > 0) {  // smooth track has a thousandth of the power: it would lie on the axis
    setDecades(*figure);
    figure->yAxis->setRange(1e-6 * top, 2 * top);
    figure->yAxis2->setRange(figure->yAxis->range());
  }
  figure->setCaption("(c) power spectral densities", QString());
  return figure;
}

std::unique_ptr<Figure> ratio(const signals::Comparison& c, bool smooth, const Style& style) {
  auto figure = std::make_unique<Figure>("ratio", style);
  figure->xAxis->setLabel("Frequency [Hz]");
  figure->yAxis->setLabel(smooth ? "PSD with defect / PSD smooth" : "PSD of first / PSD of second");
  figure->xAxis->setRange(0, comparedUpTo);
  figure->setCaption("(d) ratio of the PSDs", QString());
  const auto& second = c.secondSpectrum.density;
  const double largest = second.empty() ? 0 : *std::max_element(second.begin(), second.end());
  std::vector<double> value(c.densityRatio.size(), NAN);
  double low = INFINITY, high = 0;
  for (std::size_t k = 0; k < std::min(value.size(), second.size()); ++k) {
    if (c.firstSpectrum.frequency[k] > comparedUpTo) break;
    if (!(second[k] > minimumShare * largest) || !(c.densityRatio[k] > 0)) continue;
    value[k] = c.densityRatio[k];
    low = std::min(low, value[k]);
    high = std::max(high, value[k]);
  }
  if (!(high > 0)) {
    addNotice(*figure, "the second signal has no power");
    return figure;
  }
  setDecades(*figure);
  const double span = std::max(1.0, std::log10(high / low));
  figure->yAxis->setRange(low * std::pow(10, -0.06 * span), high * std::pow(10, 0.06 * span));
  figure->yAxis2->setRange(figure->yAxis->range());
  addCurve(*figure, {{0, comparedUpTo}, {1, 1}, QString(), 6, 0.6, Qt::DashLine});
  addCurve(*figure, {c.firstSpectrum.frequency, value, QString(), 3, 1.1, Qt::SolidLine, true});
  return figure;
}

// Results of one case in two folders have the same name: as many folders stand before it as it takes to tell them
// apart.
void addFolders(signals::Comparison& comparison, const std::string& firstFile, const std::string& secondFile) {
  const auto pathOf = [](const std::string& file) {
    std::error_code unknown;
    const auto whole = std::filesystem::absolute(file, unknown);
    return (unknown ? std::filesystem::path(file) : whole).lexically_normal();
  };
  const auto first = pathOf(firstFile), second = pathOf(secondFile);
  if (first.stem() != second.stem() || first.parent_path() == second.parent_path()) return;
  auto ofFirst = first.parent_path(), ofSecond = second.parent_path();
  for (bool apart = false; !apart && (ofFirst.has_relative_path() || ofSecond.has_relative_path());) {
    apart = ofFirst.filename() != ofSecond.filename();
    ofFirst = ofFirst.parent_path(), ofSecond = ofSecond.parent_path();
  }
  const auto shown = [](const std::filesystem::path& file, const std::filesystem::path& above) {
    const auto folder = file.parent_path().lexically_relative(above).generic_string();
    return folder.empty() || folder == "." ? std::string() : folder + "/";
  };
  comparison.firstName = shown(first, ofFirst) + comparison.firstName;
  comparison.secondName = shown(second, ofSecond) + comparison.secondName;
}

}  // namespace

FigureSheet comparisonFigure(const signals::Comparison& comparison, const std::string& name, bool smooth,
                             const Style& style) {
  FigureSheet sheet{name, {}, 2};
  sheet.panels.push_back(overlay(comparison, style));
  sheet.panels.push_back(difference(comparison, smooth, style));
  sheet.panels.push_back(densities(comparison, smooth, style));
  sheet.panels.push_back(ratio(comparison, smooth, style));
  return sheet;
}

std::vector<FigureSheet> comparisonFigures(const std::vector<analysis::FileComparison>& comparisons, bool smooth,
                                           const Style& style) {
  std::vector<FigureSheet> sheets;
  std::set<std::string> taken;
  for (const auto& pair : comparisons) {
    const std::string wanted = analysis::safeFileName(pair.comparison.secondName) + "_comparison";
    std::string name = wanted;
    for (int number = 2; !taken.insert(name).second; ++number) name = wanted + "_" + std::to_string(number);
    auto comparison = pair.comparison;
    addFolders(comparison, pair.firstFile, pair.secondFile);
    sheets.push_back(comparisonFigure(comparison, name, smooth, style));
    sheets.push_back(mapComparison(comparison, MapKind::scalogram, name + "_scalograms", style));
    sheets.push_back(mapComparison(comparison, MapKind::shortTime, name + "_stft", style));
  }
  return sheets;
}

}  // namespace squat::plots
