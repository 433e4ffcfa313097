#include "plots/FigureRegistry.h"

#include <algorithm>

#include "core/Errors.h"

namespace squat::plots {
namespace {

using results::RunResult;

void addOverlays(Figure& figure, const FigureRow& row, const RunResult& shown, const FigureSettings& settings,
                 const std::vector<OverlaidRun>& overlays) {
  bool any = false;
  for (const auto& run : overlays) {
    Curve curve = row.overlay(run, shown, settings);
    if (curve.y.empty()) continue;
    curve.label = QString::fromStdString(run.label);
    curve.own = run.colour.isValid() ? run.colour : figure.style().overlay(run.colourIndex);
    curve.width = 0.9;
    addCurve(figure, curve);
    any = true;
  }
  if (!any) return;
  if (row.fit)
    row.fit(figure, settings);
  else
    fitValues(figure);
}

}  // namespace

std::string unitOf(FigureAxis axis) {
  switch (axis) {
    case FigureAxis::time:
      return "ms";
    case FigureAxis::frequency:
      return "Hz";
    case FigureAxis::stress:
      return "MPa";
    case FigureAxis::wheelPosition:
    case FigureAxis::railPosition:
    case FigureAxis::patch:
      break;
  }
  return "mm";
}

const FigureRow& figureRow(const std::string& name) {
  std::string names;
  for (const auto& row : figureRegistry()) {
    if (row.name == name) return row;
    names += (names.empty() ? "" : ", ") + row.name;
  }
  throw CaseError({{"--figures", name, names, "Name one or more of these, separated by commas"}});
}

std::unique_ptr<Figure> buildFigure(const FigureRow& row, const RunResult& result, const Style& style,
                                    const FigureSettings& settings, const std::vector<OverlaidRun>& overlays) {
  if (!row.build)
    throw CaseError({{"--figures", row.name, "a figure that is a plot", "The 3-D picture is written as PNG only"}});
  auto figure = row.build(result, style, settings);
  if (row.overlay) addOverlays(*figure, row, result, settings, overlays);
  return figure;
}

std::string figureList() {
  std::size_t widest = 0;
  for (const auto& row : figureRegistry()) widest = std::max(widest, row.name.size());
  std::string text;
  for (const auto& row : figureRegistry())
    text += "  " + row.name + std::string(widest + 2 - row.name.size(), ' ') + row.title + "\n";
  return text;
}

}  // namespace squat::plots
