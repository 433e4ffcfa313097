#include "studio/tools/DetectionForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <memory>

#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "detection/DetectionSummary.h"
#include "detection/ExampleSource.h"
#include "plots/DetectionFigures.h"
#include "records/Overview.h"
#include "studies/Jobs.h"
#include "studio/common/EditorHabits.h"
#include "studio/common/NumberBox.h"
#include "studio/records/RecordReading.h"
#include "studio/records/RecordView.h"
#include "studio/tools/ButtonedList.h"

namespace squat::studio {
namespace {

struct Search {
  project::LongRecords records;
  std::shared_ptr<records::Overview> overview;  // of the first record
  QPointer<RecordView> view;
};

std::vector<detection::RecordDetection> search(const Search& wanted, const detection::DetectOptions& options,
                                               Monitor& monitor) {
  const auto read = readingOf(wanted.records);
  std::vector<detection::RecordDetection> found;
  for (auto rest = records::inNumberOrder(wanted.records.files); !rest.empty();) {
    auto stream = records::openRide(rest, read, togetherOf(wanted.records));
    if (found.empty()) stream = std::make_unique<records::OverviewedStream>(std::move(stream), wanted.overview);
    found.push_back(detection::findCandidates(*stream, options, monitor));
    if (found.back().cancelled) break;
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(stream->layout().files.size()));
  }
  return found;
}

detection::SourceOptions sourceOf(const Search& wanted, const ToolInput& input) {
  detection::SourceOptions source;
  if (wanted.records.ownVehicle) {
    source.vehicle = cases::loadCase(keepCase(input, {}), {"tiny", {}});  // as --case does
    source.vehicleName = input.name;
  }
  source.folder = input.folder;
  source.labelsFile = wanted.records.labels;
  source.jobs = studies::coresHere();
  return source;
}

QString samplePath() {
  return QString::fromStdString((cases::resourcesFolder() / "records/example-record.csv").string());
}

ToolResult computeSearch(const Search& wanted, const ToolInput& input, Monitor& monitor) {
  detection::DetectOptions options;
  options.axles = detection::axleNamesFromLine(wanted.records.axles);
  makeFolder(input.folder);
  const FolderLock owner(input.folder, "Squat Studio, squats in records");
  keepInputs(wanted.records.files, {input.folder + "/squats.csv", input.folder + "/squats.json"});
  ToolResult result;
  auto found = search(wanted, options, monitor);
  if (found.back().cancelled) return result;
  const auto source = detection::exampleSource(sourceOf(wanted, input), found, monitor);
  if (!source) return result;
  auto judged = detection::judged(std::move(found), *source, options, monitor);
  if (!judged) return result;
  const auto report = std::make_shared<const detection::DetectionReport>(*std::move(judged));
  result.complete = true;
  result.files = detection::writeDetection(*report, input.folder);
  for (const auto& record : report->records) result.text += detection::faultText(record);
  if (!result.text.empty()) result.text += '\n';
  result.text += detection::detectionSummary(*report);
  result.show = [report, view = wanted.view, folder = QString::fromStdString(input.folder)] {
    if (view) view->setReport(report, folder);
  };
  result.figures = [report](const plots::Style& style) { return plots::detectionFigures(*report, style); };
  // An event is looked at in the view.
  result.shownFigures = [report](const plots::Style& style) { return plots::detectionFigures(*report, style, 0); };
  return result;
}

}  // namespace

DetectionForm::DetectionForm(const plots::Style& style, QWidget* parent)
    : ToolForm(parent),
      files_(new ButtonedList("Record", tr("&Add…"), tr("Records, one or several of one location"), 2, this)),
      channels_(new QLineEdit(this)),
      axles_(new QLineEdit(this)),
      chainage_(new QLineEdit(this)),
      labels_(new QLineEdit(this)),
      units_(new QLineEdit(this)),
      speed_(new NumberBox(this)),
      together_(new QComboBox(this)),
      own_(new QCheckBox(tr("&Use the vehicle and track of the open case"), this)),
      view_(new RecordView(style, this)) {
  nameFields();
  layOutFields();
  connectParts();
  leaveUndoToWindow(*this);  // that of labels
}

void DetectionForm::nameFields() {
  channels_->setObjectName("channels");
  channels_->setAccessibleName(tr("Channels"));
  channels_->setPlaceholderText(tr("all accelerations; or names of columns, separated by commas"));
  axles_->setObjectName("axles");
  axles_->setAccessibleName(tr("Axle boxes"));
  axles_->setPlaceholderText(
      tr("automatic (by names); or none, or the names of the left and the right one: left,right"));
  axles_->setToolTip(
      tr("Which channels are the left and the right axle box of one wheelset: each of their events then gets its side\n"
         "nothing typed: channels whose names differ in left and right\n"
         "left,right: the names of two channels; a semicolon stands between wheelsets\n"
         "none: every channel by itself\n"
         "A name that holds a comma or a semicolon stands in double quotes: \"box, left\",\"box, right\""));
  speed_->setObjectName("recordSpeed");
  speed_->setAccessibleName(tr("Speed"));
  speed_->setRange(0, 200);
  speed_->setDecimals(2);
  speed_->setSuffix(" m/s");
  speed_->setSpecialValueText(tr("from the file"));
  chainage_->setObjectName("chainage");
  chainage_->setAccessibleName(tr("Chainage of the first sample"));
  chainage_->setPlaceholderText(tr("from the file, or for example 12+300 or 12.3 km"));
  labels_->setObjectName("labels");
  labels_->setAccessibleName(tr("File of labels"));
  labels_->setPlaceholderText(tr("none, or a table of events that you have seen"));
  units_->setObjectName("units");
  units_->setAccessibleName(tr("Units"));
  units_->setPlaceholderText(tr("as the files state them; or for example g, or aba=g, time=ms"));
  together_->setObjectName("together");
  together_->setAccessibleName(tr("Several records"));
  together_->addItem(tr("one ride where their times or positions follow on, else passes"), QString());
  together_->addItem(tr("parts of one ride"), QStringLiteral("ride"));
  together_->addItem(tr("passes over one track"), QStringLiteral("passes"));
  own_->setObjectName("ownVehicle");
  own_->setToolTip(tr("Computes some fifty passages of this vehicle once: severities and sizes become narrower"));
}

void DetectionForm::layOutFields() {
  auto* labels = new QHBoxLayout;
  auto* browse = textButton(tr("Bro&wse…"), "browseLabels", this);
  labels->addWidget(labels_, 1);
  labels->addWidget(browse);
  labels->addWidget(own_);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Records:"), files_);
  layout->addRow(tr("Several are:"), together_);
  auto* columns = new QHBoxLayout;
  columns->addWidget(channels_, 1);
  columns->addWidget(new QLabel(tr("in units:"), this));
  columns->addWidget(units_, 1);
  layout->addRow(tr("Channels:"), columns);
  layout->addRow(tr("Axle boxes:"), axles_);
  auto* where = new QHBoxLayout;
  where->addWidget(speed_);
  where->addWidget(new QLabel(tr("begins at:"), this));
  where->addWidget(chainage_, 1);
  layout->addRow(tr("Speed:"), where);
  layout->addRow(tr("Labels:"), labels);
  connect(browse, &QToolButton::clicked, this, &DetectionForm::askForLabels);
}

void DetectionForm::connectParts() {
  connect(files_->add(), &QToolButton::clicked, this, &DetectionForm::askForRecords);
  connect(files_->remove(), &QToolButton::clicked, this, [this] {
    const std::unique_ptr<QListWidgetItem> gone(files_->list()->takeItem(files_->list()->currentRow()));
    if (gone && gone->text() == samplePath()) speed_->setValue(0);  // that of the next record is another
  });
  connect(view_, &RecordView::passageRequested, this, &DetectionForm::passageRequested);
  connect(view_, &RecordView::estimateRequested, this, &DetectionForm::estimateRequested);
  connect(view_, &RecordView::sampleRequested, this, &DetectionForm::addSample);
  connect(view_, &RecordView::labelsSaved, labels_, &QLineEdit::setText);
  connect(view_, &RecordView::failed, this, &ToolForm::failed);
  connect(view_, &RecordView::notDrawn, this, &ToolForm::noted);
  for (const QLineEdit* each : {channels_, axles_, units_, chainage_, labels_})
    connect(each, &QLineEdit::textChanged, this, &DetectionForm::choicesChanged);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, &DetectionForm::choicesChanged);
  connect(together_, &QComboBox::currentIndexChanged, this, &DetectionForm::choicesChanged);
  connect(own_, &QCheckBox::toggled, this, &DetectionForm::choicesChanged);
  connect(files_->list()->model(), &QAbstractItemModel::rowsInserted, this, &DetectionForm::choicesChanged);
  connect(files_->list()->model(), &QAbstractItemModel::rowsRemoved, this, &DetectionForm::choicesChanged);
  connect(view_, &RecordView::changed, this, &DetectionForm::choicesChanged);
  connect(this, &DetectionForm::choicesChanged, this, &ToolForm::edited);
  constexpr int pause = 500;  // [ms] of somebody who types
  draw_.setSingleShot(true);
  draw_.setInterval(pause);
  connect(&draw_, &QTimer::timeout, this, [this] {
    if (isEnabled()) view_->draw(chosen());
  });
  const auto soon = [this] { draw_.start(); };
  for (const QLineEdit* each : {channels_, units_, chainage_}) connect(each, &QLineEdit::textEdited, this, soon);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, soon);
  connect(files_->list()->model(), &QAbstractItemModel::rowsInserted, this, soon);
  connect(files_->list()->model(), &QAbstractItemModel::rowsRemoved, this, soon);
}

project::LongRecords DetectionForm::chosen() const {
  project::LongRecords kept;
  for (int i = 0; i < files_->list()->count(); ++i) kept.files.push_back(files_->list()->item(i)->text().toStdString());
  if (kept.files.empty()) return kept;
  kept.channels = channels_->text().trimmed().toStdString(), kept.chainage = chainage_->text().trimmed().toStdString();
  kept.speed = speed_->value();
  kept.units = units_->text().trimmed().toStdString();
  kept.together = together_->currentData().toString().toStdString();
  kept.axles = axles_->text().trimmed().toStdString();
  kept.ownVehicle = own_->isChecked();
  return kept;
}

project::LongRecords DetectionForm::choices() const {
  auto kept = chosen();
  if (kept.files.empty()) return kept;
  if (const QString labels = labels_->text().trimmed(); !labels.isEmpty())
    kept.labels = QFileInfo(labels).absoluteFilePath().toStdString();
  view_->keep(kept);
  return kept;
}

void DetectionForm::setChoices(const project::LongRecords& choices) {
  files_->list()->clear();
  for (const auto& file : choices.files) addRecord(QString::fromStdString(file));
  view_->open(choices);
  if (choices.files.empty()) return;
  channels_->setText(QString::fromStdString(choices.channels));
  axles_->setText(QString::fromStdString(choices.axles));
  chainage_->setText(QString::fromStdString(choices.chainage));
  labels_->setText(QString::fromStdString(choices.labels));
  speed_->setValue(choices.speed);
  units_->setText(QString::fromStdString(choices.units));
  together_->setCurrentIndex(std::max(0, together_->findData(QString::fromStdString(choices.together))));
  own_->setChecked(choices.ownVehicle);
  draw_.stop();  // the view reads it when it is seen
}

QString DetectionForm::explanation() const {
  return tr(
      "Finds squats in long records of axle box acceleration, and tells them from joints, welds, corrugation and "
      "wheel flats. Several passes of one location are combined.");
}

QString DetectionForm::missing() const {
  return files_->list()->count() == 0 ? tr("No record is chosen. Add a record.") : QString();
}

bool DetectionForm::usesCase() const { return own_->isChecked(); }

QWidget* DetectionForm::view() const { return view_; }

void DetectionForm::setStyle(const plots::Style& style) { view_->setStyle(style); }

void DetectionForm::conclude() { view_->stopFollowing(); }

void DetectionForm::addRecord(const QString& path) {
  if (files_->list()->findItems(path, Qt::MatchExactly).isEmpty()) files_->list()->addItem(path);
}

// It has times alone, and one channel: what was typed for another record does not fit it.
void DetectionForm::addSample() {
  for (QLineEdit* each : {channels_, axles_, units_, chainage_}) each->clear();
  constexpr double speed = 30;  // [m/s] that it was computed with
  speed_->setValue(speed);
  addRecord(samplePath());
}

void DetectionForm::askForRecords() {
  for (const QString& path : QFileDialog::getOpenFileNames(
           this, tr("Add records"), QString(),
           tr("Records (*.csv *.txt *.gz *.h5 *.mat *.tdms *.lvm *.wav *.unv *.uff);;All files (*)")))
    addRecord(path);
}

void DetectionForm::askForLabels() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Labels"), QString(), tr("Tables (*.csv);;All files (*)"));
  if (!path.isEmpty()) labels_->setText(path);
}

ToolWork DetectionForm::work() {
  Search wanted;
  wanted.records = chosen();
  wanted.records.labels = labels_->text().trimmed().toStdString();
  wanted.overview = std::make_shared<records::Overview>();
  wanted.view = view_;
  view_->follow(wanted.overview);
  Q_EMIT searchStarted();
  return [wanted](const ToolInput& input, Monitor& monitor) { return computeSearch(wanted, input, monitor); };
}

void DetectionForm::save(QSettings& settings) const {
  settings.setValue("channels", channels_->text());
  settings.setValue("axles", axles_->text());
  settings.setValue("speed", speed_->value());
  settings.setValue("labels", labels_->text());
  settings.setValue("units", units_->text());
  settings.setValue("together", together_->currentIndex());
  settings.setValue("ownVehicle", own_->isChecked());
}

void DetectionForm::restore(const QSettings& settings) {
  channels_->setText(settings.value("channels").toString());
  axles_->setText(settings.value("axles").toString());
  speed_->setValue(settings.value("speed").toDouble());
  labels_->setText(settings.value("labels").toString());
  units_->setText(settings.value("units").toString());
  together_->setCurrentIndex(std::clamp(settings.value("together").toInt(), 0, together_->count() - 1));
  own_->setChecked(settings.value("ownVehicle").toBool());
}

}  // namespace squat::studio
