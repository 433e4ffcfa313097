#include "plots/ReportWriter.h"

#include <QGuiApplication>
#include <QScreen>
#include <QTextTable>
#include <QUrl>

#include "plots/ReportLayout.h"

namespace squat::plots {
namespace {

constexpr double tableSize = 7;  // [pt]

QTextCharFormat letters(double points, bool bold = false) {
  QTextCharFormat format;
  format.setFontPointSize(points);
  format.setFontWeight(bold ? QFont::Bold : QFont::Normal);
  return format;
}

QTextBlockFormat blockWith(double above, double below) {  // [mm]
  QTextBlockFormat format;
  format.setTopMargin(screenDots(above));
  format.setBottomMargin(screenDots(below));
  return format;
}

// Every second row on grey: an eye finds its way without lines.
void fillCell(QTextTableCell cell, const std::string& text, bool head, bool grey) {
  QTextTableCellFormat format;
  if (head || grey) format.setBackground(head ? QColor(215, 215, 215) : QColor(244, 244, 244));
  cell.setFormat(format);
  // A path or a list of numbers may be broken behind a slash or a comma.
  QString shown = QString::fromStdString(text);
  if (shown.size() > 30) shown.replace('/', QStringLiteral("/\u200b"));
  cell.firstCursorPosition().insertText(shown, letters(tableSize, head));
}

}  // namespace

double screenDots(double millimetres) {
  return millimetres / 25.4 * QGuiApplication::primaryScreen()->logicalDotsPerInchY();
}

// Qt gives the paragraph right behind a table no margin above it, and hides an empty one: each text has a paragraph of
// its own behind that.
void ReportWriter::add(const QString& text, const QTextBlockFormat& block, const QTextCharFormat& format) {
  if (!isEmpty_) cursor_.insertBlock();
  isEmpty_ = false;
  cursor_.setBlockFormat(block);
  cursor_.setCharFormat(format);
  cursor_.insertText(text, format);
}

void ReportWriter::heading(const QString& text, HeadingLevel level, bool onNewPage) {
  const double larger = level == HeadingLevel::title ? 7 : level == HeadingLevel::part ? 5 : 2;  // [pt]
  QTextBlockFormat block = blockWith(level == HeadingLevel::part ? 8 : 5, 2);
  // Qt gives a table no margin below the paragraph before it either.
  block.setLineHeight(screenDots(1), QTextBlockFormat::LineDistanceHeight);
  if (onNewPage) block.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
  if (level != HeadingLevel::title) block.setProperty(staysWithNext, true);
  add(text, block, letters(reportTextSize + larger, true));
}

void ReportWriter::paragraph(const QString& text) { add(text, blockWith(0, 2), letters(reportTextSize)); }

void ReportWriter::smallPrint(const QString& text) {
  QTextCharFormat grey = letters(reportTextSize - 1);
  grey.setForeground(QColor(90, 90, 90));
  add(text, blockWith(0, 2), grey);
}

void ReportWriter::paragraphs(const QString& text) {
  for (const QString& part : text.split(QStringLiteral("\n\n"), Qt::SkipEmptyParts)) paragraph(part.trimmed());
}

void ReportWriter::room() { add({}, blockWith(1, 2), letters(reportTextSize)); }

void ReportWriter::table(const project::ReportTable& table) {
  if (table.rows.empty()) return;
  if (!table.heading.empty()) heading(QString::fromStdString(table.heading));
  const bool hasHead = !table.columns.empty();
  QTextTableFormat format;
  format.setHeaderRowCount(hasHead ? 1 : 0);
  format.setBorder(0);
  format.setCellPadding(screenDots(cellPadding));
  format.setCellSpacing(0);
  format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
  const auto& widest = hasHead ? table.columns : table.rows.front();
  const int columns = static_cast<int>(widest.size()), rows = static_cast<int>(table.rows.size());
  const int first = hasHead ? 1 : 0;
  QTextTable* made = cursor_.insertTable(rows + first, columns, format);
  for (int column = 0; hasHead && column < columns; ++column)
    fillCell(made->cellAt(0, column), table.columns[static_cast<std::size_t>(column)], true, false);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      fillCell(made->cellAt(row + first, column),
               table.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], false, row % 2 == 1);
  cursor_.movePosition(QTextCursor::End);
  cursor_.setBlockFormat({});  // not that of the heading: no page break
}

void ReportWriter::picture(const QString& name, const QImage& image, double width) {
  cursor_.document()->addResource(QTextDocument::ImageResource, QUrl(name), image);
  QTextImageFormat format;
  format.setName(name);
  format.setWidth(screenDots(width));
  format.setHeight(screenDots(width) * image.height() / image.width());
  room();
  cursor_.insertImage(format);
}

}  // namespace squat::plots
