#include "studio/FigureTable.h"

#include <cmath>

namespace squat::studio {
namespace {

QByteArray quoted(QString text) { return '"' + text.replace('"', '\'').toUtf8() + '"'; }

QByteArray number(double value) { return QByteArray::number(value, 'g', 12); }

void addCurves(plots::Figure& figure, const QCPRange& seen, bool beside, QByteArray& text) {
  for (int i = 0; i < figure.graphCount(); ++i) {
    const QCPGraph* graph = figure.graph(i);
    const bool drawn = graph->pen().style() != Qt::NoPen || !graph->scatterStyle().isNone();
    if (!drawn) continue;
    for (const QCPGraphData& point : *graph->data())
      if (seen.contains(point.key))
        text += quoted(graph->name()) + ',' + number(point.key) + ',' + number(point.value) + (beside ? ",\n" : "\n");
  }
}

void addCells(const QCPColorMap& map, const QCPRange& seen, QByteArray& text) {
  QCPColorMapData& cells = *map.data();
  for (int column = 0; column < cells.keySize(); ++column)
    for (int row = 0; row < cells.valueSize(); ++row) {
      const QPointF place = cellPlace(map, column, row);
      if (seen.contains(place.x()))
        text += "\"map\"," + number(place.x()) + ',' + number(place.y()) + ',' + number(cells.cell(column, row)) + '\n';
    }
}

}  // namespace

QPointF cellPlace(const QCPColorMap& map, int column, int row) {
  double x = 0, y = 0;
  map.data()->cellToCoord(column, row, &x, &y);
  const QCPRange values = map.data()->valueRange();
  if (map.valueAxis()->scaleType() == QCPAxis::stLogarithmic && values.lower > 0 && values.size() > 0)
    y = values.lower * std::pow(values.upper / values.lower, (y - values.lower) / values.size());
  return {x, y};
}

QByteArray figureTable(plots::Figure& figure) {
  const QCPColorMap* map = nullptr;
  for (int i = 0; i < figure.plottableCount() && !map; ++i) map = qobject_cast<const QCPColorMap*>(figure.plottable(i));
  const QCPRange seen = figure.xAxis->range();
  QByteArray text = "curve," + quoted(figure.xAxis->label()) + ',' + quoted(figure.yAxis->label());
  if (map) text += ',' + quoted(map->colorScale() ? map->colorScale()->axis()->label() : QString("value"));
  text += '\n';
  addCurves(figure, seen, map != nullptr, text);
  if (map) addCells(*map, seen, text);
  return text;
}

}  // namespace squat::studio
