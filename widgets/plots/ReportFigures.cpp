#include "plots/ReportFigures.h"

#include <QAbstractTextDocumentLayout>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFormat>
#include <algorithm>
#include <exception>
#include <filesystem>

#include "analysis/SignalViews.h"
#include "plots/DetectionFigures.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureFiles.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"
#include "readers/SignalFile.h"

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

// Those that lie over number `shown` of the signals, whose result `run` is.
std::vector<OverlaidRun> overlaysOf(const project::Report& report, int shown, const results::RunResult& run) {
  std::vector<OverlaidRun> overlays;
  for (std::size_t i = 0; i < report.signals.size(); ++i) {
    const auto& signal = report.signals[i];
    if (static_cast<int>(i) == shown || !signal.overlaid) continue;
    overlays.push_back({signal.record, spectrumOf(*signal.record, run), signal.name, overlays.size(),
                        QColor(QString::fromStdString(signal.colour))});
  }
  return overlays;
}

constexpr const char* openingFigure = "aba_position";
constexpr QSizeF pictureSize(170, 80);  // [mm]: as wide as the text

bool isAsked(const ReportOptions& options, const std::string& name) {
  const auto& names = options.figures;
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

Style styleOfPages(const ReportOptions& options) {
  Style style = lightStyle();
  style.colourMap = options.colourMap;
  return style;
}

// A signal by itself as a run, without all that only a computation knows.
results::RunResult asRun(const project::ReportSignal& signal) {
  results::RunResult run;
  static_cast<signals::Record&>(run) = *signal.record;
  run.title = signal.name;
  run.complete = true;
  return run;
}

// Of a report that shows no run; null where none of its signals has an acceleration with positions.
std::unique_ptr<Figure> openingOfSignals(const project::Report& report, const ReportOptions& options) {
  const auto& row = figureRow(openingFigure);
  for (std::size_t i = 0; i < report.signals.size() && isAsked(options, row.name); ++i) {
    const auto run = asRun(report.signals[i]);
    if (run.position.empty() || !row.applies(run)) continue;
    return buildFigure(row, run, styleOfPages(options), {}, overlaysOf(report, static_cast<int>(i), run));
  }
  return nullptr;
}

detection::CombinedEvent withoutSignal(const project::ListedEvent& listed) {
  detection::CombinedEvent combined{{}, {0}, 0};
  auto& event = combined.event;
  event.kind = detection::Kind::squat;
  event.channel = listed.channel, event.unit = "m/s2";
  event.position = listed.position, event.time = listed.time;
  event.features.speed = listed.speed;
  event.judgement.severity = detection::severityFromText(listed.severity);
  event.judgement.length = listed.length, event.judgement.depth = listed.depth;
  event.judgement.offset = listed.impact;
  return combined;
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

ReportPlots reportPlots(const project::Report& report, const ReportOptions& options) {
  ReportPlots plots;
  if (report.shown < 0) {
    plots.first = openingOfSignals(report, options);
    plots.opensWithEvents = !plots.first && !report.events.events.empty();
    if (plots.opensWithEvents) plots.first = eventMap(report.events, styleOfPages(options));
  } else {
    const auto& shown = *report.signals.at(static_cast<std::size_t>(report.shown)).result;
    FigureSettings settings;
    settings.colours = options.colourMap;
    checkRequest({options.figures, {"pdf"}, settings, {}}, shown);
    const auto overlays = overlaysOf(report, report.shown, shown);
    for (const auto& row : figureRegistry()) {
      if (row.kind != FigureKind::plot || !isAsked(options, row.name) || !row.applies(shown)) continue;
      auto plot = buildFigure(row, shown, styleOfPages(options), settings, overlays);
      // The registry begins with it.
      (plots.first ? plots.further.emplace_back() : plots.first) = std::move(plot);
    }
  }
  if (plots.first) plots.first->setPrintedSize(pictureSize);
  return plots;
}

std::vector<std::unique_ptr<Figure>> squatPlots(const project::Report& report, std::size_t event,
                                                const ReportOptions& options) {
  auto combined = withoutSignal(report.events.events.at(event));
  const auto file = std::filesystem::path(report.eventFolder) / detection::passageName(combined, event);
  if (report.eventFolder.empty() || !std::filesystem::exists(file)) return {};
  combined.event.passage = readers::passageWithPositions(readers::readSignals(file.string()).front()).series;
  auto sheet = eventFigure(combined, styleOfPages(options));
  for (auto& panel : sheet.panels) panel->setPrintedSize(pictureSize);
  return std::move(sheet.panels);
}

}  // namespace squat::plots
