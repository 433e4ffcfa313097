#include "plots/DetectionFigures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/Maps.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "plots/UnitText.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

using detection::CombinedEvent;
using detection::Kind;

constexpr std::array kindMarks{
    std::pair{Kind::squat, QCPScatterStyle::ssTriangle}, std::pair{Kind::joint, QCPScatterStyle::ssSquare},
    std::pair{Kind::weld, QCPScatterStyle::ssDiamond},   std::pair{Kind::corrugation, QCPScatterStyle::ssCross},
    std::pair{Kind::flat, QCPScatterStyle::ssCircle},    std::pair{Kind::other, QCPScatterStyle::ssPlus}};

// As many points as a figure has pixels: of each group the largest.
Curve envelopeOf(const std::vector<detection::Piece>& pieces, double factor) {
  constexpr std::size_t pixels = 2000;
  const std::size_t group = std::max<std::size_t>(1, pieces.size() / pixels);
  Curve curve;
  for (std::size_t i = 0; i < pieces.size(); i += group) {
    double largest = 0;
    for (std::size_t k = i; k < std::min(pieces.size(), i + group); ++k) largest = std::max(largest, pieces[k].peak);
    curve.x.push_back(factor * pieces[i].position);
    curve.y.push_back(largest);
  }
  return curve;
}

struct EventMark {
  std::string kind;
  double position = 0, peak = 0;  // [m], [m/s2]
};

// Of every kind that there is; `factor` from metres to the unit of the axis.
void addEventMarks(Figure& figure, const std::vector<EventMark>& events, double factor) {
  for (std::size_t k = 0; k < kindMarks.size(); ++k) {
    Curve marks;
    const std::string kind = detection::toText(kindMarks[k].first);
    marks.label = QString::fromStdString(kind);
    marks.colour = k;
    for (const auto& event : events)
      if (event.kind == kind) marks.x.push_back(factor * event.position), marks.y.push_back(event.peak);
    if (marks.x.empty()) continue;
    QCPGraph* graph = addCurve(figure, marks);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(QCPScatterStyle(kindMarks[k].second, figure.style().curve(k), 5));
  }
}

constexpr double shortTrack = 2000;  // [m] that is shown in metres, not in kilometres

std::unique_ptr<Figure> overviewFigure(const detection::DetectionReport& report, std::size_t channel, bool isLast,
                                       const Style& style) {
  const auto& record = report.records.front();
  const auto& own = record.channels[channel];
  auto figure = std::make_unique<Figure>(QString::fromStdString("overview_" + own.name), style);
  figure->setPrintedSize({175, 55});
  const auto& pieces = own.pieces;
  const bool isShort = pieces.empty() || std::abs(pieces.back().position - pieces.front().position) < shortTrack;
  const double factor = isShort ? 1.0 : 1e-3;  // metres, or kilometres
  if (isLast) figure->xAxis->setLabel(isShort ? "Chainage [m]" : "Chainage [km]");
  figure->yAxis->setLabel(QStringLiteral("Largest |%1| [%2]")
                              .arg(QString::fromStdString(own.name), unitText(record.layout.channels[channel].unit)));
  const auto envelope = envelopeOf(pieces, factor);
  if (!envelope.x.empty()) {
    const auto [low, high] = std::minmax_element(envelope.x.begin(), envelope.x.end());
    figure->xAxis->setRange(*low, std::max(*high, *low + 1e-6));
  }
  addCurve(*figure, envelope)->setPen(QPen(style.axis, 0.6));
  std::vector<EventMark> marks;
  for (const auto& combined : report.events)
    if (combined.event.channel == own.name)
      marks.push_back({detection::toText(combined.event.kind), combined.event.position, combined.event.peak});
  addEventMarks(*figure, marks, factor);
  fitValues(*figure);
  keepZeroInSight(*figure);
  return figure;
}

// The event's signal with its scalogram, zero at its cause.
results::AnalysedRecord recordOf(const CombinedEvent& combined) {
  const auto& event = combined.event;
  results::AnalysedRecord record;
  char title[96];
  std::snprintf(title, sizeof title, "%s at %.2f m, %s", detection::toText(event.kind).c_str(), event.position,
                event.channel.c_str());
  record.title = title;
  record.complete = true;
  record.speed = event.features.speed;
  const auto& series = event.passage;
  const double zero = event.time - event.judgement.offset / std::max(event.features.speed, 1.0);
  results::Channel aba{signals::names::axleBoxFiltered, series.unit, "", series.values};
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    record.time.push_back(series.timeAt(i));
    record.position.push_back((series.timeAt(i) - zero) * event.features.speed);
  }
  record.psdFrom = std::max(-0.2, record.position.front());
  record.psdTo = std::min(0.6, record.position.back());
  std::vector<std::string> notes;
  const auto map = analysis::scalogramMap(series, {}, notes);
  record.scalogramFrequency = map.frequency;
  record.scalogramTime = map.time;
  record.scalogramPower = map.power;
  record.coneOfInfluence = map.coneOfInfluence;
  for (const double time : map.time) record.scalogramPosition.push_back((time - zero) * event.features.speed);
  record.signals.push_back(std::move(aba));
  return record;
}

std::unique_ptr<Figure> signalFigure(const results::AnalysedRecord& record, const CombinedEvent& combined,
                                     const Style& style) {
  auto figure = std::make_unique<Figure>("event", style);
  figure->xAxis->setLabel("Position relative to the event [mm]");
  figure->yAxis->setLabel(QStringLiteral("Acceleration [%1]").arg(unitText(combined.event.unit)));
  figure->xAxis->setRange(1e3 * record.psdFrom, 1e3 * record.psdTo);
  addCurve(*figure, {scaled(record.position, 1e3), record.signals.front().values, QString(), 0, 0.9});
  fitValues(*figure);
  const auto& judged = combined.event.judgement;
  const bool isSquat = combined.event.kind == Kind::squat;
  figure->setCaption(QString::fromStdString(record.title),
                     isSquat ? QStringLiteral("%1: %2 mm × %3 mm")
                                   .arg(QString::fromStdString(detection::toText(judged.severity)))
                                   .arg(1e3 * judged.length, 0, 'f', 0)
                                   .arg(1e3 * judged.depth, 0, 'f', 2)
                             : QString::fromStdString(combined.event.reason));
  return figure;
}

// Enough to be analysed.
bool hasSignal(const CombinedEvent& combined) { return combined.event.passage.values.size() > 32; }

std::vector<const CombinedEvent*> mostImportant(const detection::DetectionReport& report, std::size_t maximum) {
  std::vector<const CombinedEvent*> events;
  for (const auto& event : report.events)
    if (hasSignal(event)) events.push_back(&event);
  const auto rank = [](const CombinedEvent& combined) {
    return std::pair{combined.event.kind == Kind::squat, combined.event.score};
  };
  std::stable_sort(events.begin(), events.end(),
                   [&](const CombinedEvent* a, const CombinedEvent* b) { return rank(*a) > rank(*b); });
  if (events.size() > maximum) events.resize(maximum);
  return events;
}

}  // namespace

std::vector<FigureSheet> detectionFigures(const detection::DetectionReport& report, const Style& style,
                                          std::size_t maximum) {
  std::vector<FigureSheet> sheets;
  FigureSheet overview{"overview", {}, 1};
  const auto channels = report.records.empty() ? 0 : report.records.front().channels.size();
  for (std::size_t c = 0; c < channels; ++c)
    overview.panels.push_back(overviewFigure(report, c, c + 1 == channels, style));
  if (channels > 0) sheets.push_back(std::move(overview));
  std::size_t count = 0;
  for (const auto* combined : mostImportant(report, maximum)) {
    char name[32];
    std::snprintf(name, sizeof name, "event_%03zu", ++count);
    sheets.push_back(eventFigure(*combined, style));
    sheets.back().name = name;
  }
  return sheets;
}

std::unique_ptr<Figure> eventMap(const project::EventList& list, const Style& style) {
  auto figure = std::make_unique<Figure>("events", style);
  std::vector<EventMark> marks;
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const auto& event : list.events) {
    marks.push_back({event.kind, event.position, event.peak});
    first = std::min(first, event.position), last = std::max(last, event.position);
  }
  if (marks.empty()) first = last = 0, addNotice(*figure, "no events");
  const bool isShort = last - first < shortTrack;
  const double factor = isShort ? 1.0 : 1e-3;
  const double room = std::max(1.0, 0.02 * (last - first));  // [m] beside the outermost marks
  figure->xAxis->setLabel(isShort ? "Place along the track [m]" : "Place along the track [km]");
  figure->xAxis->setRange(factor * (first - room), factor * (last + room));
  figure->yAxis->setLabel("Largest acceleration [m/s²]");
  addEventMarks(*figure, marks, factor);
  fitValues(*figure);
  keepZeroInSight(*figure);
  return figure;
}

FigureSheet eventFigure(const CombinedEvent& event, const Style& style) {
  FigureSheet sheet{"event", {}, 2};
  if (!hasSignal(event)) return sheet;
  const auto record = recordOf(event);
  sheet.panels.push_back(signalFigure(record, event, style));
  auto map = scalogramFigure(record, style);
  map->xAxis->setLabel("Position relative to the event [mm]");
  sheet.panels.push_back(std::move(map));
  return sheet;
}

}  // namespace squat::plots
