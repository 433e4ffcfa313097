#include "plots/SvgDevice.h"

#include "plots/Drawing.h"
#include "plots/SvgEngine.h"

namespace squat::plots {

SvgDevice::SvgDevice(QSize units, const QString& title)
    : units_(units), title_(title), engine_(std::make_unique<SvgEngine>()) {}

SvgDevice::~SvgDevice() = default;

QPaintEngine* SvgDevice::paintEngine() const { return engine_.get(); }

int SvgDevice::metric(PaintDeviceMetric metric) const {
  switch (metric) {
    case PdmWidth:
      return units_.width();
    case PdmHeight:
      return units_.height();
    case PdmWidthMM:
      return qRound(units_.width() * 25.4 / 96);
    case PdmHeightMM:
      return qRound(units_.height() * 25.4 / 96);
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
      return 96;
    case PdmDevicePixelRatio:
      return 1;
    case PdmDevicePixelRatioScaled:
      return qRound(devicePixelRatioFScale());
    case PdmDepth:
      return 32;
    case PdmNumColors:
      return 0;
    default:
      return QPaintDevice::metric(metric);
  }
}

QByteArray SvgDevice::document() const {
  const QString head =
      QStringLiteral(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
          "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"%1mm\" height=\"%2mm\" viewBox=\"0 0 %3 %4\">\n")
          .arg(QString::number(units_.width() * 25.4 / 96, 'g', 7),
               QString::number(units_.height() * 25.4 / 96, 'g', 7), QString::number(units_.width()),
               QString::number(units_.height()));
  return (head + "<title>" + title_.toHtmlEscaped() + "</title>\n<desc>" + drawnBy().toHtmlEscaped() +
          "</desc>\n<defs>\n" + engine_->definitions() + "</defs>\n" + engine_->body() + "</svg>\n")
      .toUtf8();
}

}  // namespace squat::plots
