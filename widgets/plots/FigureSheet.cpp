#include "plots/FigureSheet.h"

#include <algorithm>
#include <filesystem>

#include "plots/Drawing.h"
#include "plots/FigureFiles.h"

namespace squat::plots {
namespace {

// Where each panel stands, and the extent of all.
struct Placing {
  std::vector<QPoint> corners;
  QSize whole;
};

Placing placingOf(const FigureSheet& sheet) {
  Placing placing;
  int x = 0, y = 0, row = 0;
  for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
    if (i % static_cast<std::size_t>(std::max(1, sheet.columns)) == 0) x = 0, y += row, row = 0;
    const QSize size = sheet.panels[i]->printedUnits();
    placing.corners.emplace_back(x, y);
    x += size.width();
    row = std::max(row, size.height());
    placing.whole = placing.whole.expandedTo(QSize(x, y + row));
  }
  return placing;
}

Drawing drawingOf(const FigureSheet& sheet) {
  return [&sheet](QCPPainter& painter) {
    const Placing placing = placingOf(sheet);
    for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
      painter.save();
      painter.translate(placing.corners[i]);
      drawFigure(*sheet.panels[i], painter, sheet.panels[i]->printedUnits());
      painter.restore();
    }
  };
}

}  // namespace

void alignAxes(FigureSheet& sheet) {
  int left = 0;
  for (const auto& panel : sheet.panels) {
    panel->settleLayout(panel->printedUnits());
    left = std::max(left, panel->axisRect()->margins().left());
  }
  for (const auto& panel : sheet.panels) {
    QMargins minimum = panel->axisRect()->minimumMargins();
    minimum.setLeft(left);
    panel->axisRect()->setMinimumMargins(minimum);
  }
}

QSize sheetUnits(const FigureSheet& sheet) { return placingOf(sheet).whole; }

QImage toImage(const FigureSheet& sheet, double resolution) {
  const QColor background = sheet.panels.empty() ? QColor(Qt::white) : sheet.panels.front()->style().background;
  return drawnImage(drawingOf(sheet), sheetUnits(sheet), background, resolution);
}

QByteArray toSvg(const FigureSheet& sheet) {
  return drawnSvg(drawingOf(sheet), sheetUnits(sheet), QString::fromStdString(sheet.name));
}

QByteArray toPdf(const FigureSheet& sheet) {
  return drawnPdf(drawingOf(sheet), sheetUnits(sheet), QString::fromStdString(sheet.name));
}

std::vector<std::string> writeSheet(const FigureSheet& sheet, const std::string& folder,
                                    const std::vector<std::string>& formats, double resolution) {
  std::vector<std::string> written;
  for (const std::string& format : formats.empty() ? std::vector<std::string>{"png", "svg", "pdf"} : formats) {
    const std::string path = (std::filesystem::path(folder) / (sheet.name + "." + format)).string();
    writeWhole(format == "svg"   ? toSvg(sheet)
               : format == "pdf" ? toPdf(sheet)
                                 : pngBytes(toImage(sheet, resolution)),
               path);
    written.push_back(path);
  }
  return written;
}

FigureSheet sheetOf(const std::string& name, std::unique_ptr<Figure> figure) {
  FigureSheet sheet{name, {}, 1};
  sheet.panels.push_back(std::move(figure));
  return sheet;
}

}  // namespace squat::plots
