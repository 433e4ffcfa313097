// widgets/plots/Figure.h - one figure: the same object on screen and in files.
#pragma once

#include "plots/PlotLibrary.h"

#include <utility>
#include <vector>

#include "plots/Style.h"

namespace squat::plots {

class CaptionElement;

// A QCustomPlot with a name, a printed size, a caption line above the axes and a legend row that never covers data. A
// click on a name in the legend hides its curve or shows it again; names of hidden curves are dimmed, in files as well.
class Figure : public QCustomPlot {
  Q_OBJECT
 public:
  Figure(const QString& name, const Style& style, QWidget* parent = nullptr);

  const QString& name() const { return name_; }
  const Style& style() const { return style_; }
  // Printed size, default 85 mm x 60 mm (one column).
  QSizeF printedSize() const { return printedSize_; }  // [mm]
  void setPrintedSize(const QSizeF& millimetres) { printedSize_ = millimetres; }
  QSize printedUnits() const;  // [1/96 inch]

  void setCaption(const QString& left, const QString& right);
  void showLegend(bool visible);
  // With its curve go those without a name that are drawn with the same pen, and what marks them. False: the legend has
  // no such entry (from 0), and nothing happens.
  bool toggleCurve(int entry);
  void setCurveVisible(QCPAbstractPlottable& curve, bool visible);
  QCPAbstractPlottable* curveOfEntry(int entry) const;  // null: the legend has none
  int legendEntryAt(const QPoint& place) const;         // [pixels] of the figure; -1: none
  void addMark(QCPAbstractItem* mark, QCPAbstractPlottable* curve) { marks_.emplace_back(mark, curve); }
  // Second axes right of the first, of the same look, size and ranges: what moves one moves the other.
  QCPAxisRect* addAxesBeside();
  // Right of the axes, e.g. a colour scale. The figure owns it.
  void addBeside(QCPLayoutElement* element) { axesRow_->addElement(0, axesRow_->columnCount(), element); }
  // Lays out for a size [1/96 inch] before it is painted in a file: margins of one pass decide the sizes of the next.
  void settleLayout(QSize units);
  QSize sizeHint() const override { return printedUnits(); }

 private:
  void styleAxes(QCPAxisRect& axes);
  void layOut();
  void takeClicks();
  QString name_;
  Style style_;
  QSizeF printedSize_{85.0, 60.0};
  CaptionElement* caption_;
  QCPLayoutGrid* axesRow_ = nullptr;
  std::vector<std::pair<QPointer<QCPAbstractItem>, QCPAbstractPlottable*>> marks_;  // of which curve
  bool onLegend_ = false;                                                           // the mouse
};

}  // namespace squat::plots
