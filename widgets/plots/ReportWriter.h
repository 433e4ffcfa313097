// widgets/plots/ReportWriter.h - headings, paragraphs, tables and pictures of a report, one behind the other in a
// document.
#pragma once

#include <QImage>
#include <QString>
#include <QTextCursor>
#include <QTextDocument>

#include "project/ReportContent.h"

namespace squat::plots {

inline constexpr double reportTextSize = 9;  // [pt]
inline constexpr double cellPadding = 0.7;   // [mm] of the cells of tables

// Margins, padding and pictures of a text document count in dots of the screen, and are scaled to the page by Qt.
double screenDots(double millimetres);

enum class HeadingLevel { title, part, section };

class ReportWriter {
 public:
  explicit ReportWriter(QTextDocument& document) : cursor_(&document) {}

  QTextCursor& cursor() { return cursor_; }

  // A heading stays with what follows it (ReportLayout.h).
  void heading(const QString& text, HeadingLevel level = HeadingLevel::section, bool onNewPage = false);
  void paragraph(const QString& text);
  void smallPrint(const QString& text);
  // Each paragraph of a text whose paragraphs are parted by empty lines.
  void paragraphs(const QString& text);
  // An empty paragraph: what is inserted at the cursor stands in it.
  void room();
  void table(const project::ReportTable& table);
  void picture(const QString& name, const QImage& image, double width);  // [mm]

 private:
  void add(const QString& text, const QTextBlockFormat& block, const QTextCharFormat& format);

  QTextCursor cursor_;
  bool isEmpty_ = true;  // the document
};

}  // namespace squat::plots
