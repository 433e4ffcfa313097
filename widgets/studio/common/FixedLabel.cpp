#include "studio/common/FixedLabel.h"

#include <QEvent>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>

#include "studio/common/Theme.h"

namespace squat::studio {

FixedLabel::FixedLabel(int lines, QWidget* parent) : QLabel(parent), lines_(lines) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setLines();
}

void FixedLabel::setLines() { setFixedHeight(lines_ * fontMetrics().lineSpacing() + 2); }

void FixedLabel::say(const QString& text) {
  setStyleSheet({});
  setText(text);
}

void FixedLabel::warn(const QString& text) {
  setStyleSheet(QStringLiteral("color: %1;").arg(wrongColour));
  setText(text);
}

QSize FixedLabel::sizeHint() const { return {fontMetrics().horizontalAdvance(text()), height()}; }

QSize FixedLabel::minimumSizeHint() const { return {0, height()}; }

void FixedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) setLines();
}

void FixedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  QTextLayout layout(text(), font());
  layout.beginLayout();
  bool isWhole = true;
  for (int i = 0; i < lines_; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(width());
    const bool isLast = i + 1 == lines_ && line.textStart() + line.textLength() < text().size();
    const bool isTooWide = line.naturalTextWidth() > width();
    isWhole = isWhole && !isLast && !isTooWide;
    QString seen = text().mid(line.textStart(), isLast || isTooWide ? -1 : line.textLength());
    if (isLast || isTooWide) seen = fontMetrics().elidedText(seen.simplified(), Qt::ElideRight, width());
    const QRect place(0, i * fontMetrics().lineSpacing() + 1, width(), fontMetrics().lineSpacing());
    style()->drawItemText(&painter, place, static_cast<int>(alignment() | Qt::TextSingleLine), palette(), isEnabled(),
                          seen, foregroundRole());
  }
  layout.endLayout();
  if (const QString tip = isWhole ? QString() : text(); tip != toolTip()) setToolTip(tip);
}

}  // namespace squat::studio
