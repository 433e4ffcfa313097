#include "studio/tools/StudyView.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "studio/common/RowTable.h"

namespace squat::studio {

using studies::RunState;

StudyView::StudyView(QWidget* parent)
    : QWidget(parent),
      runs_(new StudyRuns(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      says_(new QLabel(this)),
      open_(new QPushButton(tr("Show the &run"), this)) {
  makeTable();
  says_->setObjectName("studyState");
  open_->setObjectName("studyShowRun");
  open_->setToolTip(tr("Show the chosen run in the main window, beside the other runs"));
  connect(open_, &QPushButton::clicked, this, &StudyView::openChosen);
  auto* row = new QHBoxLayout;
  row->addWidget(says_, 1);
  row->addWidget(open_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addLayout(row);
  showState();
}

// Sorted when a heading is clicked, never because a value has come: nothing moves under the mouse.
void StudyView::makeTable() {
  sorted_->setDynamicSortFilter(false);
  sorted_->setSortRole(StudyRuns::sortRole);
  sorted_->setSourceModel(runs_);
  table_->setModel(sorted_);
  makeRowTable(*table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setObjectName("studyRows");
  table_->setAccessibleName(tr("Runs of the study"));
  table_->installEventFilter(this);
  connect(table_, &QTableView::doubleClicked, this, &StudyView::openChosen);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &StudyView::showState);
  connect(runs_, &QAbstractItemModel::modelReset, this, &StudyView::fitColumns);
  connect(runs_, &QAbstractItemModel::modelReset, this, &StudyView::showState);
}

// Once a study: widths that follow what comes in would move the columns.
void StudyView::fitColumns() {
  constexpr int margin = 14;  // [pixels] both sides together
  auto* heading = table_->horizontalHeader();
  for (int column = 0; column < runs_->columnCount(); ++column) {
    const int values = table_->fontMetrics().horizontalAdvance(runs_->widestText(column)) + margin;
    heading->resizeSection(column, std::max(values, heading->sectionSizeHint(column)));
  }
}

void StudyView::setStudy(const StudyPointer& study) {
  runs_->setStudy(study);
  showState();
}

void StudyView::clear() { runs_->clear(); }

void StudyView::conclude() { runs_->conclude(); }

void StudyView::showState() {
  const int failures = runs_->count(RunState::failed);
  QString text = tr("Press Start: each run gets a row here, filled in when it ends.");
  if (runs_->rowCount() > 0) text = tr("%1 of %2 runs done").arg(runs_->count(RunState::done)).arg(runs_->rowCount());
  if (failures > 0) text += tr(", %1 failed").arg(failures);
  says_->setText(text);
  open_->setEnabled(chosen() >= 0);
}

int StudyView::chosen() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return -1;
  const int row = sorted_->mapToSource(rows.first()).row();
  return runs_->at(row).state == RunState::done ? row : -1;
}

void StudyView::openChosen() {
  if (const int row = chosen(); row >= 0) Q_EMIT runRequested(runs_->at(row).row->point);
}

bool StudyView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      openChosen();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace squat::studio
