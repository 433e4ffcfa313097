#include "studio/comparison/MapWindow.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "analysis/ComparisonTable.h"
#include "core/Errors.h"
#include "studio/common/ButtonKeys.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/Theme.h"
#include "studio/signals/FigureView.h"

namespace squat::studio {
namespace {

constexpr QSize usualSize(1200, 430);

QString nameOf(const StoredRun& run) {
  return QString::fromStdString(project::nameWithGain(run.label.toStdString(), run.reading));
}

}  // namespace

MapWindow::MapWindow(RunStore& store, QWidget* parent)
    : QWidget(parent, Qt::Window),
      store_(store),
      first_(new QComboBox(this)),
      second_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      problem_(new FixedLabel(1, this)) {
  setWindowTitle(tr("Maps side by side"));
  setObjectName("mapWindow");
  problem_->setObjectName("mapProblem");
  auto* maps = new QHBoxLayout;
  for (std::size_t panel = 0; panel < views_.size(); ++panel) {
    views_[panel] = new FigureView(QStringLiteral("map %1").arg(panel + 1), this);
    maps->addWidget(views_[panel], 1);
    connect(views_[panel], &FigureView::failed, this, &MapWindow::say);
  }
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeBar());
  layout->addWidget(problem_);
  layout->addLayout(maps, 1);
  resize(usualSize);
  connect(new QShortcut(QKeySequence::Close, this), &QShortcut::activated, this, &QWidget::hide);
  for (QComboBox* box : {first_, second_, kind_}) connect(box, &QComboBox::activated, this, &MapWindow::take);
  connect(&store_, &RunStore::rowsInserted, this, &MapWindow::listSignals);
  connect(&store_, &RunStore::rowsRemoved, this, &MapWindow::listSignals);
  connect(&store_, &RunStore::modelReset, this, &MapWindow::listSignals);
  connect(&store_, &RunStore::dataChanged, this, &MapWindow::listSignals);
  listSignals();
}

QWidget* MapWindow::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](QComboBox* box, const QString& label, const QString& name) {
    auto* words = new QLabel(label, bar);
    words->setBuddy(box);
    box->setObjectName(name);
    box->setAccessibleName(QString(label).remove('&'));
    box->view()->setAccessibleName(QString(label).remove('&'));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(18);
    row->addWidget(words);
    row->addWidget(box);
  };
  kind_->addItems({tr("Scalogram"), tr("Short-time Fourier transform")});
  add(kind_, tr("&Map"), "mapKind");
  add(first_, tr("&Signal"), "mapFirst");
  add(second_, tr("&Beside"), "mapSecond");
  row->addStretch(1);
  export_ = new QPushButton(tr("Export maps…"), bar);
  export_->setObjectName("exportMaps");
  export_->setToolTip(tr("Write all three maps into one file: PNG, SVG or PDF"));
  row->addWidget(export_);
  connect(export_, &QPushButton::clicked, this, &MapWindow::askForFile);
  giveKeys(*bar, {{"exportMaps", "Ctrl+Shift+E"}});
  return bar;
}

// A list that changes keeps what is chosen as long as it is there.
void MapWindow::listSignals() {
  for (QComboBox* box : {first_, second_}) {
    box->clear();
    for (int row = 0; row < store_.rowCount(); ++row)
      if (!store_.at(row).isMissing() && store_.at(row).record) box->addItem(store_.at(row).label, row);
  }
  first_->setCurrentIndex(first_->findData(firstIndex_.row()));
  second_->setCurrentIndex(second_->findData(secondIndex_.row()));
  draw();
}

void MapWindow::take() {
  const auto indexOf = [this](const QComboBox& box) {
    return box.currentIndex() < 0 ? QModelIndex() : store_.index(box.currentData().toInt());
  };
  firstIndex_ = indexOf(*first_);
  secondIndex_ = indexOf(*second_);
  draw();
}

void MapWindow::choose(int first, int second) {
  first_->setCurrentIndex(first_->findData(first));
  second_->setCurrentIndex(second_->findData(second));
  take();
}

MapWindow::Shown MapWindow::wanted() const {
  if (first_->currentIndex() < 0 || second_->currentIndex() < 0) return {};
  const StoredRun &first = store_.at(firstIndex_.row()), &second = store_.at(secondIndex_.row());
  return {first.record,   second.record,         nameOf(first),
          nameOf(second), kind_->currentIndex(), palette().base().color().lightness() < 128};
}

QString MapWindow::problem() const {
  if (store_.rowCount() < 2) return tr("Two signals are needed: run a case or overlay a measured signal.");
  if (first_->currentIndex() < 0 || second_->currentIndex() < 0)
    return tr("Choose two signals. Those that are still being read, or whose file is missing, are not listed.");
  return {};
}

// Throws CaseError, FileError and SignalError.
plots::FigureSheet MapWindow::sheetFor(const plots::Style& style) const {
  const Shown shown = wanted();
  auto comparison = analysis::recordComparison(*shown.first, *shown.second);
  comparison.firstName = shown.firstName.toStdString();
  comparison.secondName = shown.secondName.toStdString();
  return plots::mapComparison(comparison, static_cast<plots::MapKind>(shown.kind), "maps", style);
}

void MapWindow::say(const QString& problem) { problem_->warn(problem); }

void MapWindow::draw() {
  if (!isVisible()) return;
  export_->setEnabled(false);
  if (const QString reason = problem(); !reason.isEmpty()) return stop(reason);
  if (store_.at(firstIndex_.row()).dragged || store_.at(secondIndex_.row()).dragged)
    return;  // drawn when the drag ends
  export_->setEnabled(true);
  const Shown now = wanted();
  if (now == shown_) return;
  shown_ = now;
  say({});
  try {
    auto sheet = sheetFor(figureStyle(now.dark));
    for (std::size_t panel = 0; panel < views_.size(); ++panel) {
      const bool inTime = sheet.panels[panel]->xAxis->label().contains("[ms]");
      views_[panel]->setPrintedSize(storedFigureSize());
      views_[panel]->show(std::move(sheet.panels[panel]), inTime ? 1e-3 : 0, inTime ? "ms" : "mm");
      views_[panel]->setEnabled(true);
    }
  } catch (const std::exception& error) {
    stop(QString::fromStdString(error.what()));
  }
}

// The maps that still stand are of other signals: greyed, and not exported.
void MapWindow::stop(const QString& reason) {
  shown_ = {};
  export_->setEnabled(false);
  for (FigureView* view : views_) view->setEnabled(false);
  say(reason);
}

void MapWindow::writeFile(const QString& path) const {
  if (const QString reason = problem(); !reason.isEmpty())
    throw FileError(path.toStdString(), "", reason.toStdString());
  const QFileInfo file(path);
  const auto size = storedFigureSize();
  auto sheet = sheetFor(plots::lightStyle());
  sheet.name = file.completeBaseName().toStdString();
  for (const auto& panel : sheet.panels)
    if (size.width > 0) panel->setPrintedSize({size.width, size.height});
  plots::writeSheet(sheet, file.path().toStdString(), {file.suffix().toLower().toStdString()}, size.resolution);
}

void MapWindow::askForFile() {
  const QString path =
      locationToSave(this, tr("Export the maps"), "maps.png", tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"));
  if (path.isEmpty()) return;
  try {
    writeFile(path);
  } catch (const std::exception& error) {
    say(QString::fromStdString(error.what()));
  }
}

void MapWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) draw();
  if (event->type() == QEvent::ActivationChange)  // another size may have been chosen in the main window
    for (FigureView* view : views_) view->setPrintedSize(storedFigureSize());
}

void MapWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw();
}

}  // namespace squat::studio
