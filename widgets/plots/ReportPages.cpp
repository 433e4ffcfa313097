#include "plots/ReportPages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDate>
#include <QLocale>
#include <QPdfWriter>
#include <algorithm>

#include "plots/DetectionFigures.h"
#include "plots/Drawing.h"
#include "plots/FigureRegistry.h"
#include "plots/ReportFigures.h"
#include "plots/ReportLayout.h"
#include "plots/ReportWriter.h"
#include "scene/ModelPicture.h"

namespace squat::plots {
namespace {

constexpr int resolution = 1200;  // [dpi] of coordinates; curves and text are vectors
constexpr double sideMargin = 19,
                 verticalMargin = 18;  // [mm]: two figures of a journal column stand side by side on A4
constexpr double footerSize = 7;       // [pt]
constexpr qsizetype shortNotes = 400;  // letters: longer ones would push the picture off the first page

double dots(double millimetres) { return millimetres / 25.4 * resolution; }

// A report as it is written into the document.
struct Pages {
  ReportWriter& writer;
  ReportFigures& figures;
  const project::Report& report;
  const ReportOptions& options;
  std::vector<std::string>& problems;

  void figure(std::unique_ptr<Figure> plot) {
    if (!plot) return;
    writer.room();
    figures.insert(writer.cursor(), std::move(plot));
  }
};

// The 3-D picture, where it was asked for and the run has a surface; else null.
const FigureRow* modelRow(const Pages& pages, const results::RunResult& shown) {
  const auto& names = pages.options.figures;
  for (const auto& row : figureRegistry()) {
    const bool asked = names.empty() || std::find(names.begin(), names.end(), row.name) != names.end();
    if (row.kind == FigureKind::model && asked && row.applies(shown)) return &row;
  }
  return nullptr;
}

void addModel(Pages& pages, const results::RunResult& shown, const std::string& name) {
  constexpr double width = 170;  // [mm]
  std::string reason;
  const auto picture = scene::modelPicture(shown, pages.options.colourMap, reason);
  if (picture.empty()) return pages.problems.push_back("figure " + name + " not drawn: " + reason);
  const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888);
  pages.writer.picture(QString::fromStdString(name), image.copy(), width);
}

void addTitle(Pages& pages) {
  pages.writer.heading(QString::fromStdString(pages.report.title), HeadingLevel::title);
  const QString date = pages.report.date.empty()
                           ? QLocale::c().toString(QDate::currentDate(), QStringLiteral("d MMMM yyyy"))
                           : QString::fromStdString(pages.report.date);
  pages.writer.smallPrint(date + QStringLiteral(" · ") + drawnBy());
}

// Short notes stand under the title, long ones behind what they comment on.
void addOpening(Pages& pages, const project::ReportContent& content, std::unique_ptr<Figure> first) {
  const QString notes = QString::fromStdString(pages.report.notes).trimmed();
  const bool isShort = notes.size() <= shortNotes;
  addTitle(pages);
  if (isShort) pages.writer.paragraphs(notes);
  pages.figure(std::move(first));
  for (const auto& sentence : content.sentences) pages.writer.paragraph(QString::fromStdString(sentence));
  if (!isShort) {
    pages.writer.heading(QStringLiteral("Notes"));
    pages.writer.paragraphs(notes);
  }
  for (const auto& table : content.body) pages.writer.table(table);
}

void addSquats(Pages& pages, const project::ReportContent& content, bool withMap) {
  const auto& report = pages.report;
  project::ReportTable list = content.squatList;
  if (!list.rows.empty()) {
    pages.writer.heading(QString::fromStdString(list.heading));
    list.heading.clear();
    if (withMap) {
      auto map = eventMap(report.events, lightStyle());
      map->setPrintedSize({170, 60});
      pages.figure(std::move(map));
    }
    pages.writer.table(list);
  }
  std::size_t missing = 0;
  for (const auto& squat : content.squats) {
    pages.writer.heading(QString::fromStdString(squat.heading), HeadingLevel::part, true);
    std::vector<std::unique_ptr<Figure>> plots;
    try {
      plots = squatPlots(report, squat.event, pages.options);
    } catch (const std::exception& error) {
      pages.problems.push_back(squat.heading + ": " + error.what());
    }
    if (plots.empty()) {
      ++missing;
      pages.writer.smallPrint(QStringLiteral("The signal over this squat is in no file that can be read."));
    }
    for (auto& plot : plots) pages.figure(std::move(plot));
    pages.writer.table(squat.facts);
  }
  if (missing > 0)
    pages.problems.push_back("no signals over " + std::to_string(missing) + " of " +
                             std::to_string(content.squats.size()) + " squats in " + report.eventFolder + "/passages");
}

void addAppendix(Pages& pages, const project::ReportContent& content, std::vector<std::unique_ptr<Figure>> plots) {
  if (content.appendix.empty() && plots.empty()) return;
  // The page of a squat is the squat's.
  pages.writer.heading(QStringLiteral("Appendix"), HeadingLevel::part, !content.squats.empty());
  if (pages.report.shown >= 0) {
    const auto& shown = pages.report.signals[static_cast<std::size_t>(pages.report.shown)];
    const auto* model = modelRow(pages, *shown.result);
    if (!plots.empty() || model) pages.writer.heading("Figures of " + QString::fromStdString(shown.name));
    if (!plots.empty()) pages.writer.room();
    for (auto& plot : plots) pages.figures.insert(pages.writer.cursor(), std::move(plot));
    if (model) addModel(pages, *shown.result, model->name);
  }
  for (const auto& table : content.appendix) pages.writer.table(table);
}

void fillDocument(QTextDocument& document, ReportFigures& figures, const project::Report& report,
                  const ReportOptions& options, std::vector<std::string>& problems) {
  auto plots = reportPlots(report, options);
  const auto content = project::reportContent(report, problems);
  ReportWriter writer(document);
  Pages pages{writer, figures, report, options, problems};
  writer.cursor().beginEditBlock();  // laid out once, at the end
  addOpening(pages, content, std::move(plots.first));
  addSquats(pages, content, !plots.opensWithEvents);
  addAppendix(pages, content, std::move(plots.further));
  writer.cursor().endEditBlock();
}

void drawPages(QPdfWriter& pdf, QTextDocument& document, ReportFigures& figures, const QSizeF& text,
               const QString& title) {
  QCPPainter painter(&pdf);
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page) {
    if (page > 0) pdf.newPage();
    painter.save();
    painter.translate(dots(sideMargin), dots(verticalMargin) - page * text.height());
    const QRectF part(0, page * text.height(), text.width(), text.height());
    figures.setPage(part);
    document.drawContents(&painter, part);
    painter.restore();
    QFont small = document.defaultFont();
    small.setPointSizeF(footerSize);
    painter.setFont(small);
    painter.setPen(QColor(110, 110, 110));
    const QRectF foot(dots(sideMargin), dots(verticalMargin) + text.height() + dots(3), text.width(), dots(6));
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignTop, title + " · " + drawnBy());
    painter.drawText(foot, Qt::AlignRight | Qt::AlignTop, QObject::tr("page %1 of %2").arg(page + 1).arg(pages));
  }
}

}  // namespace

QByteArray reportPdf(const project::Report& report, const ReportOptions& options, std::vector<std::string>& problems) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter pdf(&buffer);
  pdf.setResolution(resolution);
  const QPageSize page(options.page == PageFormat::a4 ? QPageSize::A4 : QPageSize::Letter);
  pdf.setPageSize(page);
  pdf.setPageMargins(QMarginsF());
  const QString title = QString::fromStdString(report.title);
  pdf.setTitle(title);
  pdf.setCreator(drawnBy());

  QTextDocument document;
  ReportFigures figures(resolution);
  document.documentLayout()->setPaintDevice(&pdf);
  document.setDocumentMargin(0);
  QFont font = lightStyle().labelFont();
  font.setPointSizeF(reportTextSize);
  font.setStyleStrategy(QFont::PreferNoShaping);  // no ligatures: a search for "filtered" finds it
  document.setDefaultFont(font);
  const QSizeF whole = page.size(QPageSize::Millimeter);
  const QSizeF text(dots(whole.width() - 2 * sideMargin), dots(whole.height() - 2 * verticalMargin));
  document.setPageSize(text);
  fillDocument(document, figures, report, options, problems);
  arrangePages(document, resolution);
  drawPages(pdf, document, figures, text, title);
  return bytes;
}

}  // namespace squat::plots
