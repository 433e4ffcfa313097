// widgets/studio/preview/CurvePlot.h - a curve that changes all the time, the one before it, and one to compare with.
#pragma once

#include <vector>

#include "plots/Figure.h"

namespace squat::studio {

class CurvePlot : public plots::Figure {
  Q_OBJECT
 public:
  CurvePlot(const QString& name, const QString& across, const QString& up, const plots::Style& style,
            QWidget* parent = nullptr);

  void setRange(double from, double to);  // of x
  void setBand(double from, double to);   // behind the curves
  // In grey, behind all others; without a label no legend names the curves.
  void setReference(const std::vector<double>& x, const std::vector<double>& y, const QString& label);
  // `isWhole`: not still growing; y is fitted anew and the curve before it goes.
  void setCurve(const std::vector<double>& x, const std::vector<double>& y, bool isWhole);
  void setStale(bool stale);  // pale: of another case
  std::size_t pointCount() const;
  std::size_t referenceCount() const;

 private:
  void fit(bool mayShrink);

  QCPGraph *reference_ = nullptr, *before_ = nullptr, *curve_ = nullptr;
  QCPItemRect* band_ = nullptr;
  bool isWhole_ = false, isStale_ = false, isFitted_ = false;
};

}  // namespace squat::studio
