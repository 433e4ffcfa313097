// widgets/studio/signals/FigureView.h - a figure in the window: zoom, cursors, copy and export as it is zoomed.
#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <memory>

#include "plots/Figure.h"
#include "plots/PrintedSize.h"

namespace squat::studio {

class CursorPair;

class FigureView : public QWidget {
  Q_OBJECT
 public:
  explicit FigureView(const QString& name, QWidget* parent = nullptr);

  // Takes the figure; a view that the user has zoomed keeps its range, and its cursors their places, where the axis
  // label is the same. `table`: its numbers as CSV where they are more than its curves; empty: figureTable().
  void show(std::unique_ptr<plots::Figure> figure, double secondsPerUnit, const QString& unit,
            const QByteArray& table = {});
  plots::Figure* figure() const { return figure_; }
  void setCursors(bool visible);
  CursorPair* cursors() const { return cursors_; }
  void setRange(const QCPRange& range);  // of x, from a linked view
  void resetZoom();
  void forgetZoom();  // the next figure is of another run: it is shown whole
  bool isZoomed() const;
  // Of what is copied and exported, whatever the size of the window.
  void setPrintedSize(const plots::PrintedSize& size) { size_ = size; }
  void copy();        // picture and numbers
  void askForFile();  // exports to what the user names
  // Format by the file's ending: png, svg, pdf, or csv for the curves. Throws FileError, CaseError for too large a
  // size.
  void writeFile(const QString& path);

 Q_SIGNALS:
  void rangeChanged(const QCPRange& range);
  void failed(const QString& message);

 private:
  void openMenu(const QPoint& location);
  QSize printedUnits() const;

  QString name_;
  plots::Figure* figure_ = nullptr;
  CursorPair* cursors_ = nullptr;
  QByteArray table_;
  plots::PrintedSize size_;
  QCPRange fullX_, fullY_;
  bool cursorsVisible_ = false;
};

}  // namespace squat::studio
