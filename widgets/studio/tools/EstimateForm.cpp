#include "studio/tools/EstimateForm.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>

#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "estimation/EstimateFiles.h"
#include "estimation/EstimateSummary.h"
#include "estimation/Estimation.h"
#include "plots/EstimateFigure.h"
#include "studies/Jobs.h"
#include "studio/common/NumberBox.h"
#include "studio/tools/MeshBox.h"
#include "studio/tools/TargetList.h"

namespace squat::studio {
namespace {

ToolResult computeEstimate(estimation::EstimateDefinition definition, const std::string& mesh,
                           const ChosenTargets& chosen, const ToolInput& input, Monitor& monitor) {
  makeFolder(input.folder);
  const FolderLock owner(input.folder, "Squat Studio, estimate");
  const auto files = estimation::estimateFiles(input.folder);
  definition.files = chosen.files;
  for (auto& path : writeMeasured(chosen, input.folder)) definition.files.push_back(std::move(path));
  definition.caseName = keepCase(input, {});
  definition.overrides.preset = mesh;
  auto inputs = definition.files;
  inputs.insert(inputs.end(), input.files.begin(), input.files.end());
  keepInputs(inputs, files);
  const auto sharing = studies::shareMachine(studies::thisMachine(), studies::demandOnMesh(mesh));
  estimation::EstimateOptions options;
  options.jobs = sharing.jobs, options.threads = sharing.threads;
  const auto found =
      std::make_shared<const estimation::Estimate>(estimation::estimateProfile(definition, options, monitor));
  ToolResult result;
  result.complete = found->complete;
  if (found->profile.empty()) {
    result.fate = "No profile was found yet.";
    return result;
  }
  estimation::writeEstimate(*found, input.folder);
  result.text = (found->complete ? "" : "Not finished; the best so far:\n\n") + estimation::estimateSummary(*found);
  result.files = files;
  result.foundCase = files.at(1);
  result.figures = [found](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::estimateFigure(*found, style));
    return sheets;
  };
  return result;
}

}  // namespace

EstimateForm::EstimateForm(const RunStore& store, QWidget* parent)
    : ToolForm(parent),
      passages_(new TargetList(store, TargetList::Offer::passages, this)),
      mesh_(meshBox(tr("Mesh of the runs"), "estimateMesh", "tiny", this)),
      longest_(new NumberBox(this)) {
  longest_->setObjectName("longest");
  longest_->setAccessibleName(tr("Longest dip to look for"));
  longest_->setRange(20, 200);
  longest_->setDecimals(0);
  longest_->setValue(70);
  longest_->setSuffix(" mm");
  auto* row = new QHBoxLayout;
  row->addWidget(mesh_);
  row->addWidget(new QLabel(tr("longest dip:"), this));
  row->addWidget(longest_);
  row->addStretch(1);
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(passages_->list()->model(), signal, this, &ToolForm::edited);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Passages:"), passages_);
  layout->addRow(tr("Mesh:"), row);
}

QString EstimateForm::explanation() const {
  return tr(
      "Looks for the profile that explains measured passages over one defect, with the vehicle and the track of "
      "the open case. The defect of the case is ignored.");
}

QString EstimateForm::missing() const {
  return passages_->chosen().isEmpty() ? tr("No passage is chosen. Add a measured passage.") : QString();
}

ToolWork EstimateForm::work() {
  estimation::EstimateDefinition definition;
  definition.longest = 1e-3 * longest_->value();
  return [definition, mesh = mesh_->currentText().toStdString(), chosen = passages_->chosen()](const ToolInput& input,
                                                                                               Monitor& monitor) {
    return computeEstimate(definition, mesh, chosen, input, monitor);
  };
}

void EstimateForm::save(QSettings& settings) const {
  settings.setValue("mesh", mesh_->currentText());
  settings.setValue("longest", longest_->value());
}

void EstimateForm::restore(const QSettings& settings) {
  mesh_->setCurrentText(settings.value("mesh", mesh_->currentText()).toString());
  longest_->setValue(settings.value("longest", longest_->value()).toDouble());
}

}  // namespace squat::studio
