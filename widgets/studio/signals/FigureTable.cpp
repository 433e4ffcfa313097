#include "studio/signals/FigureTable.h"

#include <cmath>
#include <set>

#include "studio/common/Words.h"

namespace squat::studio {
namespace {

QByteArray numberCell(double value) { return QByteArray::number(value, 'g', 12); }

void addCurves(plots::Figure& figure, const QCPRange& seen, bool beside, QByteArray& text) {
  std::set<QString> taken;
  for (int i = 0; i < figure.graphCount(); ++i) {
    const QCPGraph* graph = figure.graph(i);
    const bool drawn = graph->pen().style() != Qt::NoPen || !graph->scatterStyle().isNone();
    if (!drawn) continue;
    const QString wanted = machineName(graph->name().isEmpty() ? figure.name() : graph->name());
    QString name = wanted;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = wanted + QString("_%1").arg(copy);
    for (const QCPGraphData& point : *graph->data())
      if (seen.contains(point.key))
        text += name.toUtf8() + ',' + numberCell(point.key) + ',' + numberCell(point.value) + (beside ? ",\n" : "\n");
  }
}

void addCells(const QCPColorMap& map, const QCPRange& seen, QByteArray& text) {
  QCPColorMapData& cells = *map.data();
  for (int column = 0; column < cells.keySize(); ++column)
    for (int row = 0; row < cells.valueSize(); ++row) {
      const QPointF location = cellLocation(map, column, row);
      if (seen.contains(location.x()))
        text += "map," + numberCell(location.x()) + ',' + numberCell(location.y()) + ',' +
                numberCell(cells.cell(column, row)) + '\n';
    }
}

}  // namespace

QPointF cellLocation(const QCPColorMap& map, int column, int row) {
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
  QByteArray text =
      "curve," + columnName(figure.xAxis->label()).toUtf8() + ',' + columnName(figure.yAxis->label()).toUtf8();
  if (map) text += ',' + columnName(map->colorScale() ? map->colorScale()->axis()->label() : QString("value")).toUtf8();
  text += '\n';
  addCurves(figure, seen, map != nullptr, text);
  if (map) addCells(*map, seen, text);
  return text;
}

}  // namespace squat::studio
