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
#include "plots/MapComparison.h"
#include "studio/common/ButtonKeys.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/Theme.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/FigureView.h"

namespace squat::studio {
namespace {

constexpr QSize usualSize(1200, 430);

// Throws CaseError, FileError and SignalError.
plots::FigureSheet sheetFor(const StoredRun& first, const StoredRun& second, plots::MapKind kind,
                            const plots::Style& style) {
  auto comparison = analysis::recordComparison(*first.record, *second.record);
  comparison.firstName = first.label.toStdString();
  comparison.secondName = second.label.toStdString();
  return plots::mapComparison(comparison, kind, "maps", style);
}

}  // namespace

MapWindow::MapWindow(RunStore& store, QWidget* parent)
    : QWidget(parent, Qt::Window),
      store_(store),
      first_(new QComboBox(this)),
      second_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      problem_(new QLabel(this)) {
  setWindowTitle(tr("Maps side by side"));
  setObjectName("mapWindow");
  problem_->setObjectName("mapProblem");
  problem_->setWordWrap(true);
  problem_->setStyleSheet(QStringLiteral("color: %1;").arg(wrongColour));
  problem_->hide();
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
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::hide);
  for (QComboBox* box : {first_, second_, kind_}) connect(box, &QComboBox::activated, this, &MapWindow::draw);
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
  add(second_, tr("&beside"), "mapSecond");
  row->addStretch(1);
  auto* button = new QPushButton(tr("Export maps…"), bar);
  button->setObjectName("exportMaps");
  button->setToolTip(tr("Write all three maps into one file: PNG, SVG or PDF"));
  row->addWidget(button);
  connect(button, &QPushButton::clicked, this, &MapWindow::askForFile);
  giveKeys(*bar, {{"exportMaps", "Ctrl+Shift+E"}});
  return bar;
}

// A list that changes keeps what is chosen as long as it is there.
void MapWindow::listSignals() {
  const QVariant first = first_->currentData(), second = second_->currentData();
  for (QComboBox* box : {first_, second_}) {
    box->clear();
    for (int row = 0; row < store_.rowCount(); ++row)
      if (!store_.at(row).isMissing() && store_.at(row).record) box->addItem(store_.at(row).label, row);
  }
  first_->setCurrentIndex(std::max(0, first_->findData(first)));
  second_->setCurrentIndex(std::max(0, second_->findData(second)));
  draw();
}

void MapWindow::choose(int first, int second) {
  first_->setCurrentIndex(first_->findData(first));
  second_->setCurrentIndex(second_->findData(second));
  draw();
}

void MapWindow::say(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

void MapWindow::draw() {
  if (!isVisible()) return;
  say({});
  try {
    if (first_->currentIndex() < 0 || second_->currentIndex() < 0) return say(tr("There are no signals yet."));
    auto sheet = sheetFor(store_.at(first_->currentData().toInt()), store_.at(second_->currentData().toInt()),
                          static_cast<plots::MapKind>(kind_->currentIndex()),
                          figureStyle(palette().base().color().lightness() < 128));
    for (std::size_t panel = 0; panel < views_.size(); ++panel)
      views_[panel]->show(std::move(sheet.panels[panel]), 0, "mm");
  } catch (const std::exception& error) {
    say(QString::fromStdString(error.what()));
  }
}

void MapWindow::writeFile(const QString& path) const {
  const QFileInfo file(path);
  auto sheet = sheetFor(store_.at(first_->currentData().toInt()), store_.at(second_->currentData().toInt()),
                        static_cast<plots::MapKind>(kind_->currentIndex()), plots::lightStyle());
  sheet.name = file.completeBaseName().toStdString();
  plots::writeSheet(sheet, file.path().toStdString(), {file.suffix().toLower().toStdString()});
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
}

void MapWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw();
}

}  // namespace squat::studio
