// widgets/studio/runs/ColourSquare.h - the colour of a run's curve in a table, to be seen on a selected row as well.
#pragma once

#include <QStyledItemDelegate>

namespace squat::studio {

// Draws a colour that the model gives as decoration as a square with a frame in the colour of the ground: a selected
// row would tint it, and may have the colour itself.
class ColourSquare : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace squat::studio
