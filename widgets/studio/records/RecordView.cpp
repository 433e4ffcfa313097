#include "studio/records/RecordView.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "records/RecordStream.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/RowTable.h"
#include "studio/records/EventInspector.h"
#include "studio/records/RecordReading.h"

namespace squat::studio {
namespace {

// The last column is chosen from a list.
class LabelDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* box = new QComboBox(parent);
    box->setAccessibleName(QObject::tr("Label"));
    box->addItems(EventModel::labels());
    return box;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    qobject_cast<QComboBox*>(editor)->setCurrentText(index.data().toString());
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    model->setData(index, qobject_cast<QComboBox*>(editor)->currentText());
  }
};

// A later file of a ride that is gone does not hide those before it; the first one must be there.
std::vector<std::string> filesThere(const project::LongRecords& kept) {
  auto files = records::inNumberOrder(kept.files);
  const auto isGone = [](const std::string& file) { return !QFileInfo::exists(QString::fromStdString(file)); };
  files.erase(std::remove_if(files.begin() + 1, files.end(), isGone), files.end());
  return files;
}

}  // namespace

RecordView::RecordView(const plots::Style& style, QWidget* parent)
    : QWidget(parent),
      strip_(new RecordStrip(style, this)),
      model_(new EventModel(this)),
      seen_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      inspector_(new EventInspector(style, this)),
      channel_(new QComboBox(this)),
      filter_(new QLineEdit(this)),
      show_(new QPushButton(tr("Show in the fi&gures"), this)),
      estimate_(new QPushButton(tr("&Estimate its profile…"), this)),
      labels_(new QPushButton(tr("Save &labels…"), this)),
      undo_(new QAction(this)),
      redo_(new QAction(this)) {
  setObjectName("recordView");
  makeTable();
  makeUndo();
  auto* parts = new QSplitter(Qt::Vertical, this);
  auto* events = new QSplitter(Qt::Horizontal, parts);
  events->addWidget(table_);
  events->addWidget(inspector_);
  events->setChildrenCollapsible(true);
  events->setStretchFactor(0, 1);
  events->setStretchFactor(1, 1);
  events->setSizes({500, 600});
  parts->addWidget(strip_);
  parts->addWidget(events);
  parts->setStretchFactor(0, 2);
  parts->setStretchFactor(1, 3);
  parts->setSizes({190, 260});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(makeBar());
  layout->addWidget(parts, 1);
  connect(strip_, &RecordStrip::sampleRequested, this, &RecordView::sampleRequested);
  connect(strip_, &RecordStrip::channelsChanged, this, [this] {
    channel_->clear();
    channel_->addItems(strip_->channels());
    channel_->setCurrentText(strip_->channel());
  });
  connect(channel_, &QComboBox::textActivated, strip_, &RecordStrip::setChannel);
  connect(strip_, &RecordStrip::eventPicked, this,
          [this](int event) { table_->setCurrentIndex(seen_->mapFromSource(model_->index(event, 0))); });
  strip_->setEventKeys([this](int key) { return table_->isEnabled() && takesKey(key); });
  connect(model_, &QAbstractItemModel::dataChanged, this, &RecordView::changed);
  connect(model_, &QAbstractItemModel::modelReset, this, &RecordView::showChosen);
  thread_.setMaxThreadCount(1);
  enableButtons();
}

RecordView::~RecordView() {
  ++generation_;
  thread_.clear();
  thread_.waitForDone();
}

void RecordView::makeTable() {
  seen_->setSourceModel(model_);
  seen_->setSortRole(EventModel::sortRole);
  seen_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  seen_->setFilterKeyColumn(-1);
  table_->setModel(seen_);
  makeRowTable(*table_);
  table_->setObjectName("events");
  table_->setAccessibleName(tr("Events of the record"));
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  table_->setItemDelegateForColumn(EventModel::seen, new LabelDelegate(table_));
  table_->setToolTip(
      tr("N goes to the next event, P to the one before; 1 to 8 set the label, 0 takes it off;\n"
         "Ctrl+Z undoes the last label"));
  table_->installEventFilter(this);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QTableView::customContextMenuRequested, this, &RecordView::openMenu);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &RecordView::showChosen);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.column() != EventModel::seen) show_->click();
  });
  connect(model_, &QAbstractItemModel::dataChanged, this, &RecordView::enableButtons);
  connect(table_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &RecordView::changed);
}

// Keys of the window that this view stands in: the case is undone in the main window.
void RecordView::makeUndo() {
  QUndoStack& stack = model_->undoStack();
  undo_->setObjectName("undoLabel");
  undo_->setShortcut(QKeySequence::Undo);
  redo_->setObjectName("redoLabel");
  redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  addActions({undo_, redo_});
  connect(undo_, &QAction::triggered, &stack, &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &stack, &QUndoStack::redo);
  connect(&stack, &QUndoStack::indexChanged, this, &RecordView::enableButtons);
  connect(model_, &EventModel::labelStepped, this, &RecordView::choose);
}

QWidget* RecordView::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("C&hannel:"), bar);
  label->setBuddy(channel_);
  channel_->setObjectName("recordChannel");
  channel_->setAccessibleName(tr("Channel that is drawn"));
  channel_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  filter_->setObjectName("eventFilter");
  filter_->setPlaceholderText(tr("Filter events"));
  filter_->setAccessibleName(tr("Filter events by kind, severity or value"));
  filter_->setClearButtonEnabled(true);
  connect(filter_, &QLineEdit::textChanged, seen_, &QSortFilterProxyModel::setFilterFixedString);
  connect(filter_, &QLineEdit::textChanged, this, &RecordView::changed);
  show_->setObjectName("showEvent");
  show_->setToolTip(tr("Overlay the signal around the chosen event on the runs"));
  estimate_->setObjectName("estimateEvent");
  estimate_->setToolTip(tr("Look for the profile that explains the signal over the chosen event"));
  labels_->setObjectName("saveLabels");
  labels_->setToolTip(tr("Save the labels of events: the next search takes them as examples"));
  row->addWidget(label);
  row->addWidget(channel_);
  row->addWidget(filter_, 1);
  row->addWidget(show_);
  row->addWidget(estimate_);
  row->addWidget(labels_);
  connect(show_, &QPushButton::clicked, this, [this] {
    if (const QString file = passageOfChosen(); !file.isEmpty()) Q_EMIT passageRequested(file);
  });
  connect(estimate_, &QPushButton::clicked, this, [this] {
    if (const QString file = passageOfChosen(); !file.isEmpty()) Q_EMIT estimateRequested(file);
  });
  connect(labels_, &QPushButton::clicked, this, &RecordView::askForLabels);
  return bar;
}

void RecordView::follow(const std::shared_ptr<const records::Overview>& overview) {
  openWaiting();  // events that the user has seen go over to the new list
  ++generation_, reading_ = false;
  strip_->follow(overview);
  table_->setEnabled(false);  // of the record before, until this one is read
  enableButtons();
}

void RecordView::stopFollowing() {
  strip_->stopFollowing();
  table_->setEnabled(true);
  enableButtons();
}

void RecordView::setReport(const ReportPointer& report, const QString& folder) {
  folder_ = folder;
  list_ = folder + "/squats.json";
  model_->setReport(report);
  strip_->setReport(report);
  stopFollowing();
  placeSeen();
  Q_EMIT changed();
}

void RecordView::open(const project::LongRecords& kept) {
  ++generation_, reading_ = false;
  list_ = QString::fromStdString(kept.events);
  folder_ = list_.isEmpty() ? QString() : QFileInfo(list_).path();
  unplaced_ = kept.seen;
  strip_->clear();
  model_->setReport(nullptr);
  waiting_.reset();
  if (!kept.files.empty()) waiting_ = kept;
  sortBy(*table_, QString::fromStdString(kept.order.sort), kept.order.descending);
  filter_->setText(QString::fromStdString(kept.order.filter));
  if (isVisible()) openWaiting();
  enableButtons();
}

void RecordView::keep(project::LongRecords& into) const {
  into.events = list_.toStdString();
  into.order.sort = sortedColumn(*table_).toStdString();
  into.order.descending = !into.order.sort.empty() && isDescending(*table_);
  into.order.filter = filter_->text().toStdString();
  into.seen = unplaced_;
  for (auto& seen : model_->seenForProject()) into.seen.push_back(std::move(seen));
}

void RecordView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  openWaiting();
}

void RecordView::openWaiting() {
  if (!waiting_) return;
  const auto kept = *std::exchange(waiting_, std::nullopt);
  readRecord(kept, false);
  if (!kept.events.empty()) readList(kept);
}

void RecordView::draw(const project::LongRecords& chosen) {
  if (model_->report() || waiting_ || !table_->isEnabled()) return;
  if (!chosen.files.empty()) return readRecord(chosen, true);
  ++generation_, reading_ = false;
  strip_->clear();
}

// What cannot be read is said and costs itself alone: the project keeps the link.
void RecordView::readList(const project::LongRecords& kept) {
  try {
    const auto report = reportOf(project::readEventList(kept.events), kept.files);
    model_->setReport(report);
    strip_->setReport(report);
    placeSeen();
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
  enableButtons();
}

void RecordView::readRecord(const project::LongRecords& kept, bool isChosen) {
  const auto overview = std::make_shared<records::Overview>();
  strip_->follow(overview);
  reading_ = true;
  thread_.start([this, kept, overview, isChosen, generation = ++generation_] {
    QString problem;
    try {
      records::OverviewedStream stream(records::openRide(filesThere(kept), readingOf(kept), togetherOf(kept)),
                                       overview);
      records::RecordBlock block;
      while (generation == generation_ && stream.next(block)) {
      }
    } catch (const CaseError& error) {
      const bool isSpeed = error.problems().size() == 1 && error.problems()[0].key == "--speed";
      problem = isSpeed ? tr("The record states no speed: enter it to see the signal.")
                        : QString::fromStdString(error.what());
    } catch (const std::exception& error) {
      problem = QString::fromStdString(error.what());
    }
    const auto conclude = [this, problem, isChosen, generation] {
      if (generation != generation_) return;  // another record is shown by now
      reading_ = false;
      strip_->setReport(model_->report());
      strip_->stopFollowing();
      if (!problem.isEmpty()) isChosen ? Q_EMIT notDrawn(problem) : Q_EMIT failed(problem);
    };
    QMetaObject::invokeMethod(this, conclude, Qt::QueuedConnection);
  });
}

void RecordView::placeSeen() {
  std::erase_if(unplaced_, [this](const auto& seen) { return model_->see(seen); });
}

int RecordView::chosen() const {
  const QModelIndex index = table_->currentIndex();
  return index.isValid() && model_->report() ? seen_->mapToSource(index).row() : -1;
}

void RecordView::choose(int event) {
  const QModelIndex row = seen_->mapFromSource(model_->index(event, 0));
  if (row.isValid()) table_->setCurrentIndex(row.siblingAtColumn(std::max(0, table_->currentIndex().column())));
}

void RecordView::showChosen() {
  enableButtons();
  const int event = chosen();
  inspect(event);
  if (event < 0) return;
  const QString channel = QString::fromStdString(model_->at(event).event.channel);
  if (channel != strip_->channel()) {
    channel_->setCurrentText(channel);
    strip_->setChannel(channel);
  }
  strip_->show(model_->at(event).event.position);
}

// Of a list that was read from its file, squats have their signal in one of their own.
void RecordView::inspect(int event) {
  if (event < 0) return inspector_->inspect(nullptr);
  detection::CombinedEvent seen = model_->at(event);
  if (seen.event.passage.values.empty() && seen.event.kind == detection::Kind::squat) {
    const std::string file =
        folder_.toStdString() + "/" + detection::passageName(seen, static_cast<std::size_t>(event));
    if (QFileInfo::exists(QString::fromStdString(file))) try {
        seen.event.passage = passageIn(file);
      } catch (const std::exception& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
      }
  }
  inspector_->inspect(&seen);
}

void RecordView::setStyle(const plots::Style& style) {
  strip_->setStyle(style);
  inspector_->setStyle(style);
}

void RecordView::setLabel(int label) {
  const int event = chosen();
  const QString text = EventModel::labels().value(label);
  if (event >= 0 && label < EventModel::labels().size())
    model_->setData(model_->index(event, EventModel::seen), text, Qt::EditRole);
}

bool RecordView::takesKey(int key) {
  const int step = key == Qt::Key_N ? 1 : key == Qt::Key_P ? -1 : 0;
  if (step != 0) {
    const QModelIndex at = table_->currentIndex();
    const int row = at.isValid() ? at.row() + step : 0;
    if (row >= 0 && row < seen_->rowCount()) table_->setCurrentIndex(seen_->index(row, std::max(0, at.column())));
    return true;
  }
  if (key < Qt::Key_0 || key >= Qt::Key_0 + EventModel::labels().size()) return false;
  setLabel(key - Qt::Key_0);
  return true;
}

bool RecordView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (!(key.modifiers() & ~Qt::KeypadModifier) && takesKey(key.key())) return true;
  }
  return QWidget::eventFilter(watched, event);
}

void RecordView::openMenu(const QPoint& location) {
  if (const QModelIndex at = table_->indexAt(location); at.isValid()) table_->setCurrentIndex(at);
  if (chosen() < 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Show in the &figures"), show_, &QPushButton::click)->setEnabled(show_->isEnabled());
  menu->addAction(tr("&Estimate its profile…"), estimate_, &QPushButton::click)->setEnabled(estimate_->isEnabled());
  QMenu* labels = menu->addMenu(tr("&Label"));
  const QStringList words = EventModel::labels();
  for (int label = 0; label < words.size(); ++label)
    labels->addAction(tr("%1\t%2").arg(words[label].isEmpty() ? tr("none") : words[label]).arg(label), this,
                      [this, label] { setLabel(label); });
  menu->addSeparator();
  menu->addActions({undo_, redo_});
  menu->popup(table_->viewport()->mapToGlobal(location));
}

// Squats have their files already; what is none gets one when it is looked at, in a folder of its own.
QString RecordView::passageOfChosen() {
  const int event = chosen();
  if (event < 0) return {};
  const auto& combined = model_->at(event);
  if (combined.event.extent > 0) {
    Q_EMIT failed(tr("A stretch of corrugation is too long to be shown as a passage: choose an event."));
    return {};
  }
  const std::string file =
      folder_.toStdString() + "/" + detection::passageName(combined, static_cast<std::size_t>(event));
  const bool hasSignal = !combined.event.passage.values.empty();  // else the list was read from its file
  try {
    if (combined.event.kind != detection::Kind::squat && hasSignal) {
      makeFolder(folder_.toStdString() + "/other-events");
      writeDurably(file, std::string_view(detection::passageCsv(combined.event)));
    }
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
    return {};
  }
  if (!hasSignal && !QFileInfo::exists(QString::fromStdString(file))) {
    Q_EMIT failed(tr("The signal over this event is in no file. Start the search again to see it."));
    return {};
  }
  return QString::fromStdString(file);
}

void RecordView::writeLabels(const QString& path) {
  writeDurably(path.toStdString(), std::string_view(detection::labelsCsv(model_->seenEvents())));
}

void RecordView::askForLabels() {
  const QString path = locationToSave(this, tr("Save labels"), "labels.csv", tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  try {
    writeLabels(path);
    Q_EMIT labelsSaved(path);
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

void RecordView::enableButtons() {
  const bool can = chosen() >= 0 && table_->isEnabled();
  show_->setEnabled(can);
  estimate_->setEnabled(can);
  labels_->setEnabled(model_->report() && !model_->seenEvents().empty());
  const QUndoStack& stack = model_->undoStack();
  undo_->setEnabled(stack.canUndo() && table_->isEnabled());
  redo_->setEnabled(stack.canRedo() && table_->isEnabled());
  undo_->setText(stack.canUndo() ? tr("&Undo %1").arg(stack.undoText()) : tr("&Undo"));
  redo_->setText(stack.canRedo() ? tr("&Redo %1").arg(stack.redoText()) : tr("&Redo"));
}

}  // namespace squat::studio
