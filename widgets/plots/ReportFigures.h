// widgets/plots/ReportFigures.h - figures inside a text document.
#pragma once

#include <QObject>
#include <QTextObjectInterface>
#include <memory>
#include <vector>

#include "plots/Figure.h"
#include "plots/ReportPages.h"

class QTextCursor;

namespace squat::plots {

// Draws figures where a document has placed them, as vectors at their printed size. The painter of the document must be
// a QCPPainter. Lives as long as the document is drawn.
class ReportFigures : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
 public:
  // `unitsPerInch`: of the document's layout.
  explicit ReportFigures(double unitsPerInch) : scale_(unitsPerInch / 96.0) {}

  void insert(QTextCursor& cursor, std::unique_ptr<Figure> figure);
  // The part of the document that is being drawn: a figure outside of it, which no clip would hold, is left out.
  void setPage(const QRectF& page) { page_ = page; }

  QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int position,
                  const QTextFormat& format) override;

 private:
  Figure& figureOf(const QTextFormat& format) const;
  double scale_;  // units of the document in 1/96 inch
  QRectF page_;
  std::vector<std::unique_ptr<Figure>> figures_;
};

// The plots of the report's figures, overlaid signals in them; none where no run is shown. Throws as reportPdf.
std::vector<std::unique_ptr<Figure>> reportPlots(const project::Report& report, const ReportOptions& options);

}  // namespace squat::plots
