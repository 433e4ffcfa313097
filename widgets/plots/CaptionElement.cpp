#include "plots/CaptionElement.h"

namespace squat::plots {

CaptionElement::CaptionElement(QCustomPlot* plot, const Style& style) : QCPLayoutElement(plot), style_(style) {
  setMargins(QMargins(0, 0, 0, 0));
  setAutoMargins(QCP::msNone);
}

void CaptionElement::setTexts(const QString& left, const QString& right) {
  left_ = left;
  right_ = right;
}

int CaptionElement::height() const { return QFontMetrics(style_.captionFont()).height() + 2; }

QSize CaptionElement::minimumOuterSizeHint() const { return {10, height()}; }

QSize CaptionElement::maximumOuterSizeHint() const { return {QWIDGETSIZE_MAX, height()}; }

void CaptionElement::draw(QCPPainter* painter) {
  const QFontMetricsF metrics(style_.captionFont());
  painter->setFont(style_.captionFont());
  painter->setPen(style_.muted);
  const QRectF box = QRectF(rect()).adjusted(3, 0, -3, 0);
  const double room = box.width() - metrics.horizontalAdvance(right_) - 8;
  painter->drawText(box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                    metrics.elidedText(left_, Qt::ElideRight, room));
  painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, right_);
}

}  // namespace squat::plots
