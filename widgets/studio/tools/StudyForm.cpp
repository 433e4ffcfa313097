#include "studio/tools/StudyForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QSettings>
#include <QSpinBox>
#include <filesystem>

#include "case/CaseNames.h"
#include "case/RightSide.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "plots/StudyFigures.h"
#include "studies/CaseStudy.h"
#include "studies/ComputeStudy.h"
#include "studies/StudySummary.h"
#include "studio/tools/KeyRows.h"
#include "studio/tools/StudyView.h"

namespace squat::studio {
namespace {

// The words of --sample; the first item has none.
constexpr const char* methods[] = {"", "sobol", "latin-hypercube"};

bool mayVary(const cases::Parameter& parameter) {
  using cases::Kind;
  return parameter.group != "case" &&
         (parameter.kind == Kind::number || parameter.kind == Kind::choice || parameter.kind == Kind::boolean);
}

std::string textOf(const studies::StudyTable& table, const std::string& file) {
  std::string text = studies::studySummary(table);
  if (!text.empty()) text += "\n";
  text += file + ": " + std::to_string(table.count(studies::RowState::done)) + " of " +
          std::to_string(table.rows.size()) + " runs done\n";
  for (const auto& row : table.rows)
    if (row.state == studies::RowState::failed)
      text += "failed: " + studies::toText(table.definition, row.point) + ": " + row.message + "\n";
  return text;
}

// "depth 0.2, speed 40": as runs are called by what differs.
std::string nameOf(const studies::StudyDefinition& definition, const studies::StudyPoint& point) {
  std::string name;
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    const auto& key = definition.variations[i].key;
    name += (i > 0 ? ", " : "") + std::string(cases::keyOnRight(key).empty() ? "" : "right ") +
            cases::shortLabel(*cases::findOnEitherSide(key)) + " " + point.values[i];
  }
  return name;
}

ToolResult computeStudy(studies::StudyJob job, const studies::StudyRequest& request, const QPointer<StudyForm>& form,
                        const ToolInput& input, Monitor& monitor) {
  job.study.folder = input.folder;
  makeFolder(input.folder);
  const FolderLock owner(input.folder, "Squat Studio, study");
  const auto files = studies::studyFiles(input.folder);
  job.definition = studies::studyOf(keepCase(input, files.front()), job.overrides, request);
  job.study.watcher = [&input, form, kept = std::make_shared<const studies::StudyJob>(job)](const auto& progress) {
    input.show([form, kept, study = std::make_shared<const studies::StudyProgress>(progress)] {
      if (form) form->showStudy(study, kept);
    });
  };
  job.study.watcher(studies::progressOf(studies::tableSoFar(job)));  // the start in common may take long
  const auto cost = studies::costAhead(job);
  if (cost.runs > 0) monitor.message("estimate: " + studies::toText(cost));
  studies::shareCores(job, 0, 0, cost);
  const auto table = std::make_shared<studies::StudyTable>(studies::computeStudy(job, monitor));
  ToolResult result;
  result.complete = table->count(studies::RowState::open) == 0;
  result.text = textOf(*table, files.front());
  result.files = files;
  result.figures = [table](const plots::Style& style) { return plots::studyFigures(*table, style); };
  if (job.keepResults)
    for (const auto& row : table->rows)
      if (const auto file = studies::resultFile(job, row.point);
          row.state == studies::RowState::done && std::filesystem::exists(file))
        result.results.emplace_back(file, nameOf(job.definition, row.point));
  return result;
}

}  // namespace

StudyForm::StudyForm(QWidget* parent)
    : ToolForm(parent),
      rows_(new KeyRows(mayVary, KeyValues::values, this)),
      points_(new QComboBox(this)),
      count_(new QSpinBox(this)),
      keep_(new QCheckBox(tr("&Keep the result of each run, and list it"), this)),
      runs_(new QLabel(this)),
      view_(new StudyView(this)) {
  points_->setObjectName("points");
  points_->setAccessibleName(tr("Points"));
  points_->addItems({tr("All combinations"), tr("Sobol sample"), tr("Latin hypercube sample")});
  points_->setToolTip(tr("A sample spreads this many points between the limits of all keys"));
  count_->setObjectName("samples");
  count_->setAccessibleName(tr("Number of samples"));
  count_->setRange(2, 10000);
  count_->setValue(64);
  count_->setEnabled(false);
  keep_->setObjectName("keepResults");
  runs_->setObjectName("studyRuns");
  connect(points_, &QComboBox::currentIndexChanged, this, [this](int method) {
    count_->setEnabled(method > 0);
    rows_->setCounted(method == 0);
    showRuns();
  });
  connect(count_, &QSpinBox::valueChanged, this, &StudyForm::showRuns);
  connect(rows_, &KeyRows::edited, this, &StudyForm::showRuns);
  connect(view_, &StudyView::runRequested, this, &StudyForm::openRun);
  connect(rows_, &KeyRows::edited, this, &ToolForm::edited);
  auto* points = new QHBoxLayout;
  points->addWidget(points_);
  points->addWidget(count_);
  points->addWidget(runs_);
  points->addStretch(1);
  points->addWidget(keep_);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Values:"), rows_);
  layout->addRow(tr("Points:"), points);
  showRuns();
}

void StudyForm::showRuns() {
  const int runs = points_->currentIndex() > 0 ? count_->value() : rows_->combinations();
  runs_->setText(runs == 0 ? QString() : runs == 1 ? tr("1 run") : tr("%1 runs").arg(runs));
}

QString StudyForm::explanation() const {
  return tr(
      "Runs the open case for all combinations of the given values, each in the unit of its key. A stopped study "
      "resumes in its folder.");
}

void StudyForm::showCase(const cases::CaseDescription& description) { rows_->showCase(description); }

ToolWork StudyForm::work() {
  studies::StudyRequest request;
  request.variations = points_->currentIndex() > 0 ? rows_->limits() : rows_->texts();
  if (points_->currentIndex() > 0)
    request.sample = std::string(methods[points_->currentIndex()]) + ":" + std::to_string(count_->value());
  studies::StudyJob job;
  job.keepResults = keep_->isChecked();
  view_->clear();  // of the study before
  return [job, request, form = QPointer(this)](const ToolInput& input, Monitor& monitor) {
    return computeStudy(job, request, form, input, monitor);
  };
}

QWidget* StudyForm::view() const { return view_; }

void StudyForm::showStudy(const StudyPointer& study, const std::shared_ptr<const studies::StudyJob>& job) {
  shown_ = job;
  view_->setStudy(study);
}

void StudyForm::conclude() { view_->conclude(); }

void StudyForm::openRun(const studies::StudyPoint& point) {
  const std::string file = studies::resultFile(*shown_, point);
  if (!std::filesystem::exists(file)) {
    Q_EMIT noted(
        tr("The result of this run was not kept. To look at it, choose \"Keep the result of each run\" and "
           "start the study in another folder."));
    return;
  }
  Q_EMIT runRequested(QString::fromStdString(file), QString::fromStdString(nameOf(shown_->definition, point)));
}

void StudyForm::save(QSettings& settings) const {
  QStringList texts;
  for (const auto& text : rows_->texts()) texts << QString::fromStdString(text);
  settings.setValue("rows", texts);
  settings.setValue("points", points_->currentIndex());
  settings.setValue("samples", count_->value());
  settings.setValue("keepResults", keep_->isChecked());
}

void StudyForm::restore(const QSettings& settings) {
  rows_->setTexts(settings.value("rows").toStringList());
  points_->setCurrentIndex(settings.value("points", 0).toInt());
  count_->setValue(settings.value("samples", count_->value()).toInt());
  keep_->setChecked(settings.value("keepResults").toBool());
}

}  // namespace squat::studio
