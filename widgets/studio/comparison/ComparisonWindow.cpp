#include "studio/comparison/ComparisonWindow.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "studio/common/ButtonKeys.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/RowTable.h"
#include "studio/comparison/ComparisonModel.h"
#include "studio/comparison/MapWindow.h"
#include "studio/runs/ColourSquare.h"

namespace squat::studio {
namespace {

constexpr QSize usualWindowSize(1080, 380);

}  // namespace

ComparisonWindow::ComparisonWindow(RunStore& store, QWidget* parent)
    : QWidget(parent, Qt::Window),
      store_(store),
      model_(new ComparisonModel(store, this)),
      seen_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      reference_(new QComboBox(this)),
      problem_(new FixedLabel(1, this)) {
  setWindowTitle(tr("Comparison"));
  setObjectName("comparisonWindow");
  makeTable();
  problem_->setObjectName("comparisonProblem");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeBar());
  layout->addWidget(problem_);
  layout->addWidget(table_, 1);
  resize(usualWindowSize);
  restoreGeometry(QSettings().value("comparison").toByteArray());
  connect(new QShortcut(QKeySequence::Copy, this), &QShortcut::activated, this, &ComparisonWindow::copy);
  connect(new QShortcut(QKeySequence::Close, this), &QShortcut::activated, this, &QWidget::hide);
  connect(reference_, &QComboBox::activated, this,
          [this](int at) { store_.setReference(reference_->itemData(at).toInt()); });
  connect(&store_, &RunStore::rowsInserted, this, &ComparisonWindow::listReferences);
  connect(&store_, &RunStore::rowsRemoved, this, &ComparisonWindow::listReferences);
  connect(&store_, &RunStore::modelReset, this, &ComparisonWindow::listReferences);
  connect(&store_, &RunStore::dataChanged, this, &ComparisonWindow::listReferences);
  connect(&store_, &RunStore::referenceChanged, this, &ComparisonWindow::listReferences);
  listReferences();
}

void ComparisonWindow::makeTable() {
  seen_->setSourceModel(model_);
  seen_->setSortRole(ComparisonModel::sortRole);
  table_->setModel(seen_);
  makeRowTable(*table_);
  table_->setObjectName("comparison");
  table_->setAccessibleName(tr("Comparison of runs and measured signals"));
  table_->setItemDelegate(new ColourSquare(table_));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setAlternatingRowColors(true);
  connect(table_, &QWidget::customContextMenuRequested, this, &ComparisonWindow::showMenu);
}

QWidget* ComparisonWindow::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("Reference:"), bar);
  label->setBuddy(reference_);
  reference_->setObjectName("reference");
  reference_->setAccessibleName(tr("Reference of correlation and peak ratio"));
  reference_->view()->setAccessibleName(tr("Signals to compare with"));
  reference_->setToolTip(tr("Correlation and peak ratio (signal / reference) are those with this signal"));
  reference_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  row->addWidget(label);
  row->addWidget(reference_);
  row->addStretch(1);
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, bar);
    made->setObjectName(text);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    row->addWidget(made);
    connect(made, &QPushButton::clicked, this, action);
  };
  button(tr("Copy table"), tr("Copy the table, tab-separated"), &ComparisonWindow::copy);
  button(tr("Export CSV…"), tr("Export the table as CSV, with every digit"), &ComparisonWindow::askForFile);
  button(tr("Maps…"), tr("Show the scalograms of the chosen signal and the reference side by side"),
         &ComparisonWindow::showMaps);
  giveKeys(*bar, {{tr("Maps…"), "Ctrl+Alt+M"}, {tr("Copy table"), "Ctrl+Alt+C"}, {tr("Export CSV…"), "Ctrl+Alt+X"}});
  return bar;
}

// Without a choice, the first signal that is not the reference.
void ComparisonWindow::showMaps() {
  if (!maps_) maps_ = new MapWindow(store_, this);
  const QModelIndex chosen = table_->currentIndex();
  int row = chosen.isValid() ? seen_->mapToSource(chosen).row() : 0;
  if (row == store_.reference() && store_.rowCount() > 1) row = row == 0 ? 1 : 0;
  maps_->show();
  maps_->choose(row, store_.reference());
  maps_->raise();
  maps_->activateWindow();
}

bool ComparisonWindow::isBusy() const { return model_->isBusy(); }

void ComparisonWindow::listReferences() {
  reference_->clear();
  for (int row = 0; row < store_.rowCount(); ++row)
    if (!store_.at(row).isMissing()) reference_->addItem(store_.at(row).label, row);
  reference_->setCurrentIndex(reference_->findData(store_.reference()));
  reference_->setEnabled(reference_->count() > 0);
}

std::vector<int> ComparisonWindow::shownRows() const {
  std::vector<int> rows;
  for (int row = 0; row < seen_->rowCount(); ++row) rows.push_back(seen_->mapToSource(seen_->index(row, 0)).row());
  return rows;
}

void ComparisonWindow::copy() const {
  QApplication::clipboard()->setText(QString::fromStdString(analysis::tabbedText(model_->table(shownRows()))));
}

void ComparisonWindow::writeCsv(const QString& path) const {
  writeDurably(path.toStdString(), analysis::tableCsv(model_->table(shownRows())));
}

void ComparisonWindow::askForFile() {
  const QString path = locationToSave(this, tr("Export the comparison"), "comparison.csv", tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  problem_->clear();
  try {
    writeCsv(path);
  } catch (const FileError& error) {
    problem_->warn(QString::fromStdString(error.what()));
  }
}

void ComparisonWindow::showMenu(const QPoint& place) {
  const QModelIndex index = table_->indexAt(place);
  if (!index.isValid()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fillMenu(*menu, seen_->mapToSource(index).row());
  menu->popup(table_->viewport()->mapToGlobal(place));
}

// Rows may move while the menu stands: the run itself is what is meant.
void ComparisonWindow::fillMenu(QMenu& menu, int row) {
  if (row < 0 || row >= store_.rowCount()) return;
  const StoredRun& run = store_.at(row);
  const auto place = [index = QPersistentModelIndex(store_.index(row))] { return index.row(); };  // -1: removed
  QAction* chosen = menu.addAction(tr("Use as &reference"), this, [this, place] { store_.setReference(place()); });
  chosen->setObjectName("useAsReference");
  chosen->setEnabled(!run.isMissing() && row != store_.reference());
  QAction* shown = menu.addAction(tr("&Show in the figures"), this, [this, place] {
    if (const int at = place(); at >= 0) store_.setCurrent(at);
  });
  shown->setObjectName("showRun");
  shown->setEnabled(!run.isMeasured());
  menu.addSeparator();
  menu.addAction(tr("&Copy table"), this, &ComparisonWindow::copy);
}

void ComparisonWindow::showEvent(QShowEvent* event) {
  model_->setSeen(true);
  QWidget::showEvent(event);
}

void ComparisonWindow::hideEvent(QHideEvent* event) {
  model_->setSeen(false);
  QSettings().setValue("comparison", saveGeometry());
  QWidget::hideEvent(event);
}

}  // namespace squat::studio
