// widgets/plots/FigureFiles.h - a figure as a file.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <string>

#include "plots/Figure.h"

namespace squat::plots {

constexpr double printResolution = 300;  // [dpi] of PNG

// The figure at its printed size, or at `units` (1/96 inch) where given: "exactly as seen".
QImage toImage(Figure& figure, double resolution = printResolution, QSize units = {});
QByteArray toSvg(Figure& figure, QSize units = {});  // text stays text
QByteArray toPdf(Figure& figure, QSize units = {});  // text stays text, fonts embedded

// The figure at `units`, at the painter's place.
void drawFigure(Figure& figure, QCPPainter& painter, QSize units);

// Writes `path` whole or not at all; the format ("png", "svg" or "pdf") by its name. Throws FileError.
void writeFigure(Figure& figure, const std::string& format, const std::string& path, QSize units = {});

// Writes beside, then renames. Throws FileError.
void writeWhole(const QByteArray& bytes, const std::string& path);

}  // namespace squat::plots
