// widgets/plots/AxisTicker.h - numbers at axes with a true minus sign.
#pragma once

#include "plots/PlotLibrary.h"

namespace squat::plots {

class AxisTicker : public QCPAxisTicker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTicker::getTickLabel(tick, locale, format, precision).replace('-', QChar(0x2212));
  }
};

}  // namespace squat::plots
