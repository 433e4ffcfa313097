#include "plots/FigureFiles.h"

#include <QSaveFile>

#include "core/Errors.h"
#include "plots/Drawing.h"

namespace squat::plots {
namespace {

QSize unitsOf(const Figure& figure, QSize units) { return units.isEmpty() ? figure.printedUnits() : units; }

}  // namespace

void drawFigure(Figure& figure, QCPPainter& painter, QSize units) {
  figure.settleLayout(units);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  painter.setMode(QCPPainter::pmNonCosmetic);
  figure.toPainter(&painter, units.width(), units.height());
}

QImage toImage(Figure& figure, double resolution, QSize units) {
  const QSize size = unitsOf(figure, units);
  return drawnImage([&](QCPPainter& painter) { drawFigure(figure, painter, size); }, size, figure.style().background,
                    resolution);
}

QByteArray toSvg(Figure& figure, QSize units) {
  const QSize size = unitsOf(figure, units);
  return drawnSvg([&](QCPPainter& painter) { drawFigure(figure, painter, size); }, size, figure.name());
}

QByteArray toPdf(Figure& figure, QSize units) {
  const QSize size = unitsOf(figure, units);
  return drawnPdf([&](QCPPainter& painter) { drawFigure(figure, painter, size); }, size, figure.name());
}

void writeWhole(const QByteArray& bytes, const std::string& path) {
  QSaveFile file(QString::fromStdString(path));
  const bool opened = file.open(QIODevice::WriteOnly);
  if (!opened || file.write(bytes) != bytes.size() || !file.commit())
    throw FileError(path, "", "cannot be written: " + file.errorString().toStdString(),
                    "Check that the folder exists and is writable, and that the disk is not full");
}

void writeFigure(Figure& figure, const std::string& format, const std::string& path, QSize units, double resolution) {
  if (format == "svg") return writeWhole(toSvg(figure, units), path);
  if (format == "pdf") return writeWhole(toPdf(figure, units), path);
  writeWhole(pngBytes(toImage(figure, resolution, units)), path);
}

}  // namespace squat::plots
