// widgets/studio/signals/FigureView.h - a figure in the window: zoom, cursors, copy and export as it is zoomed.
#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>

#include "plots/Figure.h"
#include "plots/PrintedSize.h"

namespace squat::studio {

class CursorPair;

class FigureView : public QWidget {
  Q_OBJECT
 public:
  explicit FigureView(const QString& name, QWidget* parent = nullptr);

  // Takes the figure; a view that the user has zoomed keeps its range, and its cursors their places, where the axis
  // label is the same. Curves that the user has hidden stay hidden, by their names in tables. `table`: its numbers as
  // CSV where they are more than its curves; empty: figureTable().
  void show(std::unique_ptr<plots::Figure> figure, double secondsPerUnit, const QString& unit,
            const QByteArray& table = {});
  plots::Figure* figure() const { return figure_; }
  void setCursors(bool visible);
  CursorPair* cursors() const { return cursors_; }
  void setRange(const QCPRange& range);  // of x, from a linked view
  void resetZoom();
  // Dragging moves what is drawn in place of the axis: shifted() tells how far, whoever listens draws it anew.
  void setShifting(bool on);
  void forgetZoom();  // the next figure is of another run: it is shown whole
  bool isZoomed() const;
  const QCPRange& wholeX() const { return fullX_; }  // what is seen without zoom
  const QCPRange& wholeY() const { return fullY_; }
  // Of what is copied and exported, whatever the size of the window.
  void setPrintedSize(const plots::PrintedSize& size) { size_ = size; }
  void copy();        // picture and numbers
  void askForFile();  // exports to what the user names
  // Format by the file's ending: png, svg, pdf, or csv for the curves. Throws FileError, CaseError for too large a
  // size.
  void writeFile(const QString& path);

 Q_SIGNALS:
  void rangeChanged(const QCPRange& range);
  void zoomed();                             // along x or y
  void cursorsToggled(bool visible);         // by a key
  void shifted(double distance, bool done);  // along x since the button went down; in units of the axis
  void failed(const QString& message);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void takeKeys();
  std::set<QString> hiddenCurves() const;
  void hideCurves(const std::set<QString>& hidden);
  double distance(const QMouseEvent& event) const;
  void openMenu(const QPoint& location);
  QSize printedUnits() const;

  QString name_;
  plots::Figure* figure_ = nullptr;
  CursorPair* cursors_ = nullptr;
  QByteArray table_;
  plots::PrintedSize size_;
  QCPRange fullX_, fullY_;
  bool cursorsVisible_ = false;
  bool shifting_ = false;
  std::optional<int> pressed_;  // [pixels] where the button went down
};

}  // namespace squat::studio
