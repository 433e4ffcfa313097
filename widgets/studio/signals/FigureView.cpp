#include "studio/signals/FigureView.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <map>

#include "core/Errors.h"
#include "plots/FigureFiles.h"
#include "studio/common/KeyboardZoom.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/MouseZoom.h"
#include "studio/common/Words.h"
#include "studio/signals/CursorPair.h"
#include "studio/signals/FigureTable.h"

namespace squat::studio {

namespace {

// Names of a figure's legend by which a curve is known again when it is drawn once more. Machine names leave out what
// changes, such as the extreme values, and may be alike then: those are counted.
QStringList keysOfCurves(plots::Figure& figure) {
  QStringList keys;
  std::map<QString, int> seen;
  for (int i = 0; const auto* curve = figure.curveOfEntry(i); ++i) {
    const QString name = machineName(curve->name());
    keys << QStringLiteral("%1 %2").arg(name).arg(++seen[name]);
  }
  return keys;
}

}  // namespace

FigureView::FigureView(const QString& name, QWidget* parent) : QWidget(parent), name_(name) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  setObjectName("view " + name);
  setMinimumSize(200, 140);
}

void FigureView::show(std::unique_ptr<plots::Figure> figure, double secondsPerUnit, const QString& unit,
                      const QByteArray& table) {
  const bool sameAxis = figure_ && figure_->xAxis->label() == figure->xAxis->label();
  const bool keep = sameAxis && isZoomed();
  const QCPRange kept = keep ? figure_->xAxis->range() : QCPRange();
  const bool keepUp =
      sameAxis && figure_->yAxis->label() == figure->yAxis->label() && figure_->yAxis->range() != fullY_;
  const QCPRange keptUp = keepUp ? figure_->yAxis->range() : QCPRange();
  const bool keepCursors = sameAxis && cursors_->isPlaced();
  const double locations[] = {keepCursors ? cursors_->location(0) : 0, keepCursors ? cursors_->location(1) : 0};
  const int lastMoved = cursors_ ? cursors_->lastMoved() : 0;
  const bool focused = figure_ && figure_->hasFocus();
  if (focused) setFocus();  // so that it does not go to the next widget
  const auto hidden = hiddenCurves();
  table_ = table;
  delete figure_;
  figure_ = figure.release();
  figure_->setParent(this);
  hideCurves(hidden);
  layout()->addWidget(figure_);
  fullX_ = figure_->xAxis->range();
  fullY_ = figure_->yAxis->range();
  figure_->setContextMenuPolicy(Qt::CustomContextMenu);
  figure_->setAccessibleName(tr("Figure %1").arg(name_));
  // Opposite axes follow, so that zooming moves all four.
  connect(figure_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), figure_->xAxis2,
          qOverload<const QCPRange&>(&QCPAxis::setRange));
  connect(figure_->yAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), figure_->yAxis2,
          qOverload<const QCPRange&>(&QCPAxis::setRange));
  cursors_ = new CursorPair(*figure_, secondsPerUnit, unit);
  cursors_->setLastMoved(lastMoved);
  takeKeys();
  if (keepCursors) cursors_->setLocations(locations[0], locations[1]);
  cursors_->setVisible(cursorsVisible_);
  new MouseZoom(*figure_, [cursors = cursors_] { return cursors->isDragged(); });  // after the cursors' own
  if (keep) figure_->xAxis->setRange(kept);
  if (keepUp) figure_->yAxis->setRange(keptUp);
  connect(figure_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FigureView::rangeChanged);
  for (const QCPAxis* axis : {figure_->xAxis, figure_->yAxis})
    connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FigureView::zoomed);
  connect(figure_, &QWidget::customContextMenuRequested, this, &FigureView::openMenu);
  connect(figure_, &QCustomPlot::mouseDoubleClick, this, [this](const QMouseEvent* event) {
    if (figure_->legendEntryAt(event->pos()) < 0) resetZoom();
  });
  figure_->setAttribute(Qt::WA_TransparentForMouseEvents, shifting_);
  figure_->show();
  if (focused) figure_->setFocus();
}

std::set<QString> FigureView::hiddenCurves() const {
  std::set<QString> hidden;
  if (!figure_) return hidden;
  const QStringList keys = keysOfCurves(*figure_);
  for (int i = 0; i < keys.size(); ++i)
    if (!figure_->curveOfEntry(i)->visible()) hidden.insert(keys[i]);
  return hidden;
}

void FigureView::hideCurves(const std::set<QString>& hidden) {
  const QStringList keys = keysOfCurves(*figure_);
  for (int i = 0; i < keys.size(); ++i)
    if (hidden.contains(keys[i])) figure_->setCurveVisible(*figure_->curveOfEntry(i), false);
}

void FigureView::takeKeys() {
  const auto cursor = [cursors = cursors_] {
    return cursors->isVisible() ? std::optional(cursors->location(cursors->lastMoved())) : std::nullopt;
  };
  auto* keys = new KeyboardZoom(*figure_, {.showAll = [this] { resetZoom(); },
                                           .fixed = cursor,
                                           .more = tr("A and B set two cursors, Control with left and right moves the "
                                                      "one set last, Escape removes them.")});
  // What the cursors say is read out in place of the keys.
  connect(cursors_, &CursorPair::changed, figure_, [figure = figure_, cursors = cursors_, keys] {
    figure->setAccessibleDescription(cursors->isVisible() ? cursors->text() : keys->description());
  });
  connect(cursors_, &CursorPair::toggled, this, [this](bool visible) {
    cursorsVisible_ = visible;
    Q_EMIT cursorsToggled(visible);
  });
  setFocusPolicy(Qt::TabFocus);  // for a moment: without it this has no place in the order of Tab to hand on
  setTabOrder(this, figure_);
  setFocusPolicy(Qt::NoFocus);
}

// The figure is made anew with every step of a drag: the view around it takes the mouse.
void FigureView::setShifting(bool on) {
  shifting_ = on;
  pressed_.reset();
  if (figure_) figure_->setAttribute(Qt::WA_TransparentForMouseEvents, on);
  setCursor(on ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

double FigureView::distance(const QMouseEvent& event) const {
  return figure_->xAxis->pixelToCoord(event.position().x()) - figure_->xAxis->pixelToCoord(*pressed_);
}

void FigureView::mousePressEvent(QMouseEvent* event) {
  if (!shifting_ || !figure_ || event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  pressed_ = event->position().toPoint().x();
}

void FigureView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_ || !figure_) return QWidget::mouseMoveEvent(event);
  Q_EMIT shifted(distance(*event), false);
}

void FigureView::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_ || !figure_) return QWidget::mouseReleaseEvent(event);
  const double moved = distance(*event);
  pressed_.reset();
  Q_EMIT shifted(moved, true);
}

// Zooms while a signal is aligned as well.
void FigureView::wheelEvent(QWheelEvent* event) {
  if (!shifting_ || !figure_) return QWidget::wheelEvent(event);
  QCoreApplication::sendEvent(figure_, event);
}

void FigureView::setCursors(bool visible) {
  cursorsVisible_ = visible;
  if (cursors_) cursors_->setVisible(visible);
}

void FigureView::setRange(const QCPRange& range) {
  if (!figure_ || figure_->xAxis->range() == range) return;
  figure_->xAxis->setRange(range);
  figure_->replot(QCustomPlot::rpQueuedReplot);
}

void FigureView::resetZoom() {
  if (!figure_) return;
  figure_->xAxis->setRange(fullX_);
  figure_->yAxis->setRange(fullY_);
  figure_->replot(QCustomPlot::rpQueuedReplot);
}

void FigureView::forgetZoom() {
  if (!figure_) return;
  fullX_ = figure_->xAxis->range();
  fullY_ = figure_->yAxis->range();
}

bool FigureView::isZoomed() const { return figure_ && figure_->xAxis->range() != fullX_; }

QSize FigureView::printedUnits() const {
  if (!(size_.width > 0)) return figure_->printedUnits();
  return (QSizeF(size_.width, size_.height) * plots::unitsPerMillimetre).toSize();
}

void FigureView::copy() {
  if (!figure_) return;
  QImage picture;
  try {
    picture = plots::toImage(*figure_, size_.resolution, printedUnits());
  } catch (const CaseError& error) {
    return void(Q_EMIT failed(QString::fromStdString(error.what())));
  }
  figure_->replot(QCustomPlot::rpQueuedReplot);  // laid out for the window again
  auto* both = new QMimeData;
  both->setImageData(picture);
  both->setText(QString::fromUtf8(table_.isEmpty() ? figureTable(*figure_) : table_));
  QApplication::clipboard()->setMimeData(both);
}

void FigureView::openMenu(const QPoint& location) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("&Copy"), this, &FigureView::copy);
  menu->addAction(tr("&Export…"), this, &FigureView::askForFile);
  menu->addAction(tr("&Reset zoom"), this, &FigureView::resetZoom);
  menu->popup(figure_->mapToGlobal(location));
}

void FigureView::askForFile() {
  const QString path = locationToSave(this, tr("Export the figure"), name_ + ".png",
                                      tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf);;CSV (*.csv)"));
  if (path.isEmpty()) return;
  try {
    writeFile(path);
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

void FigureView::writeFile(const QString& path) {
  if (!figure_) return;
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == "csv") return plots::writeWhole(table_.isEmpty() ? figureTable(*figure_) : table_, path.toStdString());
  if (ending != "png" && ending != "svg" && ending != "pdf")
    throw FileError(path.toStdString(), "", "is of a kind that figures are not written in",
                    "end its name with .png, .svg, .pdf or .csv");
  plots::writeFigure(*figure_, ending.toStdString(), path.toStdString(), printedUnits(), size_.resolution);
  figure_->replot(QCustomPlot::rpQueuedReplot);  // laid out for the window again
}

}  // namespace squat::studio
