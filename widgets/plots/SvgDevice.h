// widgets/plots/SvgDevice.h - a paint device that writes SVG with text as text and with clipping.
#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSize>
#include <memory>

namespace squat::plots {

class SvgEngine;

// Units are 1/96 inch. Qt's own generator (until 6.6) ignores clip rectangles, so curves would run out of zoomed axes.
// Limits: plain colours only (no gradients, no pattern brushes), rectangular clips, pictures embedded as PNG.
class SvgDevice : public QPaintDevice {
 public:
  SvgDevice(QSize units, const QString& title);
  ~SvgDevice() override;

  QPaintEngine* paintEngine() const override;
  QByteArray document() const;  // after the painter has ended

 protected:
  int metric(PaintDeviceMetric metric) const override;

 private:
  QSize units_;
  QString title_;
  std::unique_ptr<SvgEngine> engine_;
};

}  // namespace squat::plots
