#include "studio/runs/RunsPanel.h"

#include <QAbstractItemView>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "studio/common/ButtonKeys.h"
#include "studio/common/EditorHabits.h"
#include "studio/common/RowTable.h"
#include "studio/runs/ColourSquare.h"
#include "studio/runs/GroupedRows.h"
#include "studio/runs/RunStore.h"
#include "studio/runs/RunTable.h"

namespace squat::studio {

RunsPanel::RunsPanel(RunStore& store, QWidget* parent)
    : QWidget(parent),
      store_(store),
      seen_(new QSortFilterProxyModel(this)),
      groups_(nullptr),
      filter_(new QLineEdit(this)),
      groupBy_(new QComboBox(this)),
      table_(new QTableView(this)) {
  makeTable();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(makeChoices());
  layout->addWidget(table_, 1);
  layout->addWidget(makeButtons());
  leaveUndoToWindow(*this);
  connectTable();
}

void RunsPanel::makeTable() {
  seen_->setSourceModel(new RunTable(store_, this));
  seen_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  seen_->setFilterKeyColumn(-1);  // every column
  seen_->setSortRole(RunTable::sortRole);
  groups_ = new GroupedRows(*seen_, this);
  table_->setModel(groups_);
  makeRowTable(*table_);
  table_->setAccessibleName(tr("Runs"));
  table_->setObjectName("runs");
  table_->setMinimumHeight(70);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setItemDelegate(new ColourSquare(table_));
  table_->installEventFilter(this);
  table_->viewport()->installEventFilter(this);
}

QWidget* RunsPanel::makeChoices() {
  auto* bar = new QWidget(this);
  auto* choices = new QHBoxLayout(bar);
  choices->setContentsMargins(0, 0, 0, 0);
  filter_->setObjectName("runFilter");
  filter_->setPlaceholderText(tr("Filter runs"));
  filter_->setAccessibleName(tr("Filter runs by name or value"));
  filter_->setClearButtonEnabled(true);
  connect(filter_, &QLineEdit::textChanged, seen_, &QSortFilterProxyModel::setFilterFixedString);
  connect(filter_, &QLineEdit::textChanged, this, &RunsPanel::orderChanged);
  groupBy_->setObjectName("runGroups");
  groupBy_->setToolTip(tr("Group runs by what differs between them"));
  groupBy_->setAccessibleName(groupBy_->toolTip());
  groupBy_->view()->setAccessibleName(groupBy_->toolTip());
  groupBy_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  listGroupings();
  connect(groupBy_, &QComboBox::activated, this, [this] {
    groups_->groupBy(groupBy_->currentData().toString());
    Q_EMIT orderChanged();
  });
  choices->addWidget(filter_, 1);
  choices->addWidget(groupBy_);
  return bar;
}

// Columns come and go with the runs, and so do the ways to group these.
void RunsPanel::listGroupings() {
  groupBy_->clear();
  groupBy_->addItem(tr("No groups"));
  for (int column = 0; column < groups_->columnCount(); ++column) {
    const QString key = groups_->headerData(column, Qt::Horizontal, GroupedRows::columnKeyRole).toString();
    if (key.isEmpty()) continue;
    const QString heading = groups_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    groupBy_->addItem(tr("Groups: %1").arg(heading.section('\n', 0, 0)), key);
    if (key == groups_->key()) groupBy_->setCurrentIndex(groupBy_->count() - 1);
  }
}

// While the files of a project are read, what differs between its runs, and so a column, may still have to come.
void RunsPanel::sortAsChosen() {
  arranging_ = true;
  sortBy(*table_, sortedBy_, descending_);
  arranging_ = false;
}

project::TableOrder RunsPanel::order() const {
  return {sortedBy_.toStdString(), descending_, groups_->key().toStdString(), filter_->text().toStdString()};
}

void RunsPanel::setOrder(const project::TableOrder& order) {
  sortedBy_ = QString::fromStdString(order.sort), descending_ = order.descending;
  sortAsChosen();
  groups_->groupBy(QString::fromStdString(order.group));
  listGroupings();
  filter_->setText(QString::fromStdString(order.filter));
}

// The heading of a group is as wide as the table.
void RunsPanel::spanHeadings() {
  table_->clearSpans();
  for (int row = 0; row < groups_->rowCount(); ++row)
    if (groups_->isHeading(groups_->index(row, 0))) table_->setSpan(row, 0, 1, groups_->columnCount());
}

bool RunsPanel::takesKey(const QModelIndex& heading, int key) {
  const bool open = groups_->isOpen(heading);
  if (key == Qt::Key_Left || key == Qt::Key_Right)
    groups_->setOpen(heading, key == Qt::Key_Right);
  else if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space)
    groups_->setOpen(heading, !open);
  else
    return false;
  return true;
}

QWidget* RunsPanel::makeButtons() {
  auto* bar = new QWidget(this);
  auto* buttons = new QHBoxLayout(bar);
  buttons->setContentsMargins(0, 0, 0, 0);
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, bar);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setObjectName(text);
    buttons->addWidget(made);
    connect(made, &QPushButton::clicked, this, action);
  };
  button(tr("Open…"), tr("Open a result"), &RunsPanel::openRequested);
  button(tr("Save…"), tr("Save the current result"), &RunsPanel::saveRequested);
  button(tr("Overlay…"), tr("Overlay measured signal"), &RunsPanel::measuredRequested);
  button(tr("Compare"), tr("Compare runs and measured signals in a table"), &RunsPanel::compareRequested);
  button(tr("Remove"), tr("Remove the selected run from the list"), [this] {
    if (const int row = rowOf(table_->currentIndex()); row >= 0) Q_EMIT removeRequested(row);
  });
  giveKeys(*bar, {{tr("Open…"), "Ctrl+Shift+O"}, {tr("Remove"), "Ctrl+Delete"}});  // the others stand in a menu
  return bar;
}

void RunsPanel::connectTable() {
  // A click on the box overlays the run; it does not make it the current one.
  connect(table_, &QTableView::pressed, this, [this] { ticked_ = false; });
  connect(&store_, &RunStore::overlaysChanged, this, [this] { ticked_ = true; });
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (groups_->isHeading(index))
      groups_->setOpen(index, !groups_->isOpen(index));
    else if (!ticked_)
      makeCurrent(index);
  });
  connect(table_, &QTableView::activated, this, &RunsPanel::makeCurrent);  // by keyboard
  connect(table_, &QTableView::customContextMenuRequested, this, [this](const QPoint& place) {
    const int row = rowOf(table_->indexAt(place));
    if (row < 0) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu, row);
    menu->popup(table_->viewport()->mapToGlobal(place));
  });
  const auto mark = [this] { table_->setCurrentIndex(indexOf(store_.current())); };
  connect(&store_, &RunStore::currentChanged, this, [this, mark] {
    groups_->reveal(seenIndexOf(store_.current()));
    mark();
  });
  connect(groups_, &GroupedRows::modelReset, this, &RunsPanel::sortAsChosen);
  connect(table_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, [this] {
    if (arranging_) return;
    sortedBy_ = sortedColumn(*table_), descending_ = !sortedBy_.isEmpty() && isDescending(*table_);
    Q_EMIT orderChanged();
  });
  connect(groups_, &GroupedRows::modelReset, this, mark);
  connect(groups_, &GroupedRows::modelReset, this, &RunsPanel::listGroupings);
  connect(groups_, &GroupedRows::modelReset, this, &RunsPanel::spanHeadings);
  connect(groups_, &GroupedRows::layoutChanged, this, &RunsPanel::spanHeadings);
  for (const auto signal : {&RunStore::currentChanged, &RunStore::overlaysChanged, &RunStore::namesChanged})
    connect(&store_, signal, this, &RunsPanel::fitNames, Qt::QueuedConnection);
}

// The numbers are seen whole; names take what is left, and are cut where that is too little.
void RunsPanel::fitNames() {
  QHeaderView* heading = table_->horizontalHeader();
  if (heading->count() == 0) return;
  constexpr int minimumLetters = 18;
  const int minimum = table_->fontMetrics().averageCharWidth() * minimumLetters + 2 * table_->iconSize().width();
  int others = 0;
  for (int column = 1; column < heading->count(); ++column) others += heading->sectionSize(column);
  heading->setSectionResizeMode(0, QHeaderView::Fixed);
  heading->resizeSection(0, std::max(minimum, table_->viewport()->width() - others));
}

bool RunsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fitNames();
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const QModelIndex at = table_->currentIndex();
    if (groups_->isHeading(at) && takesKey(at, key.key())) return true;
    if (const int row = rowOf(at); row >= 0 && key.key() == Qt::Key_Delete && key.modifiers() == Qt::NoModifier) {
      Q_EMIT removeRequested(row);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

QModelIndex RunsPanel::seenIndexOf(int row) const {
  return row < 0 ? QModelIndex() : seen_->mapFromSource(seen_->sourceModel()->index(row, 0));
}

QModelIndex RunsPanel::indexOf(int row) const { return groups_->mapFromSource(seenIndexOf(row)); }

int RunsPanel::rowOf(const QModelIndex& index) const {
  const QModelIndex seen = groups_->mapToSource(index);
  return seen.isValid() ? seen_->mapToSource(seen).row() : -1;
}

void RunsPanel::makeCurrent(const QModelIndex& index) {
  const int row = rowOf(index);
  if (row >= 0 && !store_.at(row).isMeasured()) store_.setCurrent(row);
}

void RunsPanel::chooseColour(int row) {
  auto* dialog = new QColorDialog(store_.at(row).colour, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this, [this, record = store_.at(row).record](const QColor& colour) {
    if (const int at = store_.rowOfRecord(record); at >= 0) store_.setColour(at, colour);
  });
  dialog->open();
}

// Rows may move while the menu stands: the run itself is what is meant.
void RunsPanel::fillMenu(QMenu& menu, int row) {
  const StoredRun& run = store_.at(row);
  const auto place = [index = QPersistentModelIndex(store_.index(row))] { return index.row(); };  // -1: removed
  const auto add = [&](const QString& text, const char* name, bool enabled, auto action) {
    QAction* made = menu.addAction(text, this, [place, action] {
      if (const int at = place(); at >= 0) action(at);
    });
    made->setObjectName(name);
    made->setEnabled(enabled);
    return made;
  };
  add(tr("&Show"), "runShow", !run.isMeasured(), [this](int at) { store_.setCurrent(at); });
  QAction* overlaid = add(tr("&Overlay"), "runOverlay", !run.isMissing(), [this](int at) {
    store_.setData(store_.index(at), store_.at(at).overlaid ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
  });
  overlaid->setCheckable(true);
  overlaid->setChecked(run.overlaid);
  if (run.isMeasured() && !run.isMissing()) {
    add(tr("A&lign by hand…"), "runAlign", true, [this](int at) { Q_EMIT alignRequested(at); });
    add(tr("Colu&mns…"), "runColumns", true, [this](int at) { Q_EMIT columnsRequested(at); });
  }
  const bool hasCase = run.result && run.result->resolvedCase;
  add(tr("Op&en its case"), "runCase", hasCase, [this](int at) { Q_EMIT caseRequested(at); });
  menu.addSeparator();
  add(tr("&Colour…"), "runColour", true, [this](int at) { chooseColour(at); });
  add(tr("A&utomatic colour"), "runColourAnew", run.colour.isValid(), [this](int at) { store_.setColour(at, {}); });
  menu.addSeparator();
  add(tr("Re&name\tF2"), "runRename", true, [this](int at) { table_->edit(indexOf(at)); });
  add(tr("Au&tomatic name"), "runNameAnew", run.named && !run.isMeasured(),
      [this](int at) { store_.rename(at, QString()); });
  menu.addSeparator();
  add(tr("S&ave…"), "runSave", !run.isMeasured(), [this](int at) { Q_EMIT saveRunRequested(at); });
  add(tr("Show in &folder"), "runFolder", !run.path.isEmpty(),
      [this](int at) { Q_EMIT folderRequested(QFileInfo(store_.at(at).path).absolutePath()); });
  if (run.isMissing() && !run.opening)
    add(tr("F&ind the file…"), "runFind", true, [this](int at) { Q_EMIT findRequested(at); });
  add(tr("&Remove"), "runRemove", true, [this](int at) { Q_EMIT removeRequested(at); });
}

}  // namespace squat::studio
