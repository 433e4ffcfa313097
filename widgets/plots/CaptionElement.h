// widgets/plots/CaptionElement.h - one small line above the axes: the case on the left, its hash on the right.
#pragma once

#include "plots/PlotLibrary.h"

#include "plots/Style.h"

namespace squat::plots {

// The left text is shortened with an ellipsis where both do not fit.
class CaptionElement : public QCPLayoutElement {
  Q_OBJECT
 public:
  CaptionElement(QCustomPlot* plot, const Style& style);
  void setTexts(const QString& left, const QString& right);
  void setStyle(const Style& style) { style_ = style; }
  QSize minimumOuterSizeHint() const override;
  QSize maximumOuterSizeHint() const override;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override { painter->setAntialiasing(true); }
  void draw(QCPPainter* painter) override;

 private:
  int height() const;
  Style style_;
  QString left_, right_;
};

}  // namespace squat::plots
