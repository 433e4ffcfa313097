#include "studio/tools/GrowthForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QSettings>
#include <QSpinBox>
#include <optional>

#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "core/DurableFile.h"
#include "core/FolderLock.h"
#include "growth/ComputeForecast.h"
#include "growth/GrowthFiles.h"
#include "plots/GrowthFigures.h"
#include "results/Checkpoint.h"
#include "studio/common/NumberBox.h"
#include "studio/tools/GrowthFilm.h"
#include "studio/tools/KeyRows.h"
#include "studio/tools/MeshBox.h"

namespace squat::studio {
namespace {

struct GrowthChoice {
  std::string mesh, steel;
  growth::ForecastRequest forecast;  // without keys: none
  growth::GrowthOptions options;
  QPointer<GrowthFilm> film;
};

bool mayBeUncertain(const cases::Parameter& parameter) {
  return parameter.kind == cases::Kind::number && !parameter.integer && parameter.group != "mesh" &&
         parameter.group != "output";
}

// After the growth itself, as the command does. False where it was cancelled, or where growths failed: started again,
// it computes what is missing.
bool addForecast(const growth::ForecastPlan& plan, const ToolInput& input, Monitor& monitor, ToolResult& result) {
  const auto found = growth::forecastGrowth(plan, monitor);
  if (!found) {
    result.complete = false;
    return false;
  }
  const auto path = growth::forecastFiles(input.folder, input.name).table;
  writeDurably(path, growth::forecastTable(*found));
  result.files.push_back(path);
  result.text += "\n" + growth::forecastText(*found);
  const bool isWhole = found->growths == found->asked;
  if (!isWhole) result.text += "Some growths failed: start it again in the same folder to compute them again.\n";
  if (found->growths == 0) return false;
  result.figures = [before = result.figures, found, name = input.name](const plots::Style& style) {
    auto sheets = before(style);
    sheets.push_back(plots::forecastFigure(*found, name, style));
    return sheets;
  };
  return isWhole;
}

ToolResult computeGrowth(GrowthChoice choice, const ToolInput& input, Monitor& monitor) {
  makeFolder(input.folder);
  const FolderLock owner(input.folder, "Squat Studio, growth");
  keepInputs(input.files, growth::growthFiles(input.folder, input.name));
  cases::CaseOverrides overrides{choice.mesh, {}};
  if (choice.steel != cases::noPreset) overrides.values.push_back({"rail.preset", choice.steel});
  const auto kept = keepCase(input, {});
  const auto description = cases::loadCase(kept, overrides);
  auto& options = choice.options;
  std::optional<growth::ForecastPlan> plan;  // what is wrong with it is said before hours of growth
  if (!choice.forecast.uncertain.empty())
    plan = growth::forecastPlan(kept, overrides, choice.forecast, options,
                                growth::forecastFiles(input.folder, input.name).folder);
  options.checkpoint = growth::growthCheckpoint(input.folder, input.name);
  options.resume = true;
  options.finishedStage = [&](const growth::Stage& stage) { monitor.message(growth::stageLine(stage)); };
  const double tonnage = options.tonnage;
  options.soFar = [&input, tonnage, film = choice.film](const growth::Growth& growth) {
    input.show([film, tonnage, soFar = std::make_shared<const growth::Growth>(growth)] {
      if (film) film->follow(soFar, tonnage);
    });
  };
  const auto found = std::make_shared<const growth::Growth>(growth::grow(description, options, monitor));
  ToolResult result;
  result.complete = found->complete;
  if (found->stages.empty()) return result;
  result.text = growth::growthSummary(*found, options);
  result.files = growth::writeGrowthFiles(*found, input.folder, input.name);
  result.foundCase = result.files.back();
  result.show = [found, tonnage, film = choice.film] {
    if (film) film->showGrowth(found, tonnage);
  };
  result.figures = [found, name = input.name](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::growthFigure(*found, name, style));
    return sheets;
  };
  const bool isDone = found->complete && (!plan || addForecast(*plan, input, monitor, result));
  if (isDone) results::removeCheckpoint(options.checkpoint);
  return result;
}

}  // namespace

NumberBox* GrowthForm::box(const QString& name, const QString& label, double low, double high, double value,
                           const QString& suffix) {
  auto* made = new NumberBox(this);
  made->setObjectName(name);
  made->setAccessibleName(label);
  made->setRange(low, high);
  made->setDecimals(2);
  made->setValue(value);
  made->setSuffix(suffix);
  connect(made, &QDoubleSpinBox::valueChanged, this, &ToolForm::edited);
  return made;
}

GrowthForm::GrowthForm(const plots::Style& style, QWidget* parent)
    : ToolForm(parent),
      tonnage_(box("tonnage", tr("Traffic"), 0.01, 1000, 5, tr(" million tonnes"))),
      until_(box("untilDepth", tr("Depth of the dip at which it ends"), 0.01, 5, 0.5, " mm")),
      depth_(box("grindDepth", tr("Depth that is ground off"), 0.01, 5, 0.2, " mm")),
      after_(box("grindAfter", tr("Traffic before grinding"), 0.01, 1000, 2, tr(" million tonnes"))),
      steel_(new QComboBox(this)),
      mesh_(meshBox(tr("Mesh"), "growthMesh", "tiny", this)),
      stops_(new QCheckBox(tr("&until the dip is deep:"), this)),
      grinds_(new QCheckBox(tr("&grind off"), this)),
      forecasts_(new QCheckBox(tr("grow again with uncer&tain keys between limits:"), this)),
      uncertain_(new KeyRows(mayBeUncertain, KeyValues::limits, this)),
      growths_(new QSpinBox(this)),
      film_(new GrowthFilm(style, this)) {
  steel_->setObjectName("growthSteel");
  steel_->setAccessibleName(tr("Steel of the rail"));
  for (const auto& name : cases::inputPresetNames("rail.preset"))
    steel_->addItem(name == cases::noPreset ? tr("as in the case") : QString::fromStdString(name),
                    QString::fromStdString(name));
  stops_->setObjectName("growthStops");
  grinds_->setObjectName("growthGrinds");
  auto* traffic = new QHBoxLayout;
  traffic->addWidget(tonnage_);
  traffic->addWidget(stops_);
  traffic->addWidget(until_);
  traffic->addStretch(1);
  auto* grinding = new QHBoxLayout;
  grinding->addWidget(grinds_);
  grinding->addWidget(depth_);
  grinding->addWidget(new QLabel(tr("after"), this));
  grinding->addWidget(after_);
  grinding->addStretch(1);
  auto* how = new QHBoxLayout;
  how->addWidget(steel_);
  how->addWidget(new QLabel(tr("mesh:"), this));
  how->addWidget(mesh_);
  how->addStretch(1);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Traffic:"), traffic);
  layout->addRow(tr("Grinding:"), grinding);
  layout->addRow(tr("Steel:"), how);
  makeForecast(*layout);
  for (auto* check : {stops_, grinds_, forecasts_})
    connect(check, &QCheckBox::toggled, this, &GrowthForm::enableChosen);
  enableChosen();
}

void GrowthForm::makeForecast(QFormLayout& layout) {
  forecasts_->setObjectName("growthForecast");
  growths_->setObjectName("forecastGrowths");
  growths_->setAccessibleName(tr("Number of growths of the forecast"));
  growths_->setRange(2, 1000);  // as the command allows
  growths_->setValue(growth::ForecastRequest().growths);
  growths_->setSuffix(tr(" growths"));
  auto* forecast = new QHBoxLayout;
  forecast->addWidget(forecasts_);
  forecast->addWidget(growths_);
  forecast->addStretch(1);
  layout.addRow(tr("Forecast:"), forecast);
  layout.addRow(QString(), uncertain_);
  connect(forecasts_, &QCheckBox::toggled, this, &ToolForm::edited);
  connect(growths_, &QSpinBox::valueChanged, this, &ToolForm::edited);
  connect(uncertain_, &KeyRows::edited, this, &ToolForm::edited);
}

void GrowthForm::enableChosen() {
  until_->setEnabled(stops_->isChecked());
  depth_->setEnabled(grinds_->isChecked()), after_->setEnabled(grinds_->isChecked());
  growths_->setEnabled(forecasts_->isChecked()), uncertain_->setEnabled(forecasts_->isChecked());
}

QString GrowthForm::missing() const {
  if (!forecasts_->isChecked() || !uncertain_->limits().empty()) return {};
  return tr("Choose a key that is uncertain and its limits, or no forecast.");
}

void GrowthForm::showCase(const cases::CaseDescription& description) { uncertain_->showCase(description); }

QString GrowthForm::explanation() const {
  return tr(
      "Lets the defect of the open case grow under traffic: friction wears the rail, and where its steel yields it "
      "flows. Wheelsets and law of wear are those of the case (growth).");
}

ToolWork GrowthForm::work() {
  GrowthChoice choice;
  choice.film = film_;
  choice.mesh = mesh_->currentText().toStdString();
  choice.steel = steel_->currentData().toString().toStdString();
  choice.options.tonnage = tonnage_->value() * growth::kilogramsInMegatonne;
  if (stops_->isChecked()) choice.options.untilDepth = 1e-3 * until_->value();
  if (grinds_->isChecked())
    choice.options.grindings = {{1e-3 * depth_->value(), after_->value() * growth::kilogramsInMegatonne}};
  if (forecasts_->isChecked()) choice.forecast = {uncertain_->limits(), growths_->value()};
  return [choice](const ToolInput& input, Monitor& monitor) { return computeGrowth(choice, input, monitor); };
}

QWidget* GrowthForm::view() const { return film_; }

void GrowthForm::setStyle(const plots::Style& style) { film_->setStyle(style); }

void GrowthForm::save(QSettings& settings) const {
  settings.setValue("tonnage", tonnage_->value());
  settings.setValue("stops", stops_->isChecked());
  settings.setValue("until", until_->value());
  settings.setValue("grinds", grinds_->isChecked());
  settings.setValue("grindDepth", depth_->value());
  settings.setValue("grindAfter", after_->value());
  settings.setValue("steel", steel_->currentData());
  settings.setValue("mesh", mesh_->currentText());
  settings.setValue("forecasts", forecasts_->isChecked());
  settings.setValue("growths", growths_->value());
  QStringList texts;
  for (const auto& text : uncertain_->limits()) texts << QString::fromStdString(text);
  settings.setValue("uncertain", texts);
}

void GrowthForm::restore(const QSettings& settings) {
  tonnage_->setValue(settings.value("tonnage", tonnage_->value()).toDouble());
  stops_->setChecked(settings.value("stops", false).toBool());
  until_->setValue(settings.value("until", until_->value()).toDouble());
  grinds_->setChecked(settings.value("grinds", false).toBool());
  depth_->setValue(settings.value("grindDepth", depth_->value()).toDouble());
  after_->setValue(settings.value("grindAfter", after_->value()).toDouble());
  const int steel = steel_->findData(settings.value("steel"));
  if (steel >= 0) steel_->setCurrentIndex(steel);
  mesh_->setCurrentText(settings.value("mesh", mesh_->currentText()).toString());
  forecasts_->setChecked(settings.value("forecasts", false).toBool());
  growths_->setValue(settings.value("growths", growths_->value()).toInt());
  uncertain_->setTexts(settings.value("uncertain").toStringList());
}

}  // namespace squat::studio
