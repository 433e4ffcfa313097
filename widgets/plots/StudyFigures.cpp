#include "plots/StudyFigures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "analysis/AnalysisFiles.h"
#include "case/ParameterTable.h"
#include "case/RightSide.h"
#include "plots/AxisTicker.h"
#include "plots/LineFigure.h"
#include "plots/UnitText.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::plots {
namespace {

constexpr std::size_t maximumCurves = 12, maximumPanels = 9, columns = 3;
constexpr std::size_t maximumNamed = 3 * columns;  // curves in the legends of the first row of panels

// Beginnings of the names of features, in the order of the panels.
const std::vector<std::string>& shownFeatures() {
  static const std::vector<std::string> names{
      "peak [",       "largest moving rms",  "largest contact force", "power 130-320",      "power 200-400",
      "power 1000-1", "wavelength by ridge", "peak 1 frequency",      "free vibration 1000"};
  return names;
}

// Places of a key's values on the axis: the numbers themselves, or 0, 1, 2 ... where one of them is none.
std::vector<double> axisValues(const studies::Variation& variation, bool& numeric) {
  std::vector<double> values;
  numeric = true;
  for (const auto& entry : variation.values) {
    const auto value = text::numberFromText(entry);
    numeric = numeric && value.has_value();
    values.push_back(value.value_or(0));
  }
  if (!numeric)
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  return values;
}

std::optional<double> featureOf(const studies::StudyRow& row, const std::string& name) {
  for (const auto& [key, value] : row.features)
    if (key == name) return value;
  return std::nullopt;
}

// The features that there are: those of the list, or the first ones of the table where none is known.
std::vector<std::string> featuresIn(const studies::StudyTable& table) {
  std::vector<std::string> all, shown;
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::done && all.empty())
      for (const auto& [name, value] : row.features) all.push_back(name);
  for (const auto& beginning : shownFeatures())
    for (const auto& name : all)
      if (name.rfind(beginning, 0) == 0 && std::find(shown.begin(), shown.end(), name) == shown.end()) {
        shown.push_back(name);
        break;
      }
  if (shown.empty()) shown = all;
  if (shown.size() > maximumPanels) shown.resize(maximumPanels);
  return shown;
}

QString axisLabel(const std::string& key) {
  const auto* parameter = cases::findOnEitherSide(key);
  const std::string unit = parameter ? parameter->unit : std::string();
  return QString::fromStdString(key) + (unit.empty() || unit == "-" ? QString() : " [" + unitText(unit) + "]");
}

// Values of the other keys, as the label of a curve.
std::string othersOf(const studies::StudyDefinition& definition, const studies::StudyPoint& point, std::size_t key) {
  std::string text;
  for (std::size_t v = 0; v < point.values.size(); ++v) {
    if (v == key) continue;
    const auto& name = definition.variations[v].key;
    const auto* parameter = cases::findParameter(name);
    const bool hasUnit = parameter && !parameter->unit.empty() && parameter->unit != "-";
    text += (text.empty() ? "" : ", ") + name.substr(name.rfind('.') + 1) + " " + point.values[v] +
            (hasUnit ? " " + text::printedUnit(parameter->unit) : std::string());
  }
  return text;
}

// Which curves a panel's legend names: `from` up to, not including, `to`.
struct Named {
  std::size_t from = 0, to = 0;
};

// Three or fewer curves in the first panel; more are shared out over the panels of the first row, so that a legend
// stays one line; too many are not named.
Named namedIn(std::size_t panel, std::size_t curves) {
  if (curves < 2 || curves > maximumNamed || panel >= columns) return {};
  if (curves <= columns) return panel == 0 ? Named{0, curves} : Named{};
  const std::size_t share = (curves + columns - 1) / columns;
  return {panel * share, (panel + 1) * share};
}

std::unique_ptr<Figure> panel(const studies::StudyTable& table, std::size_t key, const std::string& feature,
                              Named named, const Style& style) {
  auto figure = std::make_unique<Figure>(QString::fromStdString(feature), style);
  const auto& variation = table.definition.variations[key];
  bool numeric = true;
  const auto values = axisValues(variation, numeric);
  figure->xAxis->setLabel(axisLabel(variation.key));
  figure->yAxis->setLabel(unitText(feature));
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double margin = *high > *low ? 0.06 * (*high - *low) : std::max(0.5, 0.1 * std::abs(*high));
  figure->xAxis->setRange(*low - margin, *high + margin);
  if (!numeric) {
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (std::size_t i = 0; i < values.size(); ++i)
      ticker->addTick(values[i], QString::fromStdString(variation.values[i]));
    figure->xAxis->setTicker(ticker);
    figure->xAxis2->setTicker(ticker);
  }
  std::map<std::string, std::size_t> colours;
  std::vector<Curve> curves;
  for (const auto& row : table.rows) {
    const auto others = table.definition.isList ? std::string() : othersOf(table.definition, row.point, key);
    const auto [found, isNew] = colours.try_emplace(others, curves.size());
    const bool isNamed = curves.size() >= named.from && curves.size() < named.to;
    if (isNew) curves.push_back({{}, {}, isNamed ? QString::fromStdString(others) : QString(), curves.size(), 1.1});
    const auto at = table.definition.isList
                        ? variation.values.begin() + static_cast<std::ptrdiff_t>(row.point.index)
                        : std::find(variation.values.begin(), variation.values.end(), row.point.values[key]);
    const auto value = row.state == studies::RowState::done ? featureOf(row, feature) : std::nullopt;
    curves[found->second].x.push_back(values[static_cast<std::size_t>(at - variation.values.begin())]);
    curves[found->second].y.push_back(value.value_or(NAN));
  }
  for (std::size_t i = 0; i < std::min(curves.size(), maximumCurves); ++i) {
    QCPGraph* graph = addCurve(*figure, curves[i]);
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, style.curve(i), style.curve(i), 4));
    // Nothing lies between two names, or between points that differ in all keys.
    if (!numeric || table.definition.isList) graph->setLineStyle(QCPGraph::lsNone);
  }
  const bool empty = std::all_of(curves.begin(), curves.end(), [](const Curve& curve) {
    return std::all_of(curve.y.begin(), curve.y.end(), [](double y) { return std::isnan(y); });
  });
  if (empty) addNotice(*figure, feature.rfind("free vibration", 0) == 0 ? "longer than the record" : "no value");
  fitValues(*figure, 0.1);
  return figure;
}

}  // namespace

std::vector<FigureSheet> studyFigures(const studies::StudyTable& table, const Style& style) {
  std::vector<FigureSheet> sheets;
  const auto features = featuresIn(table);
  if (features.empty()) return sheets;
  for (std::size_t key = 0; key < table.definition.variations.size(); ++key) {
    FigureSheet sheet{
        "study_" + analysis::safeFileName(table.definition.variations[key].key), {}, static_cast<int>(columns)};
    std::size_t curves = 1;
    for (std::size_t v = 0; v < table.definition.variations.size(); ++v)
      if (v != key && !table.definition.isList) curves *= table.definition.variations[v].values.size();
    for (std::size_t i = 0; i < features.size(); ++i) {
      auto figure = panel(table, key, features[i], namedIn(i, curves), style);
      const QString note = curves > maximumNamed
                               ? QStringLiteral("%1 curves, one for each combination of the other keys%2")
                                     .arg(std::min(curves, maximumCurves))
                                     .arg(curves > maximumCurves ? QStringLiteral(" (of %1)").arg(curves) : QString())
                               : QString();
      figure->setCaption(i == 0 ? QString::fromStdString(table.definition.caseName) : QString(),
                         i == 1   ? note
                         : i == 2 ? QString::fromStdString(table.definition.caseHash)
                                  : QString());
      sheet.panels.push_back(std::move(figure));
    }
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

}  // namespace squat::plots
