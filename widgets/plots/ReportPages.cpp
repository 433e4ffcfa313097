#include "plots/ReportPages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QGuiApplication>
#include <QPdfWriter>
#include <QScreen>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ProgramVersion.h"
#include "plots/Drawing.h"
#include "plots/FigureRegistry.h"
#include "plots/ReportFigures.h"
#include "scene/ModelPicture.h"

namespace squat::plots {
namespace {

constexpr int resolution = 1200;  // [dpi] of coordinates; curves and text are vectors
constexpr double sideMargin = 19,
                 verticalMargin = 18;  // [mm]: two figures of a journal column stand side by side on A4
constexpr double padding = 0.7;        // [mm] of the cells of tables
constexpr double textSize = 9, tableSize = 7, footerSize = 7;  // [pt]

double millimetres(double dots) { return dots / resolution * 25.4; }
double dots(double millimetres) { return millimetres / 25.4 * resolution; }

// Margins, padding and pictures of a text document count in dots of the screen, and are scaled to the page by Qt.
double screenDots(double millimetres) {
  return millimetres / 25.4 * QGuiApplication::primaryScreen()->logicalDotsPerInchY();
}

QTextCharFormat letters(double points, bool bold = false) {
  QTextCharFormat format;
  format.setFontPointSize(points);
  format.setFontWeight(bold ? QFont::Bold : QFont::Normal);
  return format;
}

QTextBlockFormat paragraph(double above, double below) {
  QTextBlockFormat format;
  format.setTopMargin(screenDots(above));
  format.setBottomMargin(screenDots(below));

  return format;
}

class Writer {
 public:
  explicit Writer(QTextDocument& document) : cursor_(&document) {}

  QTextCursor& cursor() { return cursor_; }

  void add(const QString& text, const QTextBlockFormat& block, const QTextCharFormat& format) {
    if (!empty_) cursor_.insertBlock();
    empty_ = false;
    cursor_.setBlockFormat(block);
    cursor_.setCharFormat(format);
    cursor_.insertText(text, format);
  }
  void heading(const QString& text, QTextFormat::PageBreakFlags breaks = QTextFormat::PageBreak_Auto) {
    QTextBlockFormat block = paragraph(5, 2);
    block.setPageBreakPolicy(breaks);
    add(text, block, letters(textSize + 2, true));
  }

  void notes(const QString& text) {
    heading(QStringLiteral("Notes"));
    for (const QString& part : text.split(QStringLiteral("\n\n"), Qt::SkipEmptyParts))
      add(part.trimmed(), paragraph(0, 2), letters(textSize));
  }

  void table(const project::ReportTable& table, QTextFormat::PageBreakFlags breaks = QTextFormat::PageBreak_Auto) {
    heading(QString::fromStdString(table.heading), breaks);
    QTextTableFormat format;
    format.setHeaderRowCount(1);
    format.setBorder(0);
    format.setCellPadding(screenDots(padding));
    format.setCellSpacing(0);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    const int columns = static_cast<int>(table.columns.size());
    QTextTable* made = cursor_.insertTable(static_cast<int>(table.rows.size()) + 1, columns, format);
    for (int column = 0; column < columns; ++column)
      fill(made->cellAt(0, column), table.columns[static_cast<std::size_t>(column)], true, false);
    for (int row = 0; row < static_cast<int>(table.rows.size()); ++row)
      for (int column = 0; column < columns; ++column)
        fill(made->cellAt(row + 1, column), table.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
             false, row % 2 == 1);
    cursor_.movePosition(QTextCursor::End);
    empty_ = true;  // the block behind a table
  }

 private:
  // Every second row on grey: an eye finds its way without lines.
  static void fill(QTextTableCell cell, const std::string& text, bool head, bool grey) {
    QTextTableCellFormat format;
    if (head || grey) format.setBackground(head ? QColor(215, 215, 215) : QColor(244, 244, 244));
    cell.setFormat(format);
    // A path or a list of numbers may be broken behind a slash or a comma.
    QString shown = QString::fromStdString(text);
    if (shown.size() > 30) shown.replace('/', QStringLiteral("/\u200b"));
    cell.firstCursorPosition().insertText(shown, letters(tableSize, head));
  }

  QTextCursor cursor_;
  bool empty_ = true;  // nothing is in the block of the cursor yet
};

void addModel(Writer& writer, const results::RunResult& shown, const ReportOptions& options,
              std::vector<std::string>& problems) {
  const auto& names = options.figures;
  for (const auto& row : figureRegistry()) {
    const bool asked = names.empty() || std::find(names.begin(), names.end(), row.name) != names.end();
    if (row.kind != FigureKind::model || !asked || !row.applies(shown)) continue;
    std::string reason;
    const auto picture = scene::modelPicture(shown, options.colourMap, reason);
    if (picture.empty()) {
      problems.push_back("figure " + row.name + " not drawn: " + reason);
      continue;
    }
    const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888);
    QTextImageFormat format;
    const QString name = QString::fromStdString(row.name);
    writer.cursor().document()->addResource(QTextDocument::ImageResource, QUrl(name), image.copy());
    format.setName(name);
    format.setWidth(screenDots(170));
    format.setHeight(screenDots(170) * picture.height / picture.width);
    writer.add({}, paragraph(2, 2), letters(textSize));
    writer.cursor().insertImage(format);
  }
}

void fillDocument(QTextDocument& document, ReportFigures& figures, const project::Report& report,
                  const ReportOptions& options, std::vector<std::string>& problems) {
  auto plots = reportPlots(report, options);
  Writer writer(document);
  writer.cursor().beginEditBlock();  // laid out once, at the end
  writer.add(QString::fromStdString(report.title), paragraph(0, 3), letters(textSize + 7, true));
  if (!report.notes.empty()) writer.notes(QString::fromStdString(report.notes));
  auto tables = project::reportTables(report, problems);
  // The case, which is long, stands behind the figures.
  const bool hasCase = !tables.empty() && tables.back().heading.starts_with("Case of");
  for (std::size_t i = 0; i + (hasCase ? 1 : 0) < tables.size(); ++i) writer.table(tables[i]);
  if (report.shown >= 0) {
    const auto& shown = report.signals[static_cast<std::size_t>(report.shown)];
    writer.heading("Figures of " + QString::fromStdString(shown.name), QTextFormat::PageBreak_AlwaysBefore);
    writer.add({}, paragraph(0, 0), letters(textSize));
    for (auto& plot : plots) figures.insert(writer.cursor(), std::move(plot));
    addModel(writer, *shown.result, options, problems);
  }
  if (hasCase) writer.table(tables.back(), QTextFormat::PageBreak_AlwaysBefore);
  writer.cursor().endEditBlock();
}

// A row that a page would end in begins on the next one: half a sentence beside a number says nothing.
void keepRowsWhole(QTextDocument& document, double pageHeight) {
  const auto* layout = document.documentLayout();
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    const auto* table = qobject_cast<QTextTable*>(frame);
    for (int row = 1; table && row < table->rows(); ++row) {
      double top = std::numeric_limits<double>::infinity(), bottom = 0;
      for (int column = 0; column < table->columns(); ++column) {
        const QTextTableCell cell = table->cellAt(row, column);
        top = std::min(top, layout->blockBoundingRect(cell.firstCursorPosition().block()).top());
        bottom = std::max(bottom, layout->blockBoundingRect(cell.lastCursorPosition().block()).bottom());
      }
      const double end = (std::floor(top / pageHeight) + 1) * pageHeight;
      if (bottom <= end) continue;
      for (int column = 0; column < table->columns(); ++column) {
        QTextTableCell cell = table->cellAt(row, column);
        QTextTableCellFormat format = cell.format().toTableCellFormat();
        format.setTopPadding(screenDots(millimetres(end - top)) + screenDots(padding));
        cell.setFormat(format);
      }
    }
  }
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
  font.setPointSizeF(textSize);
  font.setStyleStrategy(QFont::PreferNoShaping);  // no ligatures: a search for "filtered" finds it
  document.setDefaultFont(font);
  const QSizeF whole = page.size(QPageSize::Millimeter);
  const QSizeF text(dots(whole.width() - 2 * sideMargin), dots(whole.height() - 2 * verticalMargin));
  document.setPageSize(text);
  fillDocument(document, figures, report, options, problems);
  keepRowsWhole(document, text.height());
  drawPages(pdf, document, figures, text, title);
  return bytes;
}

}  // namespace squat::plots
