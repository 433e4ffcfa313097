#include "studio/FigureView.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "core/Errors.h"
#include "plots/FigureFiles.h"
#include "studio/CursorPair.h"

namespace squat::studio {

FigureView::FigureView(const QString& name, QWidget* parent) : QWidget(parent), name_(name) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  setObjectName("view " + name);
  setMinimumSize(200, 140);
}

void FigureView::show(std::unique_ptr<plots::Figure> figure, double secondsPerUnit, const QString& unit) {
  const bool keep = figure_ && figure_->xAxis->label() == figure->xAxis->label() && figure_->xAxis->range() != fullX_;
  const QCPRange kept = keep ? figure_->xAxis->range() : QCPRange();
  delete figure_;
  figure_ = figure.release();
  figure_->setParent(this);
  layout()->addWidget(figure_);
  fullX_ = figure_->xAxis->range();
  fullY_ = figure_->yAxis->range();
  figure_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  figure_->setContextMenuPolicy(Qt::CustomContextMenu);
  figure_->setAccessibleName(tr("Figure %1").arg(name_));
  figure_->setFocusPolicy(Qt::ClickFocus);
  // Opposite axes follow, so that zooming moves all four.
  connect(figure_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), figure_->xAxis2,
          qOverload<const QCPRange&>(&QCPAxis::setRange));
  connect(figure_->yAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), figure_->yAxis2,
          qOverload<const QCPRange&>(&QCPAxis::setRange));
  cursors_ = new CursorPair(*figure_, secondsPerUnit, unit);
  cursors_->setVisible(cursorsVisible_);
  if (keep) figure_->xAxis->setRange(kept);
  connect(figure_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FigureView::rangeChanged);
  connect(figure_, &QWidget::customContextMenuRequested, this, &FigureView::openMenu);
  connect(figure_, &QCustomPlot::mouseDoubleClick, this, &FigureView::resetZoom);
  figure_->show();
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

void FigureView::openMenu(const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("&Copy picture"), this, [this] {
    QApplication::clipboard()->setImage(plots::toImage(*figure_, plots::printResolution, figure_->size()));
  });
  menu->addAction(tr("&Export…"), this, &FigureView::askForFile);
  menu->addAction(tr("&Reset zoom"), this, &FigureView::resetZoom);
  menu->popup(figure_->mapToGlobal(place));
}

void FigureView::askForFile() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Export the figure"), name_ + ".png",
                                                    tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf);;CSV (*.csv)"));
  if (path.isEmpty()) return;
  try {
    writeFile(path);
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

void FigureView::writeFile(const QString& path) {
  if (!figure_) return;
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == "csv") return plots::writeWhole(curvesAsTable(), path.toStdString());
  plots::writeFigure(*figure_, ending.toStdString(), path.toStdString(), figure_->size());
}

// Curves one below the other: name, x, y. They need not share their x.
QByteArray FigureView::curvesAsTable() const {
  QByteArray text = "curve," + figure_->xAxis->label().toUtf8() + "," + figure_->yAxis->label().toUtf8() + "\n";
  for (int i = 0; i < figure_->graphCount(); ++i) {
    QString name = figure_->graph(i)->name();
    name.replace('"', '\'');
    for (const QCPGraphData& point : *figure_->graph(i)->data())
      text += '"' + name.toUtf8() + "\"," + QByteArray::number(point.key, 'g', 12) + ',' +
              QByteArray::number(point.value, 'g', 12) + '\n';
  }
  return text;
}

}  // namespace squat::studio
