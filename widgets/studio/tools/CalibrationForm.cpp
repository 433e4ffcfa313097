#include "studio/tools/CalibrationForm.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>

#include "calibration/Calibration.h"
#include "calibration/CalibrationFiles.h"
#include "calibration/CalibrationSummary.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/FolderLock.h"
#include "plots/CalibrationFigure.h"
#include "studio/tools/KeyRows.h"
#include "studio/tools/MeshBox.h"
#include "studio/tools/TargetList.h"

namespace squat::studio {
namespace {

constexpr int minimum = 10, maximum = 100000;  // points, as the command allows

bool mayBeFree(const cases::Parameter& parameter) {
  return parameter.kind == cases::Kind::number && parameter.group != "mesh" && parameter.group != "output";
}

// Measured signals of the list with a target file that names them: the command takes it as well.
std::vector<std::string> targetFiles(const ChosenTargets& chosen, const std::string& folder) {
  auto files = chosen.files;
  if (chosen.measured.empty()) return files;
  QJsonArray entries;
  for (std::size_t i = 0; i < chosen.measured.size(); ++i)
    entries.append(QJsonObject{{"name", QString::fromStdString(chosen.measured[i].name)},
                               {"files", QJsonArray{QStringLiteral("measured-%1.csv").arg(i + 1)}}});
  const QJsonObject all{{"schema", "squat-targets"}, {"schema_version", 1}, {"signals", entries}};
  writeMeasured(chosen, folder, calibration::calibrationFiles(folder).front());
  files.push_back(folder + "/case/measured-targets.json");
  writeDurably(files.back(), std::string_view(QJsonDocument(all).toJson().toStdString()));
  return files;
}

ToolResult computeCalibration(calibration::CalibrationDefinition definition, const std::vector<std::string>& free,
                              const ChosenTargets& chosen, const ToolInput& input, Monitor& monitor) {
  const auto& folder = input.folder;
  makeFolder(folder);
  const FolderLock owner(folder, "Squat Studio, calibration");
  definition.inputs = calibration::freeInputsFromText(free);
  definition.caseName = keepCase(input, calibration::calibrationFiles(folder).front());
  const auto files = targetFiles(chosen, folder);
  definition.targets = calibration::readTargets(files, definition.caseName);
  calibration::keepInputsOf(definition, files, folder, input.name);
  calibration::CalibrationOptions options;
  options.folder = folder;
  calibration::shareCores(definition, 0, 0, options);
  const auto found = std::make_shared<calibration::Calibration>(calibration::calibrate(definition, options, monitor));
  ToolResult result;
  result.complete = found->complete;
  result.text = calibration::calibrationSummary(*found);
  if (!found->complete || found->ranges.empty()) return result;
  result.files = calibration::writeCalibrated(*found, folder, input.name);
  result.foundCase = calibration::calibratedCaseFile(folder, input.name);
  result.figures = [found](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::calibrationFigure(*found, style));
    return sheets;
  };
  return result;
}

}  // namespace

CalibrationForm::CalibrationForm(const RunStore& store, QWidget* parent)
    : ToolForm(parent),
      rows_(new KeyRows(mayBeFree, KeyValues::limits, this)),
      targets_(new TargetList(store, TargetList::Offer::targets, this)),
      search_(meshBox(tr("Mesh of the search"), "searchMesh", "tiny", this)),
      confirm_(meshBox(tr("Mesh on which the best points are computed again"), "confirmMesh", "draft", this)),
      evaluations_(new QSpinBox(this)) {
  evaluations_->setObjectName("evaluations");
  evaluations_->setAccessibleName(tr("Approximate number of points to compute"));
  evaluations_->setRange(minimum - 1, maximum);
  evaluations_->setSpecialValueText(tr("20 + 40 per key"));
  evaluations_->setValue(minimum - 1);
  connect(rows_, &KeyRows::edited, this, &ToolForm::edited);
  auto* search = new QHBoxLayout;
  search->addWidget(search_);
  search->addWidget(new QLabel(tr("confirmed on"), this));
  search->addWidget(confirm_);
  search->addWidget(new QLabel(tr("points:"), this));
  search->addWidget(evaluations_);
  search->addStretch(1);
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(targets_->list()->model(), signal, this, &ToolForm::edited);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Unknown keys:"), rows_);
  layout->addRow(tr("Targets:"), targets_);
  layout->addRow(tr("Search on:"), search);
}

QString CalibrationForm::explanation() const {
  return tr(
      "Finds unknown values of the case from what it has to reproduce. Give the limits between which each is looked "
      "for, in the unit of its key. A stopped calibration resumes in its folder.");
}

void CalibrationForm::showCase(const cases::CaseDescription& description) { rows_->showCase(description); }

QString CalibrationForm::missing() const {
  return targets_->chosen().isEmpty() ? tr("No target is chosen. Add a target.") : QString();
}

ToolWork CalibrationForm::work() {
  calibration::CalibrationDefinition definition;
  definition.searchMesh = search_->currentText().toStdString();
  definition.confirmMesh = confirm_->currentText().toStdString();
  definition.evaluations = evaluations_->value() < minimum ? 0 : evaluations_->value();
  return [definition, free = rows_->texts(), chosen = targets_->chosen()](const ToolInput& input, Monitor& monitor) {
    return computeCalibration(definition, free, chosen, input, monitor);
  };
}

void CalibrationForm::save(QSettings& settings) const {
  QStringList texts;
  for (const auto& text : rows_->texts()) texts << QString::fromStdString(text);
  settings.setValue("rows", texts);
  settings.setValue("targets", targets_->files());
  settings.setValue("searchMesh", search_->currentText());
  settings.setValue("confirmMesh", confirm_->currentText());
  settings.setValue("evaluations", evaluations_->value());
}

void CalibrationForm::restore(const QSettings& settings) {
  rows_->setTexts(settings.value("rows").toStringList());
  for (const QString& file : settings.value("targets").toStringList()) targets_->addFile(file);
  search_->setCurrentText(settings.value("searchMesh", search_->currentText()).toString());
  confirm_->setCurrentText(settings.value("confirmMesh", confirm_->currentText()).toString());
  evaluations_->setValue(settings.value("evaluations", evaluations_->value()).toInt());
}

}  // namespace squat::studio
