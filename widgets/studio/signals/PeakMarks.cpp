#include "studio/signals/PeakMarks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signals/Peaks.h"
#include "studio/signals/FigureTable.h"

namespace squat::studio {
namespace {

constexpr int maximumMarks = 3;
constexpr double minimumShare = 0.1;  // of the strongest

// A text at a mark. Which side has room is known only when the figure has its size, on the screen or in a file.
class MarkText : public QCPItemText {
 public:
  MarkText(plots::Figure& figure, double x, double y, bool above) : QCPItemText(&figure), x_(x), y_(y), above_(above) {}

 protected:
  void draw(QCPPainter* painter) override {
    if (location(*painter)) QCPItemText::draw(painter);
  }

 private:
  // False where the mark is out of sight or the whole text has no room: a part of it would be another number.
  bool location(QCPPainter& painter) {
    position->setCoords(x_, y_);
    const QPointF mark = position->pixelPosition();
    const QRectF room = clipRect();
    painter.setFont(font());
    const QSizeF size = painter.fontMetrics().size(0, text()).grownBy(padding());
    if (!room.contains(mark) || size.width() > room.width() || size.height() > room.height()) return false;
    const bool fitsLeft = mark.x() - size.width() >= room.left(), fitsRight = mark.x() + size.width() <= room.right();
    const bool wishesLeft = mark.x() > room.left() + 0.65 * room.width();  // by the right edge it is looked for there
    const bool toLeft = wishesLeft ? fitsLeft || !fitsRight : fitsLeft && !fitsRight;
    const double start =
        std::clamp(toLeft ? mark.x() - size.width() : mark.x(), room.left(), room.right() - size.width());
    const double upper =
        std::clamp(above_ ? mark.y() - size.height() : mark.y(), room.top(), room.bottom() - size.height());
    setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    position->setPixelPosition({start, upper});
    return true;
  }

  double x_, y_;
  bool above_;
};

// `curve`: that the mark is on; null: none.
void addMark(plots::Figure& figure, QCPAbstractPlottable* curve, const QPointF& place, const QString& text, bool above,
             const QColor& ground) {
  auto* ring = new QCPItemTracer(&figure);
  ring->setStyle(QCPItemTracer::tsCircle);
  ring->setSize(7);
  ring->setPen(QPen(figure.style().curve(3), 1.4));
  ring->setBrush(Qt::NoBrush);
  ring->position->setCoords(place);
  ring->setSelectable(false);
  auto* label = new MarkText(figure, place.x(), place.y(), above);
  label->setFont(figure.style().tickFont());
  label->setColor(figure.style().text);
  label->setBrush(ground);
  label->setPadding(QMargins(5, 1, 5, 1));
  label->setText(text);
  label->setSelectable(false);
  for (QCPAbstractItem* item : {static_cast<QCPAbstractItem*>(ring), static_cast<QCPAbstractItem*>(label)})
    item->setLayer("overlay"), figure.addMark(item, curve);
}

QString signedText(double value, int digits) { return QString::number(value, 'f', digits).replace('-', QChar(0x2212)); }

// "94 at 12.3 mm"
QString locationText(double value, double location, const QString& unit) {
  return QObject::tr("%1 at %2 %3").arg(signedText(value, 0), signedText(location, 1), unit);
}

const QCPColorMap* mapOf(plots::Figure& figure) {
  for (int i = 0; i < figure.plottableCount(); ++i)
    if (const auto* map = qobject_cast<const QCPColorMap*>(figure.plottable(i))) return map;
  return nullptr;
}

// [Hz] lowest frequency at this place that the ends of the record do not distort; 0 where the figure has no cone.
double trustedFrom(const plots::Figure& figure, double location) {
  for (int i = 0; i < figure.graphCount(); ++i) {
    const QCPGraph& graph = *figure.graph(i);
    if (graph.name() == "cone of influence" && !graph.data()->isEmpty())
      return graph.data()->findBegin(location)->value;
  }
  return 0;
}

}  // namespace

void markExtremes(plots::Figure& figure, const QString& unit) {
  if (figure.graphCount() == 0) return;
  const QCPRange seen = figure.xAxis->range();
  const QCPGraphData *highest = nullptr, *lowest = nullptr;
  for (const QCPGraphData& point : *figure.graph(0)->data()) {
    if (!seen.contains(point.key) || !std::isfinite(point.value)) continue;
    if (!highest || point.value > highest->value) highest = &point;
    if (!lowest || point.value < lowest->value) lowest = &point;
  }
  if (!highest || highest->value == lowest->value) return;
  const QCPRange values = figure.yAxis->range();
  constexpr double room = 0.08;  // for the texts
  figure.yAxis->setRange(values.lower - room * values.size(), values.upper + room * values.size());
  for (const QCPGraphData* point : {highest, lowest})
    addMark(figure, figure.graph(0), {point->key, point->value}, locationText(point->value, point->key, unit),
            point == highest, Qt::transparent);
}

void markLines(plots::Figure& figure, const QString& unit) {
  const QCPColorMap* map = mapOf(figure);
  if (!map) return;
  QCPColorMapData& cells = *map->data();
  std::vector<double> largest(static_cast<std::size_t>(cells.valueSize()), 0.0);
  std::vector<int> columnOf(largest.size(), 0);
  for (int row = 0; row < cells.valueSize(); ++row)
    for (int column = 0; column < cells.keySize(); ++column)
      if (cells.cell(column, row) > largest[static_cast<std::size_t>(row)]) {
        largest[static_cast<std::size_t>(row)] = cells.cell(column, row);
        columnOf[static_cast<std::size_t>(row)] = column;
      }
  const double strongest = *std::max_element(largest.begin(), largest.end());
  if (!(strongest > 0)) return;
  auto peaks = signals::findPeaks(largest, minimumShare * strongest);
  std::sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.height > b.height; });
  QColor ground = figure.style().background;
  ground.setAlpha(200);
  for (std::size_t i = 0; i < std::min<std::size_t>(peaks.size(), maximumMarks); ++i) {
    const QPointF at = cellLocation(*map, columnOf[peaks[i].index], static_cast<int>(peaks[i].index));
    QString text = QObject::tr("%1 Hz at %2 %3").arg(at.y(), 0, 'f', 0).arg(signedText(at.x(), 0), unit);
    if (at.y() < trustedFrom(figure, at.x())) text += QObject::tr(" (edge effect)");
    addMark(figure, nullptr, at, text, true, ground);
  }
}

}  // namespace squat::studio
