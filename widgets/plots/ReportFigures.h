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

struct ReportPlots {
  std::unique_ptr<Figure> first;                 // what the report opens with; null: there is nothing to draw
  std::vector<std::unique_ptr<Figure>> further;  // of the run that is shown
  bool opensWithEvents = false;                  // the first one is the map of events
};

// The figures that were asked for, overlaid signals in them: acceleration against position first, where it is among
// them. Where no run is shown, the first signal with an acceleration and positions; without signals, the events along
// the track. Throws as reportPdf.
ReportPlots reportPlots(const project::Report& report, const ReportOptions& options);

// Signal and scalogram over the squat that is event number `event` of the list; none where its signal is in no file.
// Throws FileError, CaseError and SignalError for a file that cannot be read.
std::vector<std::unique_ptr<Figure>> squatPlots(const project::Report& report, std::size_t event,
                                                const ReportOptions& options);

}  // namespace squat::plots
