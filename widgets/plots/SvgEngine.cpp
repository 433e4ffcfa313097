#include "plots/SvgEngine.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPixmap>

namespace squat::plots {
namespace {

QString number(double value) { return QString::number(value, 'g', 7); }

QString colour(const char* what, const QColor& colour) {
  QString text = QStringLiteral(" %1=\"%2\"").arg(what, colour.name());
  if (colour.alpha() < 255) text += QStringLiteral(" %1-opacity=\"%2\"").arg(what, number(colour.alphaF()));
  return text;
}

QString pathData(const QPainterPath& path) {
  QString data;
  for (int i = 0; i < path.elementCount(); ++i) {
    const QPainterPath::Element& at = path.elementAt(i);
    const char* letter = at.type == QPainterPath::MoveToElement    ? "M"
                         : at.type == QPainterPath::LineToElement  ? "L"
                         : at.type == QPainterPath::CurveToElement ? "C"
                                                                   : "";
    data += QStringLiteral("%1%2,%3 ").arg(letter, number(at.x), number(at.y));
  }
  return data.trimmed();
}

}  // namespace

SvgEngine::SvgEngine()
    : QPaintEngine(PrimitiveTransform | AlphaBlend | PainterPaths | Antialiasing | ConstantOpacity | PixmapTransform) {}

bool SvgEngine::begin(QPaintDevice*) {
  definitions_.clear();
  body_.clear();
  clips_.clear();
  return true;
}

// Everything is asked from the painter when something is drawn.
void SvgEngine::updateState(const QPaintEngineState&) {}

QString SvgEngine::stroke() const {
  const QPen pen = painter()->pen();
  if (pen.style() == Qt::NoPen) return QStringLiteral(" stroke=\"none\"");
  const double width = pen.widthF() > 0 ? pen.widthF() : 1.0;
  QString text = colour("stroke", pen.color()) + QStringLiteral(" stroke-width=\"%1\"").arg(number(width));
  if (pen.capStyle() != Qt::FlatCap)
    text += pen.capStyle() == Qt::RoundCap ? " stroke-linecap=\"round\"" : " stroke-linecap=\"square\"";
  if (pen.joinStyle() == Qt::RoundJoin) text += " stroke-linejoin=\"round\"";
  QStringList dashes;
  for (double dash : pen.dashPattern()) dashes << number(dash * width);
  if (!dashes.isEmpty()) text += QStringLiteral(" stroke-dasharray=\"%1\"").arg(dashes.join(','));
  return text;
}

QString SvgEngine::fill() const {
  const QBrush brush = painter()->brush();
  return brush.style() == Qt::NoBrush ? QStringLiteral(" fill=\"none\"") : colour("fill", brush.color());
}

void SvgEngine::element(const QString& text) {
  QString attributes;
  const QTransform transform = painter()->combinedTransform();
  if (painter()->hasClipping()) {
    const QRectF box = transform.mapRect(painter()->clipBoundingRect());
    const QString key = QStringLiteral("x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\"")
                            .arg(number(box.x()), number(box.y()), number(box.width()), number(box.height()));
    QString& name = clips_[key];
    if (name.isEmpty()) {
      name = QStringLiteral("clip%1").arg(clips_.size());
      definitions_ += QStringLiteral("<clipPath id=\"%1\"><rect %2/></clipPath>\n").arg(name, key);
    }
    attributes += QStringLiteral(" clip-path=\"url(#%1)\"").arg(name);
  }
  if (painter()->opacity() < 1) attributes += QStringLiteral(" opacity=\"%1\"").arg(number(painter()->opacity()));
  QString inner = text;
  if (!transform.isIdentity())
    inner = QStringLiteral("<g transform=\"matrix(%1,%2,%3,%4,%5,%6)\">%7</g>")
                .arg(number(transform.m11()), number(transform.m12()), number(transform.m21()), number(transform.m22()),
                     number(transform.dx()), number(transform.dy()), text);
  body_ += attributes.isEmpty() ? inner : QStringLiteral("<g%1>%2</g>").arg(attributes, inner);
  body_ += '\n';
}

void SvgEngine::drawPath(const QPainterPath& path) {
  if (path.isEmpty()) return;
  const QString rule = path.fillRule() == Qt::OddEvenFill ? QStringLiteral(" fill-rule=\"evenodd\"") : QString();
  element(QStringLiteral("<path%1%2%3 d=\"%4\"/>").arg(fill(), stroke(), rule, pathData(path)));
}

void SvgEngine::drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) {
  QString list;
  for (int i = 0; i < count; ++i) list += QStringLiteral("%1,%2 ").arg(number(points[i].x()), number(points[i].y()));
  if (mode == PolylineMode)
    element(QStringLiteral("<polyline fill=\"none\"%1 points=\"%2\"/>").arg(stroke(), list.trimmed()));
  else
    element(QStringLiteral("<polygon%1%2 points=\"%3\"/>").arg(fill(), stroke(), list.trimmed()));
}

void SvgEngine::drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) {
  drawImage(target, pixmap.toImage(), source, Qt::AutoColor);
}

void SvgEngine::drawImage(const QRectF& target, const QImage& image, const QRectF& source, Qt::ImageConversionFlags) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.copy(source.toAlignedRect()).save(&buffer, "PNG");
  element(QStringLiteral("<image x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" preserveAspectRatio=\"none\" "
                         "xlink:href=\"data:image/png;base64,%5\"/>")
              .arg(number(target.x()), number(target.y()), number(target.width()), number(target.height()),
                   QString::fromLatin1(bytes.toBase64())));
}

void SvgEngine::drawTextItem(const QPointF& position, const QTextItem& item) {
  const QFont font = item.font();
  const double pixels = font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF() * 96 / 72;
  QString style;
  if (font.bold()) style += " font-weight=\"bold\"";
  if (font.italic()) style += " font-style=\"italic\"";
  element(QStringLiteral("<text x=\"%1\" y=\"%2\" font-family=\"%3, sans-serif\" font-size=\"%4\"%5%6 "
                         "xml:space=\"preserve\">%7</text>")
              .arg(number(position.x()), number(position.y()), font.family().toHtmlEscaped(), number(pixels), style,
                   colour("fill", painter()->pen().color()), item.text().toHtmlEscaped()));
}

}  // namespace squat::plots
