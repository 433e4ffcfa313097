// widgets/plots/FigureFiles.h - a figure as a file.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <string>

#include "plots/Figure.h"
#include "plots/PrintedSize.h"

namespace squat::plots {

// The figure at its printed size, or at `units` (1/96 inch) where given. Throws CaseError for a picture of more than
// 200 million pixels.
QImage toImage(Figure& figure, double resolution = printResolution, QSize units = {});
QByteArray toSvg(Figure& figure, QSize units = {});  // text stays text
QByteArray toPdf(Figure& figure, QSize units = {});  // text stays text, fonts embedded

// The figure at `units`, at the painter's place.
void drawFigure(Figure& figure, QCPPainter& painter, QSize units);

// Writes `path` whole or not at all; the format ("png", "svg" or "pdf") by its name. Throws FileError.
void writeFigure(Figure& figure, const std::string& format, const std::string& path, QSize units = {},
                 double resolution = printResolution);

// Writes beside, then renames. Throws FileError.
void writeWhole(const QByteArray& bytes, const std::string& path);

}  // namespace squat::plots
