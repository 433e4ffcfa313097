#include "plots/FigureFiles.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSaveFile>

#include "core/Errors.h"
#include "plots/SvgDevice.h"

namespace squat::plots {
namespace {

QSize unitsOf(const Figure& figure, QSize units) { return units.isEmpty() ? figure.printedUnits() : units; }

void drawVectors(Figure& figure, QCPPainter& painter, QSize units) {
  figure.settleLayout(units);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  painter.setMode(QCPPainter::pmNonCosmetic);
  figure.toPainter(&painter, units.width(), units.height());
}

}  // namespace

QImage toImage(Figure& figure, double resolution, QSize units) {
  const QSize size = unitsOf(figure, units);
  const double scale = resolution / 96.0;
  QImage image(qRound(size.width() * scale), qRound(size.height() * scale), QImage::Format_RGB32);
  image.fill(figure.style().background);
  image.setDotsPerMeterX(qRound(resolution / 0.0254));
  image.setDotsPerMeterY(qRound(resolution / 0.0254));
  QCPPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  drawVectors(figure, painter, size);
  painter.end();
  return image;
}

QByteArray toSvg(Figure& figure, QSize units) {
  const QSize size = unitsOf(figure, units);
  SvgDevice device(size, figure.name());
  QCPPainter painter(&device);
  drawVectors(figure, painter, size);
  painter.end();
  return device.document();
}

QByteArray toPdf(Figure& figure, QSize units) {
  const QSize size = unitsOf(figure, units);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  constexpr int resolution = 1200;
  writer.setResolution(resolution);
  writer.setPageSize(
      QPageSize(QSizeF(size) / unitsPerMillimetre, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF());
  writer.setTitle(figure.name());
  writer.setCreator("Squat Studio");
  QCPPainter painter(&writer);
  painter.scale(resolution / 96.0, resolution / 96.0);
  drawVectors(figure, painter, size);
  painter.end();
  return bytes;
}

void writeWhole(const QByteArray& bytes, const std::string& path) {
  QSaveFile file(QString::fromStdString(path));
  const bool opened = file.open(QIODevice::WriteOnly);
  if (!opened || file.write(bytes) != bytes.size() || !file.commit())
    throw FileError(path, "", "cannot be written: " + file.errorString().toStdString(),
                    "check that the folder exists, that it may be written and that the disk is not full");
}

void writeFigure(Figure& figure, const std::string& format, const std::string& path, QSize units) {
  if (format == "svg") return writeWhole(toSvg(figure, units), path);
  if (format == "pdf") return writeWhole(toPdf(figure, units), path);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  toImage(figure, printResolution, units).save(&buffer, "PNG");
  writeWhole(bytes, path);
}

}  // namespace squat::plots
