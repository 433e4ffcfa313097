#include "studio/runs/MeasuredDialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "studio/common/HeadTable.h"
#include "studio/common/NumberBox.h"
#include "studio/common/Theme.h"
#include "studio/runs/BackgroundJob.h"
#include "studio/runs/RunStore.h"
#include "text/Numbers.h"
#include "text/Units.h"

namespace squat::studio {
namespace {

constexpr int allColumns = -2, byHeader = -1;             // data of entries that are no column
constexpr int maximumHeadings = 200;                      // columns of the table; the lists have all of them
constexpr int maximumLines = 4;                           // of what is said below the curve
constexpr double highestRate = 1e8, maximumSpeed = 1000;  // [Hz], [m/s]

// For files that give none; the first one is what the reader takes then.
constexpr std::array<const char*, 3> units{"m/s2", "g", "mm/s2"};

double factorOf(int unit) { return text::findUnit(units.at(static_cast<std::size_t>(unit)))->factor; }

QString printed(const std::string& unit) { return QString::fromStdString(text::printedUnit(unit)); }

QString roleWord(const readers::TableRoles& roles, std::size_t column) {
  if (column == roles.time) return QObject::tr("time");
  if (column == roles.position) return QObject::tr("position");
  if (column == roles.speed) return QObject::tr("speed");
  if (column == roles.run) return QObject::tr("number of the run");
  if (column == roles.latitude) return QObject::tr("latitude");
  if (column == roles.longitude) return QObject::tr("longitude");
  return QObject::tr("values");
}

// Boxes show rounded numbers: what was not changed keeps all its digits.
double chosenValue(const QDoubleSpinBox& box, double before) {
  return std::abs(box.value() - before) <= 0.5 * std::pow(10.0, -box.decimals()) ? before : box.value();
}

void choose(QComboBox& list, int data) { list.setCurrentIndex(std::max(0, list.findData(data))); }

QString sentence(QString words) {
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words.endsWith('.') ? words : words + '.';
}

// What the curve shows, and what the reader has assumed.
QString summaryOf(const std::vector<project::MeasuredRecord>& records) {
  const auto& record = *records.front().record;
  QStringList words;
  if (records.size() > 1) {
    words << QObject::tr("%1 signals.").arg(records.size());
  } else if (record.time.size() > 1) {
    const double rate = static_cast<double>(record.time.size() - 1) / (record.time.back() - record.time.front());
    words << QObject::tr("%1 samples at %2 lie within 5 m of the largest value.")
                 .arg(record.time.size())
                 .arg(QString::fromStdString(text::roundedText(rate, "Hz")));
  }
  for (const auto& note : record.notes) words << sentence(QString::fromStdString(note));
  return words.join(' ');
}

}  // namespace

MeasuredDialog::MeasuredDialog(MeasuredChoice first, const plots::Style& style, QWidget* parent)
    : QDialog(parent),
      first_(std::move(first)),
      job_(new BackgroundJob),
      gain_(first_.reading.gain),
      plot_(new plots::Figure("measured", style, this)),
      form_(new QFormLayout),
      table_(makeHeadTable(this)),
      reason_(new QLabel(this)),
      message_(new QLabel(this)) {
  setObjectName("measuredDialog");
  setWindowTitle(tr("Columns of %1").arg(QFileInfo(QString::fromStdString(first_.path)).fileName()));
  makeLayout();
  connect(job_, &BackgroundJob::ended, this, &MeasuredDialog::takeLook);
  wait_.setSingleShot(true);
  connect(&wait_, &QTimer::timeout, this, &MeasuredDialog::change);
  takeHead(first_.reading.options, first_.run);
  listParts();
  if (!first_.run.empty())
    reason_->setText(tr("The signal keeps its name, its colour and its alignment."));
  else if (needsChoice(head_))
    reason_->setText(tr("Several columns could be the signal: choose one."));
  reason_->setVisible(!reason_->text().isEmpty());
  resize(900, 560);
}

// A large file is read to its end: that must not hold the window.
MeasuredDialog::~MeasuredDialog() {
  job_->disconnect(this);
  if (!job_->isRunning()) {
    delete job_;
    return;
  }
  job_->setParent(qApp);
  connect(job_, &BackgroundJob::ended, job_, &QObject::deleteLater);
}

QComboBox* MeasuredDialog::listIn(const QString& label, const QString& name) {
  auto* list = new QComboBox(this);
  list->setObjectName(name);
  list->setAccessibleName(QString(label).remove('&'));
  list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list->setMinimumContentsLength(24);
  form_->addRow(label, list);
  return list;
}

// Zero stands for the value in the file.
QDoubleSpinBox* MeasuredDialog::numberIn(const QString& label, const QString& name, const QString& unit,
                                         double maximum) {
  auto* number = new NumberBox(this);
  number->setObjectName(name);
  number->setAccessibleName(QString(label).remove('&'));
  number->setRange(0, maximum);
  number->setDecimals(3);
  number->setSuffix(" " + unit);
  number->setSpecialValueText(tr("from file"));
  form_->addRow(label, number);
  return number;
}

void MeasuredDialog::makeForm() {
  part_ = listIn(tr("&Group of arrays"), "measuredPart");
  signal_ = listIn(tr("&Signal"), "measuredSignal");
  unit_ = listIn(tr("&Unit"), "measuredUnit");
  time_ = listIn(tr("&Time"), "measuredTime");
  position_ = listIn(tr("&Position"), "measuredPosition");
  rate_ = numberIn(tr("Sampling &rate"), "measuredRate", tr("Hz"), highestRate);
  speed_ = numberIn(tr("Sp&eed"), "measuredSpeed", tr("m/s"), maximumSpeed);
  rate_->setValue(first_.reading.options.rate);
  speed_->setValue(first_.reading.options.speed);
  connect(part_, &QComboBox::currentIndexChanged, this, &MeasuredDialog::takePart);
  for (QComboBox* list : {signal_, time_, position_})
    connect(list, &QComboBox::currentIndexChanged, this, &MeasuredDialog::change);
  connect(unit_, &QComboBox::currentIndexChanged, this, [this](int index) {
    unitIndex_ = index;
    change();
  });
  for (QDoubleSpinBox* number : {rate_, speed_})
    connect(number, &QDoubleSpinBox::valueChanged, this, &MeasuredDialog::changeSoon);
}

void MeasuredDialog::makeLayout() {
  table_->setObjectName("measuredHead");
  plot_->xAxis->setLabel(tr("Position [m]"));
  plot_->yAxis->setLabel(tr("Acceleration [m/s²]"));
  plot_->setMinimumSize(320, 180);
  plot_->setAccessibleName(tr("The chosen signal"));
  reason_->setWordWrap(true);
  reason_->setObjectName("measuredReason");
  message_->setWordWrap(true);
  message_->setObjectName("measuredMessage");
  message_->setMinimumHeight(maximumLines * message_->fontMetrics().lineSpacing());  // the curve stays where it is
  message_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  makeForm();
  auto* seen = new QVBoxLayout;
  seen->addWidget(table_, 2);
  seen->addWidget(plot_, 3);
  seen->addWidget(message_);
  auto* both = new QHBoxLayout;
  both->addLayout(form_);
  both->addLayout(seen, 1);
  auto* buttons = new QDialogButtonBox(this);
  take_ = buttons->addButton(first_.run.empty() ? tr("&Overlay") : tr("Re&ad again"), QDialogButtonBox::AcceptRole);
  take_->setObjectName("takeMeasured");
  take_->setDefault(true);
  buttons->addButton(tr("&Cancel"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::accepted, this, &MeasuredDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &MeasuredDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(reason_);
  layout->addLayout(both);
  layout->addWidget(buttons);
}

void MeasuredDialog::takeHead(const readers::SignalFileOptions& options, const std::string& run) {
  options_ = options;
  head_ = headOf(first_.path, options);
  const int columns = static_cast<int>(head_.table.columns.size());
  showHead(*table_, head_.rows, std::min(columns, maximumHeadings));
  listColumns(run);
  if (gain_ != 1) recogniseUnit();
  change();
}

// Another group has columns of its own.
void MeasuredDialog::takePart(int part) {
  readers::SignalFileOptions options;
  options.object = head_.parts.at(static_cast<std::size_t>(part)).object;
  auto parts = head_.parts;
  takeHead(options, {});
  if (head_.parts.empty()) head_.parts = std::move(parts);  // the file is gone: what is listed stays
}

void MeasuredDialog::listParts() {
  const QSignalBlocker quiet(part_);
  for (const auto& part : head_.parts)
    part_->addItem(tr("%1, %2 samples")
                       .arg(part.group.empty() ? QStringLiteral("/") : QString::fromStdString(part.group))
                       .arg(part.samples));
  part_->setCurrentIndex(static_cast<int>(head_.part));
  if (head_.parts.size() < 2) form_->setRowVisible(part_, false);
}

void MeasuredDialog::listColumns(const std::string& run) {
  const QSignalBlocker noSignal(signal_), noTime(time_), noPosition(position_);
  for (QComboBox* list : {signal_, time_, position_}) list->clear();
  for (QComboBox* list : {time_, position_}) list->addItem(QString(), byHeader);
  const auto named = rolesIn(head_, options_), roles = rolesIn(head_, {});
  for (std::size_t c = 0; c < head_.table.columns.size(); ++c) {
    const QString words = tr("%1, %2").arg(columnText(head_, c), roleWord(roles, c));
    for (QComboBox* list : {signal_, time_, position_}) list->addItem(words, static_cast<int>(c));
  }
  if (first_.run.empty() && roles.rest.size() > 1) signal_->addItem(tr("all columns of values"), allColumns);
  const std::size_t likely = likelySignal(head_, options_, run);
  choose(*signal_, likely == readers::noColumn ? 0 : static_cast<int>(likely));
  choose(*time_, options_.timeColumn.empty() ? byHeader : static_cast<int>(named.time));
  choose(*position_, options_.positionColumn.empty() ? byHeader : static_cast<int>(named.position));
}

// A unit that was chosen here is a gain: it is recognised again where nothing else is in it.
void MeasuredDialog::recogniseUnit() {
  const int column = signal_->currentData().toInt();
  if (column < 0 || head_.table.columns.empty()) return;
  if (!head_.table.columns[static_cast<std::size_t>(column)].unit.empty()) return;
  for (int unit = 1; unit < static_cast<int>(units.size()); ++unit)
    if (gain_ == factorOf(unit)) {
      unitIndex_ = unit;
      gain_ = 1;
      return;
    }
}

MeasuredChoice MeasuredDialog::choice() const {
  MeasuredChoice chosen = first_;
  auto& options = chosen.reading.options;
  options = options_;
  const auto nameIn = [&](const QComboBox& list) {
    const int column = list.currentData().toInt();
    return column < 0 ? std::string() : optionOf(head_, static_cast<std::size_t>(column));
  };
  if (!head_.table.columns.empty()) {
    const int column = signal_->currentData().toInt();
    options.column = column == allColumns ? "all" : nameIn(*signal_);
    if (head_.isArrays()) options.object = head_.places.at(static_cast<std::size_t>(std::max(column, 0))).path;
    options.timeColumn = nameIn(*time_);
    options.positionColumn = nameIn(*position_);
  }
  options.rate = chosenValue(*rate_, first_.reading.options.rate);
  options.speed = needsSpeed_ ? chosenValue(*speed_, first_.reading.options.speed) : 0;
  chosen.reading.gain = gain_ * (unit_->isEnabled() ? factorOf(unitIndex_) : 1);
  return chosen;
}

void MeasuredDialog::forget() {
  look_ = {};
  take_->setEnabled(false);
  if (job_->isRunning()) stale_ = true;
}

void MeasuredDialog::changeSoon() {
  constexpr int typing = 300;  // [ms] between the digits of a number
  forget();
  wait_.start(typing);
}

void MeasuredDialog::change() {
  wait_.stop();
  showUnit();
  showTaken();
  forget();
  if (!head_.problem.empty()) {
    draw();
    say(QString::fromStdString(head_.problem), true);
    return;
  }
  say(tr("Reading…"), false);
  if (!job_->isRunning()) read();
}

void MeasuredDialog::showUnit() {
  const QSignalBlocker quiet(unit_);
  const int column = signal_->currentData().toInt();
  const bool one = column >= 0 && !head_.table.columns.empty();
  const std::string own = one ? head_.table.columns[static_cast<std::size_t>(column)].unit : std::string();
  unit_->clear();
  unit_->setEnabled(one && own.empty());
  if (unit_->isEnabled()) {
    for (const char* unit : units) unit_->addItem(printed(unit));
    unit_->setCurrentIndex(unitIndex_);
    unit_->setToolTip(tr("The file gives none; another one than m/s² becomes the gain"));
  } else {
    unit_->addItem(one ? printed(own) : tr("from file"));
    unit_->setToolTip(tr("The file gives it"));
  }
}

void MeasuredDialog::showTaken() {
  const auto options = choice().reading.options;
  auto byHeaders = options;
  byHeaders.timeColumn.clear(), byHeaders.positionColumn.clear();
  const auto found = rolesIn(head_, byHeaders), taken = rolesIn(head_, options);
  const auto automatic = [&](std::size_t column) {
    return tr("by header: %1").arg(column == readers::noColumn ? tr("none") : columnText(head_, column));
  };
  time_->setItemText(0, automatic(found.time));
  position_->setItemText(0, automatic(found.position));
  showSpeed(taken);
  showHeadings(taken);
}

void MeasuredDialog::showSpeed(const readers::TableRoles& taken) {
  using readers::noColumn;
  // Equally spaced positions are a rate as well, once the speed is known.
  const bool hasRate = taken.time != noColumn || rate_->value() > 0 || head_.rate > 0;
  needsSpeed_ = taken.speed == noColumn && (taken.position == noColumn || !hasRate);
  const bool ofCase = needsSpeed_ && head_.speed == 0 && taken.position == noColumn && first_.speed > 0;
  speed_->setEnabled(needsSpeed_);
  speed_->setSpecialValueText(ofCase ? tr("%1 m/s of the case").arg(first_.speed) : tr("from file"));
  speed_->setToolTip(needsSpeed_ ? tr("Links time and position") : tr("The file has positions or a speed of its own"));
}

void MeasuredDialog::showHeadings(const readers::TableRoles& taken) {
  const int chosen = signal_->currentData().toInt();
  QStringList headings;
  for (int c = 0; c < table_->columnCount(); ++c) {
    const auto column = static_cast<std::size_t>(c);
    const QString role = roleWord(taken, column);
    const bool isSignal = c == chosen || (chosen == allColumns && role == tr("values"));
    headings << columnText(head_, column) + '\n' + (isSignal ? tr("signal") : role);
  }
  table_->setHorizontalHeaderLabels(headings);
  table_->resizeColumnsToContents();
  if (const auto* cell = table_->item(0, chosen)) table_->scrollToItem(cell);
}

void MeasuredDialog::read() {
  stale_ = false;
  reading_ = std::make_shared<MeasuredLook>();
  job_->start([look = reading_, chosen = choice(), head = head_](Monitor&) { *look = lookAt(chosen, head); });
}

void MeasuredDialog::takeLook() {
  if (std::exchange(stale_, false)) {
    if (head_.problem.empty() && !wait_.isActive()) read();
    return;
  }
  look_ = std::move(*reading_);
  if (!look_.rows.empty()) {
    head_.rows = look_.rows;
    showHead(*table_, head_.rows, table_->columnCount());
    showTaken();
  }
  draw();
  take_->setEnabled(!look_.records.empty());
  const bool wrong = look_.records.empty();
  say(wrong ? QString::fromStdString(look_.problem) : summaryOf(look_.records), wrong);
}

void MeasuredDialog::draw() {
  plot_->clearGraphs();
  for (std::size_t i = 0; i < look_.curves.size(); ++i) {
    const auto& [position, value] = look_.curves[i];
    QCPGraph* graph = plot_->addGraph();
    graph->setPen(QPen(plot_->style().curve(i), 1.2));
    graph->setData(QVector<double>(position.begin(), position.end()), QVector<double>(value.begin(), value.end()),
                   true);
  }
  plot_->rescaleAxes();
  plot_->yAxis->scaleRange(1.1);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

// The name of the file is enough: the window says the rest of its path.
void MeasuredDialog::say(const QString& words, bool wrong) {
  const QString path = QString::fromStdString(first_.path);
  message_->setText(QString(words).replace(path, QFileInfo(path).fileName()));
  message_->setStyleSheet(wrong ? QStringLiteral("color: %1;").arg(wrongColour) : QString());
  message_->setMinimumHeight(message_->heightForWidth(std::max(message_->width(), plot_->minimumWidth())));
}

void MeasuredDialog::accept() {
  if (!look_.records.empty()) QDialog::accept();
}

void askForColumns(RunStore& store, int row, double speed, const plots::Style& style, QWidget* parent) {
  if (row < 0 || row >= store.rowCount() || !store.at(row).isMeasured() || store.at(row).isMissing()) return;
  const StoredRun& run = store.at(row);
  const RecordPointer beside = run.reading.isAutomatic ? RecordPointer(store.currentResult()) : nullptr;
  auto* dialog =
      new MeasuredDialog({run.path.toStdString(), run.reading, speed, run.record->run, beside}, style, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // Rows may move while it stands: the record itself is what is meant.
  const auto place = [&store, record = run.record] { return store.rowOfRecord(record); };
  QObject::connect(dialog, &QDialog::accepted, &store, [&store, dialog, place] {
    if (const int at = place(); at >= 0) store.setMeasured(at, dialog->records().front());
  });
  QObject::connect(&store, &RunStore::rowsRemoved, dialog, [dialog, place] {
    if (place() < 0) dialog->reject();
  });
  QObject::connect(&store, &RunStore::modelReset, dialog, &QDialog::reject);
  dialog->open();
}

}  // namespace squat::studio
