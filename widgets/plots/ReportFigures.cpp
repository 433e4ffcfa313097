#include "plots/ReportFigures.h"

#include <QAbstractTextDocumentLayout>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFormat>
#include <algorithm>
#include <exception>

#include "analysis/SignalViews.h"
#include "plots/FigureFiles.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"

namespace squat::plots {
namespace {

constexpr int objectType = QTextFormat::UserObject, indexProperty = QTextFormat::UserProperty;

// Over the section of the run that is shown; empty where a signal does not reach as far.
signals::PowerSpectrum spectrumOf(const signals::Record& record, const results::RunResult& shown) {
  const auto window = shown.psdWindow.substr(0, shown.psdWindow.find(','));  // "hann, 183 samples, ..."
  try {
    return analysis::sectionSpectrum(record, {shown.psdFrom, shown.psdTo}, window);
  } catch (const std::exception&) {
    return {};
  }
}

std::vector<OverlaidRun> overlaysOf(const project::Report& report, const results::RunResult& shown) {
  std::vector<OverlaidRun> overlays;
  for (std::size_t i = 0; i < report.signals.size(); ++i) {
    const auto& signal = report.signals[i];
    if (static_cast<int>(i) == report.shown || !signal.overlaid) continue;
    overlays.push_back({signal.record, spectrumOf(*signal.record, shown), signal.name, overlays.size(),
                        QColor(QString::fromStdString(signal.colour))});
  }
  return overlays;
}

}  // namespace

void ReportFigures::insert(QTextCursor& cursor, std::unique_ptr<Figure> figure) {
  QTextCharFormat format;
  format.setObjectType(objectType);
  format.setProperty(indexProperty, static_cast<int>(figures_.size()));
  figures_.push_back(std::move(figure));
  cursor.document()->documentLayout()->registerHandler(objectType, this);
  cursor.insertText(QString(QChar::ObjectReplacementCharacter), format);
}

Figure& ReportFigures::figureOf(const QTextFormat& format) const {
  return *figures_.at(static_cast<std::size_t>(format.property(indexProperty).toInt()));
}

QSizeF ReportFigures::intrinsicSize(QTextDocument*, int, const QTextFormat& format) {
  return scale_ * QSizeF(figureOf(format).printedUnits());
}

void ReportFigures::drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int, const QTextFormat& format) {
  if (!page_.contains(place.center())) return;
  Figure& figure = figureOf(format);
  painter->save();
  painter->translate(place.topLeft());
  painter->scale(scale_, scale_);
  drawFigure(figure, static_cast<QCPPainter&>(*painter), figure.printedUnits());
  painter->restore();
}

std::vector<std::unique_ptr<Figure>> reportPlots(const project::Report& report, const ReportOptions& options) {
  std::vector<std::unique_ptr<Figure>> plots;
  if (report.shown < 0) return plots;
  const auto& shown = *report.signals.at(static_cast<std::size_t>(report.shown)).result;
  FigureSettings settings;
  settings.colours = options.colourMap;
  checkRequest({options.figures, {"pdf"}, settings, {}}, shown);
  Style style = lightStyle();
  style.colourMap = options.colourMap;
  const auto overlays = overlaysOf(report, shown);
  for (const auto& row : figureRegistry()) {
    const auto& names = options.figures;
    const bool asked = names.empty() || std::find(names.begin(), names.end(), row.name) != names.end();
    if (row.kind == FigureKind::plot && asked && row.applies(shown))
      plots.push_back(buildFigure(row, shown, style, settings, overlays));
  }
  return plots;
}

}  // namespace squat::plots
