// widgets/plots/FigureSheet.h - several figures in one file: the panels (a), (b) ... of a journal's figure.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plots/Figure.h"
#include "plots/PrintedSize.h"

namespace squat::plots {

struct FigureSheet {
  std::string name;                             // of the file, without ending
  std::vector<std::unique_ptr<Figure>> panels;  // row by row, each at its printed size
  int columns = 1;
};

// Panels one below the other have their axes at the same place: the widest labels decide.
void alignAxes(FigureSheet& sheet);

// Extent in units of 1/96 inch: a row is as high as its highest panel.
QSize sheetUnits(const FigureSheet& sheet);

QImage toImage(const FigureSheet& sheet, double resolution);
QByteArray toSvg(const FigureSheet& sheet);
QByteArray toPdf(const FigureSheet& sheet);

// Writes FOLDER/NAME.FORMAT for each format ("png", "svg", "pdf"; none: all three), each whole or not at all, and
// returns the paths. Throws FileError.
std::vector<std::string> writeSheet(const FigureSheet& sheet, const std::string& folder,
                                    const std::vector<std::string>& formats, double resolution = printResolution);

// A sheet of one figure.
FigureSheet sheetOf(const std::string& name, std::unique_ptr<Figure> figure);

}  // namespace squat::plots
