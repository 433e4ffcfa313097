#include "plots/CatalogueFigure.h"

#include <algorithm>
#include <vector>

#include "plots/LineFigure.h"
#include "plots/Overlays.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

using results::RunResult;

// Of a figure of the catalogue: at least one.
std::vector<const signals::CatalogueRow*> rowsOf(const std::string& figure) {
  std::vector<const signals::CatalogueRow*> rows;
  for (const auto& row : signals::signalCatalogue())
    if (row.curve.figure && figure == row.curve.figure) rows.push_back(&row);
  return rows;
}

void fit(Figure& figure, const signals::SignalCurve& curve) {
  if (curve.withZero)
    fitWithZero(figure);
  else
    fitValues(figure);
}

std::string signalList(const std::vector<const signals::CatalogueRow*>& rows) {
  std::string list;
  for (const auto* row : rows)
    if (!row->left) list += (list.empty() ? "" : " or ") + std::string(row->name);
  return list;
}

}  // namespace

std::unique_ptr<Figure> catalogueFigure(const std::string& figure, const RunResult& result, const Style& style,
                                        const std::function<void(Figure&)>& decorate) {
  const auto rows = rowsOf(figure);
  const auto& first = rows.front()->curve;
  auto drawn = std::make_unique<Figure>(figure.c_str(), style);
  const Window window = judgedWindow(result);
  drawn->xAxis->setLabel("Wheel position relative to the defect [mm]");
  drawn->yAxis->setLabel(QString::fromUtf8(first.axis));
  drawn->xAxis->setRange(1e3 * window.from, 1e3 * window.to);
  const std::vector<double> position = scaled(result.position, 1e3);
  const bool isWhole = signals::hasRightSide(result);
  std::size_t colour = 0;
  for (const auto* row : rows) {
    const auto label = QString::fromUtf8(row->curve.label);
    if (const auto* values = result.signal(row->name))
      addCurve(*drawn, {position, scaled(*values, row->curve.factor), isWhole && !row->left ? label + ", left" : label,
                        colour, row->curve.front ? 1.2 : 0.9, Qt::SolidLine, row->curve.front});
    ++colour;
  }
  if (drawn->graphCount() == 0)
    addNotice(*drawn, "no signal " + QString::fromStdString(signalList(rows)) + " in this result");
  if (decorate) decorate(*drawn);
  fit(*drawn, first);
  setCaption(*drawn, result);
  return drawn;
}

FigureRow catalogueRow(const std::string& figure) {
  const auto rows = rowsOf(figure);
  const auto* first = rows.front();
  FigureRow row;
  row.name = figure, row.tab = first->curve.tab, row.title = first->curve.title;
  row.needs = "Needs the signal " + signalList(rows) + ".";
  row.applies = [rows](const RunResult& result) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto* each) { return result.signal(each->name); });
  };
  row.build = [figure](const RunResult& result, const Style& style, const FigureSettings&) {
    return catalogueFigure(figure, result, style);
  };
  row.overlay = [first](const OverlaidRun& other, const RunResult&, const FigureSettings&) {
    return againstPosition(*other.record, first->name, first->curve.factor);
  };
  row.fit = [first](Figure& drawn, const FigureSettings&) { fit(drawn, first->curve); };
  row.marks = FigureMarks::extremes;
  return row;
}

std::vector<std::string> catalogueFigures() {
  std::vector<std::string> names;
  for (const auto& row : signals::signalCatalogue())
    if (row.curve.figure && std::count(names.begin(), names.end(), row.curve.figure) == 0)
      names.emplace_back(row.curve.figure);
  return names;
}

}  // namespace squat::plots
