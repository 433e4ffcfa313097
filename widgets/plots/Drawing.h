// widgets/plots/Drawing.h - anything drawn with a painter, as bytes of a picture.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <functional>
#include <string>

#include "plots/PlotLibrary.h"

namespace squat::plots {

// Draws in units of 1/96 inch from the upper left corner.
using Drawing = std::function<void(QCPPainter&)>;

// Throws CaseError above 200 million pixels.
QImage drawnImage(const Drawing& drawing, QSize units, const QColor& background, double resolution);
QByteArray drawnSvg(const Drawing& drawing, QSize units, const QString& title);
QByteArray drawnPdf(const Drawing& drawing, QSize units, const QString& title);
// Program, version and commit: each of the three formats carries it.
QString drawnBy();
QByteArray pngBytes(const QImage& image);

}  // namespace squat::plots
