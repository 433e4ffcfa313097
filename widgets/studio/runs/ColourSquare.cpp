#include "studio/runs/ColourSquare.h"

#include <QIcon>
#include <QPainter>
#include <QPixmap>

namespace squat::studio {
namespace {

QIcon squareIcon(const QColor& colour, const QColor& frame, const QSize& size) {
  constexpr int fineness = 2;  // for screens of double resolution
  constexpr int border = 2;    // [pixels]
  QPixmap picture(size * fineness);
  picture.setDevicePixelRatio(fineness);
  picture.fill(frame);
  QPainter(&picture).fillRect(QRect(QPoint(0, 0), size).adjusted(border, border, -border, -border), colour);
  QIcon icon;
  for (const auto mode : {QIcon::Normal, QIcon::Selected, QIcon::Disabled}) icon.addPixmap(picture, mode);
  return icon;
}

}  // namespace

void ColourSquare::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const auto colour = index.data(Qt::DecorationRole).value<QColor>();
  if (colour.isValid())
    option->icon = squareIcon(colour, option->palette.color(QPalette::Base), option->decorationSize);
}

}  // namespace squat::studio
