// widgets/studio/FigureView.h - a figure in the window: zoom, cursors, copy and export exactly as seen.
#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <memory>

#include "plots/Figure.h"

namespace squat::studio {

class CursorPair;

class FigureView : public QWidget {
  Q_OBJECT
 public:
  explicit FigureView(const QString& name, QWidget* parent = nullptr);

  // Takes the figure; a view that the user has zoomed keeps its range where the axis label is the same.
  void show(std::unique_ptr<plots::Figure> figure, double secondsPerUnit, const QString& unit);
  plots::Figure* figure() const { return figure_; }
  void setCursors(bool visible);
  CursorPair* cursors() const { return cursors_; }
  void setRange(const QCPRange& range);  // of x, from a linked view
  void resetZoom();
  // Format by the file's ending: png, svg, pdf, or csv for the curves. Throws FileError.
  void writeFile(const QString& path);

 Q_SIGNALS:
  void rangeChanged(const QCPRange& range);
  void failed(const QString& message);

 private:
  void openMenu(const QPoint& place);
  void askForFile();
  QByteArray curvesAsTable() const;

  QString name_;
  plots::Figure* figure_ = nullptr;
  CursorPair* cursors_ = nullptr;
  QCPRange fullX_, fullY_;
  bool cursorsVisible_ = false;
};

}  // namespace squat::studio
