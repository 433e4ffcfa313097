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

const char* drawnName(const signals::CatalogueRow& row, const signals::SignalCurve& curve) {
  return curve.filtered && row.filteredName ? row.filteredName : row.name;
}

// The signal of the left side that is drawn beside one of the right, in a figure that is of both sides alone.
const signals::CatalogueRow* ownLeft(const signals::CatalogueRow& row) {
  const auto* left = row.left ? signals::catalogueRow(row.left) : nullptr;
  return left && !left->curve.figure ? left : nullptr;
}

void fit(Figure& figure, const signals::SignalCurve& curve) {
  if (curve.withZero)
    fitWithZero(figure);
  else
    fitValues(figure);
}

std::string signalList(const std::vector<const signals::CatalogueRow*>& rows) {
  std::string list;
  for (const auto* row : rows) list += (list.empty() ? "" : " or ") + std::string(row->name);
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
  std::size_t colour = 0;
  const auto add = [&](const char* name, const char* label, const signals::SignalCurve& curve) {
    if (const auto* values = result.signal(name))
      addCurve(*drawn, {position, scaled(*values, curve.factor), QString::fromUtf8(label), colour,
                        curve.front ? 1.2 : 0.9, Qt::SolidLine, curve.front});
    ++colour;
  };
  for (const auto* row : rows) {
    if (const auto* left = ownLeft(*row)) add(drawnName(*left, row->curve), "left", row->curve);
    add(drawnName(*row, row->curve), row->curve.label, row->curve);
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
    return againstPosition(*other.record, drawnName(*first, first->curve), first->curve.factor);
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
