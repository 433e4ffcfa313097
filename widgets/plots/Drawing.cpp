#include "plots/Drawing.h"

#include <QBuffer>
#include <QPdfWriter>

#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "plots/Style.h"
#include "plots/SvgDevice.h"

namespace squat::plots {

namespace {

void requirePixels(const QSizeF& size, double resolution) {
  constexpr double maximum = 2e8;  // 800 MB
  if (size.width() * size.height() <= maximum) return;
  throw CaseError({{"resolution", std::to_string(qRound(resolution)) + " dpi", "at most 200 million pixels a picture",
                    "Choose a smaller figure or a lower resolution"}});
}

}  // namespace

QString drawnBy() { return "Squat Studio " + QString::fromStdString(programVersionText()); }

QImage drawnImage(const Drawing& drawing, QSize units, const QColor& background, double resolution) {
  const double scale = resolution / 96.0;
  requirePixels(QSizeF(units) * scale, resolution);
  QImage image(qRound(units.width() * scale), qRound(units.height() * scale), QImage::Format_RGB32);
  image.fill(background);
  image.setText("Software", drawnBy());
  image.setDotsPerMeterX(qRound(resolution / 0.0254));
  image.setDotsPerMeterY(qRound(resolution / 0.0254));
  QCPPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  drawing(painter);
  painter.end();
  return image;
}

QByteArray drawnSvg(const Drawing& drawing, QSize units, const QString& title) {
  SvgDevice device(units, title);
  QCPPainter painter(&device);
  drawing(painter);
  painter.end();
  return device.document();
}

QByteArray drawnPdf(const Drawing& drawing, QSize units, const QString& title) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  constexpr int resolution = 1200;
  writer.setResolution(resolution);
  writer.setPageSize(
      QPageSize(QSizeF(units) / unitsPerMillimetre, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF());
  writer.setTitle(title);
  writer.setCreator(drawnBy());
  QCPPainter painter(&writer);
  painter.scale(resolution / 96.0, resolution / 96.0);
  drawing(painter);
  painter.end();
  return bytes;
}

QByteArray pngBytes(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

}  // namespace squat::plots
