#include "plots/PaperFigures.h"

#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

// Ranges as the text states them: the peaks of section 3.2 lie up to 5 ms behind the excitation; section 4.2 speaks of
// -30 to beyond 100 mm; spectra end at the filter's 2 kHz, the responses of figure 5 at 2.5 kHz.
constexpr double timeFrom = -2, timeTo = 8;              // [ms]
constexpr double positionFrom = -100, positionTo = 280;  // [mm]
constexpr double spectrumTo = 2000;                      // [Hz]

void addNote(Figure& figure, const QString& text, double share) {
  auto* label = new QCPItemText(&figure);
  label->position->setType(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(0.98, share);
  label->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
  label->setTextAlignment(Qt::AlignRight);
  label->setFont(figure.style().captionFont());
  label->setColor(figure.style().muted);
  label->setPadding(QMargins(2, 1, 2, 1));
  label->setText(text);
  label->setSelectable(false);
}

QString runName(const results::RunResult& run) { return QString::fromStdString(run.stem + "  " + run.caseHash); }

// A panel that the paper fills with measurements: its axes, what belongs there, what the text says of it, and no curve.
std::unique_ptr<Figure> measuredPanel(const QString& caption, const QString& content, const QString& statement,
                                      const Style& style) {
  auto figure = std::make_unique<Figure>("measured", style);
  figure->setCaption(caption, "data not published");
  for (QCPAxis* axis : {figure->xAxis, figure->yAxis}) axis->grid()->setVisible(false);  // nothing to read off
  addNotice(*figure, "Belongs here: " + content + ".\nPublished as a picture only; no data available.\n\n" + statement);
  return figure;
}

void leaveEmpty(Figure& figure, const char* caseName) {
  addNotice(figure, QStringLiteral("Belongs here: the result of the case %1.\nNot available.").arg(caseName));
}

const std::vector<double>* acceleration(const results::AnalysedRecord* run) {
  const auto* values = run ? run->signal(signals::names::axleBoxFiltered) : nullptr;
  return values && values->size() == run->position.size() && values->size() == run->time.size() ? values : nullptr;
}

// Instant at which the wheel stands over the deepest point [s].
double timeAtDefect(const results::AnalysedRecord& run) {
  const auto at = std::lower_bound(run.position.begin(), run.position.end(), 0.0);
  return at == run.position.end() ? 0.0 : run.time[static_cast<std::size_t>(at - run.position.begin())];
}

void setTimeAxis(Figure& figure) {
  figure.xAxis->setLabel("Time from the deepest point of the defect [ms]");
  figure.xAxis->setRange(timeFrom, timeTo);
  figure.yAxis->setLabel("ABA [m/s²]");
}

void addStated(Figure& figure, double value, const QString& label) {
  const QCPRange range = figure.xAxis->range();
  addCurve(figure, {{range.lower, range.upper}, {value, value}, label, 6, 0.7, Qt::DashLine});
}

std::vector<double> timeFromDefect(const results::AnalysedRecord& run) {
  auto time = run.time;
  const double zero = timeAtDefect(run);
  for (double& t : time) t = 1e3 * (t - zero);
  return time;
}

// Measured passages beside or behind what was computed, each in a colour of its own.
using Measured = std::vector<results::AnalysedRecord>;
enum class Against { time, position, frequency };

void addMeasured(Figure& figure, const Measured& passages, Against axis) {
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const auto& passage = passages[i];
    const auto label = QString::fromStdString("measured: " + passage.title);
    const auto* values = axis == Against::frequency ? &passage.psd : acceleration(&passage);
    if (!values) continue;
    const auto x = axis == Against::time       ? timeFromDefect(passage)
                   : axis == Against::position ? scaled(passage.position, 1e3)
                                               : passage.frequency;
    addCurve(figure, {x, *values, label, 1 + i, 0.9});
  }
}

std::unique_ptr<Figure> measuredHistory(const Measured& passages, const Style& style) {
  auto figure = std::make_unique<Figure>("measured", style);
  setTimeAxis(*figure);
  addMeasured(*figure, passages, Against::time);
  fitValues(*figure, 0.1);
  figure->setCaption("Fig. 4 (a) measured", QString());
  return figure;
}

std::unique_ptr<Figure> timeHistory(const results::RunResult* run, const Style& style) {
  auto figure = std::make_unique<Figure>("time", style);
  setTimeAxis(*figure);
  const auto* values = acceleration(run);
  if (!values) {
    leaveEmpty(*figure, "light-defect");
    return figure;
  }
  addCurve(*figure, {timeFromDefect(*run), *values, "this program", 0, 1.2, Qt::SolidLine, true});
  addStated(*figure, 100, "maximum measured in the paper, 100 m/s²");
  fitValues(*figure, 0.1);
  figure->setCaption("(b) calculated", runName(*run));
  return figure;
}

FigureSheet figure4(const PaperRuns& runs, const Style& style) {
  FigureSheet sheet{"paper_figure_04", {}, 2};
  auto calculated = timeHistory(runs.light, style);
  auto measured = runs.lightMeasured.empty()
                      ? measuredPanel("Fig. 4 (a) measured", "ABA of four measured runs",
                                      "Stated: maximum 100 m/s²; first peak scatters by\nabout 28 %; runs differ at "
                                      "1.4 to 2, 3.5 and 5 ms.",
                                      style)
                      : measuredHistory(runs.lightMeasured, style);
  setTimeAxis(*measured);
  const QCPRange both = runs.lightMeasured.empty() || !acceleration(runs.light)
                            ? calculated->yAxis->range()
                            : calculated->yAxis->range().expanded(measured->yAxis->range());
  for (Figure* panel : {measured.get(), calculated.get()}) panel->yAxis->setRange(both);
  sheet.panels.push_back(std::move(measured));
  sheet.panels.push_back(std::move(calculated));
  return sheet;
}

// A frame that says what it is; white, on the dark ground of a scalogram.
void addBox(Figure& figure, double frequencyFrom, double frequencyTo, double from, double to, const QString& text) {
  auto* box = new QCPItemRect(&figure);
  box->topLeft->setCoords(from, frequencyTo);
  box->bottomRight->setCoords(to, frequencyFrom);
  box->setPen(QPen(Qt::white, 0.9));
  box->setBrush(Qt::NoBrush);
  auto* label = new QCPItemText(&figure);
  label->position->setCoords(from, frequencyTo);
  label->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
  label->setPadding(QMargins(0, 0, 0, 1));
  label->setFont(figure.style().captionFont());
  label->setColor(Qt::white);
  label->setText(text);
  label->setSelectable(false);
}

// The first of the measured passages: scalograms cannot lie over each other.
std::unique_ptr<Figure> measuredScalogram(const QString& caption, const Measured& passages, const QString& statement,
                                          const Style& style) {
  if (!passages.empty()) {
    auto figure = scalogramFigure(passages.front(), style);
    figure->setCaption(caption, QString::fromStdString(passages.front().title));
    return figure;
  }
  auto figure = measuredPanel(caption, "scalogram of the measured ABA", statement, style);
  figure->xAxis->setLabel("Position of the wheel [mm]");
  figure->yAxis->setLabel("Frequency [Hz]");
  figure->xAxis->setRange(positionFrom, positionTo);
  return figure;
}

FigureSheet scalograms(const std::string& name, const QString& title, const results::RunResult* run,
                       const char* caseName, const Measured& passages, const QString& statement, bool framed,
                       const Style& style) {
  FigureSheet sheet{name, {}, 2};
  auto measured = measuredScalogram(title + " (a) measured", passages, statement, style);
  std::unique_ptr<Figure> calculated;
  if (run) {
    calculated = scalogramFigure(*run, style);
    calculated->setCaption("(b) calculated", runName(*run));
    const QCPRange shown = calculated->xAxis->range();
    if (framed && shown.size() > 100) {
      addBox(*calculated, 230, 390, 10, shown.upper - 10, "paper: 300 Hz");
      addBox(*calculated, 850, 1180, 10, shown.upper - 10, "paper: 1000 Hz");
    }
    measured->xAxis->setRange(shown);
    for (QCPAxis* axis : {measured->yAxis, measured->yAxis2}) {
      axis->setScaleType(QCPAxis::stLogarithmic);
      axis->setTicker(calculated->yAxis->ticker());
      axis->setRange(calculated->yAxis->range());
    }
  } else {
    calculated = std::make_unique<Figure>("calculated", style);
    leaveEmpty(*calculated, caseName);
  }
  measured->setPrintedSize(calculated->printedSize());
  sheet.panels.push_back(std::move(measured));
  sheet.panels.push_back(std::move(calculated));
  return sheet;
}

struct StatedBand {
  double from, to;
};

std::unique_ptr<Figure> paperSpectrum(const results::RunResult* run, const char* caseName, const QString& caption,
                                      const std::vector<StatedBand>& bands, const Measured& passages,
                                      const Style& style) {
  if (!run) {
    auto empty = std::make_unique<Figure>("psd", style);
    leaveEmpty(*empty, caseName);
    return empty;
  }
  auto bare = *run;
  bare.psdWheel.clear();
  auto figure = psdFigure(bare, style);
  figure->xAxis->setRange(0, spectrumTo);
  if (!passages.empty()) {
    figure->graph(0)->setName("this program");
    figure->graph(0)->addToLegend();
    addMeasured(*figure, passages, Against::frequency);
    fitDensity(*figure);
  }
  for (const auto& band : bands) addBand(*figure, band.from, band.to);
  figure->setCaption(caption, runName(*run));
  return figure;
}

FigureSheet figure6(const PaperRuns& runs, const Style& style) {
  // "About 300 Hz" and "about 1000 Hz" as bands of a tenth to each side.
  auto figure = paperSpectrum(runs.light, "light-defect", "Fig. 6, calculated", {{270, 330}, {900, 1100}},
                              runs.lightMeasured, style);
  QString note = "shaded: the paper's two main peaks, about 300 and 1000 Hz";
  if (runs.lightMeasured.empty()) note += "\nmeasured curves: published as a picture only";
  addNote(*figure, note, 0.02);
  figure->yAxis->setRangeUpper(1.2 * figure->yAxis->range().upper);
  return sheetOf("paper_figure_06", std::move(figure));
}

FigureSheet squatFigure(const std::string& name, const QString& title, const results::RunResult* run,
                        const char* caseName, const Measured& passages, const QString& statement, const Style& style) {
  FigureSheet sheet{name, {}, 2};
  auto history = std::make_unique<Figure>(signals::names::axleBox, style);
  history->xAxis->setLabel("Position from the deepest point [mm]");
  history->yAxis->setLabel("ABA [m/s²]");
  history->xAxis->setRange(positionFrom, positionTo);
  history->setCaption(title + " (a) ABA", run ? runName(*run) : QString());
  if (const auto* values = acceleration(run)) {
    const Window window = judgedWindow(*run);
    history->xAxis->setRange(1e3 * window.from, 1e3 * window.to);
    addCurve(*history, {scaled(run->position, 1e3), *values, "this program", 0, 1.2});
    addMeasured(*history, passages, Against::position);
    fitValues(*history);
    history->yAxis->setRangeUpper(history->yAxis->range().upper + 0.25 * history->yAxis->range().size());
    addNote(*history, (passages.empty() ? "measured curve: published as a picture only\n" : "") + statement, 0.02);
  } else {
    leaveEmpty(*history, caseName);
  }
  auto spectrum = paperSpectrum(run, caseName, "(b) PSD", {{130, 320}, {1030, 1130}}, passages, style);
  if (run) {
    addNote(*spectrum, "shaded: the two main frequencies measured,\n130–320 and 1030–1130 Hz", 0.02);
    spectrum->yAxis->setRangeUpper(1.2 * spectrum->yAxis->range().upper);
  }
  sheet.panels.push_back(std::move(history));
  sheet.panels.push_back(std::move(spectrum));
  return sheet;
}

FigureSheet figure9(const PaperRuns& runs, const Style& style) {
  auto figure = std::make_unique<Figure>("profiles", style);
  figure->xAxis->setLabel("Position along the rail [mm]");
  figure->yAxis->setLabel("Height [mm]");
  figure->setCaption("Fig. 9, profiles of the class C squat", QString());
  double from = -0.06, to = 0.12;
  bool any = false;
  const auto add = [&](const results::RunResult* run, const QString& label, std::size_t colour, Qt::PenStyle line) {
    if (!run || run->profilePosition.empty()) return;
    const Extent extent = defectExtent(*run);
    if (!extent.empty()) from = std::min(from, extent.from - 0.02), to = std::max(to, extent.to + 0.02);
    addCurve(*figure, {scaled(run->profilePosition, 1e3), scaled(run->profileHeight, 1e3), label, colour, 1.2, line});
    any = true;
  };
  add(runs.squat, "as measured (length from the paper, depth assumed)", 0, Qt::SolidLine);
  add(runs.modified, "modification (assumed)", 1, Qt::DashLine);
  figure->xAxis->setRange(1e3 * from, 1e3 * to);
  fitValues(*figure, 0.1);
  if (!any) leaveEmpty(*figure, "class-c-squat");
  figure->setPrintedSize({120, 60});
  return sheetOf("paper_figure_09", std::move(figure));
}

}  // namespace

std::vector<FigureSheet> paperFigures(const PaperRuns& runs, const Style& style) {
  std::vector<FigureSheet> sheets;
  sheets.push_back(figure4(runs, style));
  sheets.push_back(
      scalograms("paper_figure_05", "Fig. 5", runs.light, "light-defect", runs.lightMeasured,
                 "Stated: up to 1700 Hz at the impact (calculated:\n2500 Hz); free vibrations near 300 and 1000 Hz,\n"
                 "framed in (b).",
                 true, style));
  sheets.push_back(figure6(runs, style));
  sheets.push_back(squatFigure("paper_figure_08", "Fig. 8", runs.squat, "class-c-squat", runs.squatMeasured,
                               "stated: calculated peak about 60 % of the measured one", style));
  sheets.push_back(figure9(runs, style));
  sheets.push_back(squatFigure("paper_figure_10", "Fig. 10", runs.modified, "class-c-squat-modified",
                               runs.squatMeasured, "stated: peaks still differ by about 60 %; 300 Hz agrees", style));
  sheets.push_back(scalograms(
      "paper_figure_11", "Fig. 11", runs.modified, "class-c-squat-modified", runs.squatMeasured,
      "Stated: up to 1500 Hz at the impact; most energy\nbelow 550 Hz, a weaker part near 1000 Hz.", false, style));
  return sheets;
}

}  // namespace squat::plots
