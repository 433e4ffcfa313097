#include "studio/window/PaperPanel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "studio/common/Theme.h"
#include "studio/common/Words.h"

namespace squat::studio {

PaperPanel::PaperPanel(RunStore& store, Comparison comparison, QWidget* parent)
    : QWidget(parent), store_(store), comparison_(std::move(comparison)) {
  title_ = new QLabel(this);
  title_->setWordWrap(true);
  title_->setObjectName("paperTitle");
  table_ = new QTableWidget(0, 4, this);
  table_->setTabKeyNavigation(false);  // Tab leaves the table
  table_->setHorizontalHeaderLabels({tr("Quantity"), tr("This run"), tr("Paper"), tr("Verdict")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(3, QHeaderView::ResizeToContents);
  table_->setAlternatingRowColors(true);
  table_->setWordWrap(true);
  table_->setAccessibleName(tr("Summary of the run, and what the paper states"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(table_, 1);
  connect(&store_, &RunStore::currentChanged, this, &PaperPanel::update);
  update();
}

void PaperPanel::update() {
  const ResultPointer result = store_.currentResult();
  table_->setRowCount(0);
  table_->setVisible(result != nullptr && comparison_);
  if (!result || !comparison_) {
    title_->setText(
        tr("Run the case (F5): what it gives stands here, beside what the paper states. Cases of the paper are in "
           "File > Shipped cases."));
    return;
  }
  title_->setText(tr("%1 compared with Molodova et al. (2014)").arg(QString::fromStdString(result->stem)));
  for (const ComparedRow& row : comparison_(*result)) {
    const int at = table_->rowCount();
    table_->insertRow(at);
    const QString cells[] = {row.what, row.ours, row.paper, row.verdict};
    for (int column = 0; column < 4; ++column)
      table_->setItem(at, column, new QTableWidgetItem(printedUnits(cells[column])));
    const bool right = row.verdict == "met" || row.verdict == "passed";
    const bool wrong = row.verdict == "not met" || row.verdict == "failed";
    if (right || wrong) table_->item(at, 3)->setForeground(QColor(right ? rightColour : wrongColour));
  }
}

}  // namespace squat::studio
