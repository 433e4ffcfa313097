#include "studio/tools/ReceptanceForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <optional>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/DurableFile.h"
#include "plots/DecayFigures.h"
#include "plots/ReceptanceFigures.h"
#include "receptance/DecayFiles.h"
#include "receptance/ReceptanceFiles.h"
#include "receptance/ReceptanceSummary.h"

namespace squat::studio {
namespace {

using receptance::ReceptanceQuantity;

constexpr int decayRates = 3;  // in the list, behind the quantities

ToolResult computeReceptance(receptance::ReceptanceOptions options, ReceptanceQuantity quantity, bool lateral,
                             const ToolInput& input, Monitor& monitor) {
  makeFolder(input.folder);  // whether it can be written is known before it takes time
  keepInputs(input.files, receptance::receptanceFiles(input.folder + "/" + input.name));
  if (lateral) {
    const double midspan = -input.description.track.sleeperSpacing / 2;
    options.places = {{"lateral, over a sleeper", 0, 0, receptance::RailDirection::lateral},
                      {"lateral, midspan", midspan, midspan, receptance::RailDirection::lateral}};
  }
  const auto found = std::make_shared<receptance::TrackReceptance>(
      receptance::trackReceptance(cases::resolve(input.description), options, monitor));
  ToolResult result;
  result.complete = found->complete;
  if (!found->complete) return result;
  result.text = receptance::receptanceSummary(*found, quantity);
  const std::string stem = input.folder + "/" + input.name;
  receptance::writeReceptanceFiles(stem, *found, cases::writeCase(input.description), quantity);
  result.files = receptance::receptanceFiles(stem);
  result.figures = [found, quantity, name = input.name, title = input.description.title,
                    hash = cases::caseHash(input.description)](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::receptanceFigures(*found, name + "-receptance", title, hash, style, quantity));
    return sheets;
  };
  return result;
}

ToolResult computeDecay(const std::string& measuredFile, const ToolInput& input, Monitor& monitor) {
  makeFolder(input.folder);
  const std::string name = input.name + "-decay-rate", table = input.folder + "/" + name + ".csv";
  std::shared_ptr<receptance::MeasuredDecayRates> measured;
  auto inputs = input.files;
  if (!measuredFile.empty()) {
    measured = std::make_shared<receptance::MeasuredDecayRates>(receptance::readMeasuredDecayRates(measuredFile));
    inputs.push_back(measuredFile);
  }
  keepInputs(inputs, {table});
  const auto found = std::make_shared<receptance::DecayRates>(
      receptance::trackDecayRates(cases::resolve(input.description), {}, monitor));
  ToolResult result;
  result.complete = found->complete;
  if (!found->complete) return result;
  result.text = receptance::decaySummary(*found, measured.get());
  writeDurably(table, std::string_view(receptance::decayCsv(*found, measured.get())));
  result.files = {table};
  result.figures = [found, measured, name, title = input.description.title,
                    hash = cases::caseHash(input.description)](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::decayFigures(*found, measured.get(), name, title, hash, style));
    return sheets;
  };
  return result;
}

}  // namespace

ReceptanceForm::ReceptanceForm(QWidget* parent)
    : ToolForm(parent),
      quantity_(new QComboBox(this)),
      lateral_(new QCheckBox(tr("sideways"), this)),
      oneRail_(new QCheckBox(tr("one rail, as a hammer does"), this)),
      endless_(new QCheckBox(tr("endless track"), this)),
      measured_(new QLineEdit(this)) {
  quantity_->setObjectName("quantity");
  quantity_->setAccessibleName(tr("What is computed"));
  quantity_->addItems({tr("receptance"), tr("mobility"), tr("accelerance"), tr("decay rates after EN 15461")});
  lateral_->setObjectName("lateral");
  oneRail_->setObjectName("oneRail");
  endless_->setObjectName("endless");
  measured_->setObjectName("measured");
  measured_->setAccessibleName(tr("Measured decay rates"));
  measured_->setPlaceholderText(tr("measured decay rates"));
  auto* browse = new QPushButton(tr("&Measured…"), this);
  connect(browse, &QPushButton::clicked, this, &ReceptanceForm::chooseMeasured);
  auto* struck = new QHBoxLayout;
  for (auto* box : {lateral_, oneRail_, endless_}) struck->addWidget(box);
  struck->addStretch(1);
  auto* beside = new QHBoxLayout;
  beside->addWidget(quantity_);
  beside->addWidget(measured_, 1);
  beside->addWidget(browse);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Compute:"), beside);
  layout->addRow(tr("Strike:"), struck);
  // Decay rates are those of one rail of an endless track, in both directions.
  const auto show = [this, browse](int chosen) {
    const bool decay = chosen == decayRates;
    for (auto* box : {lateral_, oneRail_, endless_}) box->setEnabled(!decay);
    measured_->setEnabled(decay), browse->setEnabled(decay);
  };
  connect(quantity_, &QComboBox::currentIndexChanged, this, show);
  show(0);
}

void ReceptanceForm::chooseMeasured() {
  const auto file = QFileDialog::getOpenFileName(this, tr("Measured decay rates"), measured_->text(),
                                                 tr("Tables (*.csv *.txt);;All files (*)"));
  if (!file.isEmpty()) measured_->setText(file);
}

QString ReceptanceForm::explanation() const {
  return tr(
      "Computes the receptance of the open case's track from 50 to 2000 Hz, over a sleeper and at midspan, and "
      "the natural modes of the free wheelset; or the track decay rates from 100 to 5000 Hz.");
}

ToolWork ReceptanceForm::work() {
  if (quantity_->currentIndex() == decayRates)
    return [file = measured_->text().toStdString()](const ToolInput& input, Monitor& monitor) {
      return computeDecay(file, input, monitor);
    };
  receptance::ReceptanceOptions options;
  options.rails = oneRail_->isChecked() ? receptance::StruckRails::one : receptance::StruckRails::both;
  options.endless = endless_->isChecked();
  const auto quantity = static_cast<ReceptanceQuantity>(quantity_->currentIndex());
  return [options, quantity, lateral = lateral_->isChecked()](const ToolInput& input, Monitor& monitor) {
    return computeReceptance(options, quantity, lateral, input, monitor);
  };
}

void ReceptanceForm::save(QSettings& settings) const {
  settings.setValue("quantity", quantity_->currentIndex());
  settings.setValue("lateral", lateral_->isChecked());
  settings.setValue("oneRail", oneRail_->isChecked());
  settings.setValue("endless", endless_->isChecked());
  settings.setValue("measured", measured_->text());
}

void ReceptanceForm::restore(const QSettings& settings) {
  const int chosen = settings.value("quantity", 0).toInt();
  if (chosen >= 0 && chosen <= decayRates) quantity_->setCurrentIndex(chosen);
  lateral_->setChecked(settings.value("lateral", false).toBool());
  oneRail_->setChecked(settings.value("oneRail", false).toBool());
  endless_->setChecked(settings.value("endless", false).toBool());
  measured_->setText(settings.value("measured").toString());
}

}  // namespace squat::studio
