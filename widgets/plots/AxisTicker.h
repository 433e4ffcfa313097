// widgets/plots/AxisTicker.h - numbers at axes with a true minus sign, and with as many digits as tell them apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "plots/PlotLibrary.h"

namespace squat::plots {

class AxisTicker : public QCPAxisTicker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTicker::getTickLabel(tick, locale, format, precision).replace('-', QChar(0x2212));
  }

  // A short stretch far from zero: kilometre 12.3 of the line, in millimetres.
  QVector<QString> createLabelVector(const QVector<double>& ticks, const QLocale& locale, QChar format,
                                     int precision) override {
    if (ticks.size() > 1 && format != 'f') {
      const double step = (ticks.last() - ticks.first()) / (ticks.size() - 1);
      const double largest = std::max(std::abs(ticks.first()), std::abs(ticks.last()));
      if (step > 0 && std::log10(largest) - lastDigit(step) >= precision)
        format = 'f', precision = std::max(0, -lastDigit(step));
    }
    return QCPAxisTicker::createLabelVector(ticks, locale, format, precision);
  }

 private:
  // Power of ten of the last digit of a step: steps are 1, 2, 2.5 or 5 times one.
  static int lastDigit(double step) {
    const int first = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    const double leading = step / std::pow(10.0, first);
    return std::abs(leading - std::round(leading)) < 1e-6 ? first : first - 1;
  }
};

}  // namespace squat::plots
