#include "studio/profile/ImportDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/Errors.h"
#include "studio/common/HeadTable.h"
#include "studio/common/NumberBox.h"

namespace squat::studio {
namespace {

constexpr qint64 largestFile = 20 << 20;

QComboBox* box(QWidget* parent, const QList<QPair<QString, QVariant>>& entries) {
  auto* combo = new QComboBox(parent);
  for (const auto& [text, value] : entries) combo->addItem(text, value);
  return combo;
}

void choose(QComboBox* combo, const QVariant& value) {
  const int index = combo->findData(value);
  if (index >= 0) combo->setCurrentIndex(index);
}

}  // namespace

ImportDialog::ImportDialog(const QString& path, const plots::Style& style, QWidget* parent)
    : QDialog(parent), path_(path), plot_(new plots::Figure("import", style, this)) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw FileError(path.toStdString(), "", "cannot be read: " + file.errorString().toStdString());
  if (file.size() > largestFile)
    throw FileError(path.toStdString(), "", "is larger than 20 MB", "a profile has a few hundred points");
  text_ = file.readAll().toStdString();
  makeControls();
  showSuggestion();
  update();
  resize(860, 520);
}

void ImportDialog::makeControls() {
  delimiter_ = box(
      this,
      {{tr("comma"), ','}, {tr("semicolon"), ';'}, {tr("tab"), '\t'}, {tr("space"), ' '}, {tr("vertical bar"), '|'}});
  const QList<QPair<QString, QVariant>> units{{"m", 1.0},  {"cm", 1e-2},     {"mm", 1e-3},  {"µm", 1e-6},
                                              {"km", 1e3}, {"inch", 0.0254}, {"ft", 0.3048}};
  positionUnit_ = box(this, units);
  heightUnit_ = box(this, units);
  levelling_ = box(this, {{tr("line through the ends"), 1}, {tr("least-squares line"), 2}, {tr("none"), 0}});
  positionColumn_ = new QSpinBox(this);
  heightColumn_ = new QSpinBox(this);
  for (QSpinBox* column : {positionColumn_, heightColumn_}) column->setRange(1, 50);
  heightColumn_->setValue(2);
  scale_ = new NumberBox(this);
  scale_->setObjectName("importScale");
  scale_->setRange(0.01, 100);
  scale_->setValue(1);
  step_ = new NumberBox(this);
  step_->setObjectName("importStep");
  step_->setRange(0, 50);
  step_->setSuffix(" mm");
  step_->setSpecialValueText(tr("as measured"));
  comma_ = new QCheckBox(tr("decimal comma"), this);
  flip_ = new QCheckBox(tr("heights positive downwards"), this);
  reverse_ = new QCheckBox(tr("reverse direction"), this);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  table_ = makeHeadTable(this);
  plot_->xAxis->setLabel(tr("Position [mm]"));
  plot_->yAxis->setLabel(tr("Height [µm]"));
  plot_->setMinimumSize(320, 200);  // the labels of its axes have room
  plot_->setAccessibleName(tr("The profile as it is imported"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Delimiter"), delimiter_);
  form->addRow(QString(), comma_);
  form->addRow(tr("&Position: column"), positionColumn_);
  form->addRow(tr("Position: &unit"), positionUnit_);
  form->addRow(tr("&Height: column"), heightColumn_);
  form->addRow(tr("Height: u&nit"), heightUnit_);
  form->addRow(tr("Remove &line"), levelling_);
  form->addRow(tr("Height &scale"), scale_);
  form->addRow(tr("&Resample every"), step_);
  form->addRow(QString(), flip_);
  form->addRow(QString(), reverse_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  take_ = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
  take_->setObjectName("takeProfile");
  auto* seen = new QVBoxLayout;
  seen->addWidget(table_, 2);
  seen->addWidget(plot_, 3);
  seen->addWidget(message_);
  auto* both = new QHBoxLayout;
  both->addLayout(form);
  both->addLayout(seen, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(both);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QComboBox* combo : {delimiter_, positionUnit_, heightUnit_, levelling_})
    connect(combo, &QComboBox::currentIndexChanged, this, &ImportDialog::update);
  for (QSpinBox* number : {positionColumn_, heightColumn_})
    connect(number, &QSpinBox::valueChanged, this, &ImportDialog::update);
  for (QDoubleSpinBox* number : {scale_, step_})
    connect(number, &QDoubleSpinBox::valueChanged, this, &ImportDialog::update);
  for (QCheckBox* check : {comma_, flip_, reverse_}) connect(check, &QCheckBox::toggled, this, &ImportDialog::update);
}

bool ImportDialog::levelsThroughEnds() const {
  return levelling_->currentData().toInt() == static_cast<int>(Levelling::throughEnds);
}

void ImportDialog::showSuggestion() {
  const ImportChoices suggested = suggestedChoices(text_);
  choose(delimiter_, suggested.delimiter);
  choose(positionUnit_, suggested.positionUnit);
  choose(heightUnit_, suggested.heightUnit);
  comma_->setChecked(suggested.decimalComma);
}

void ImportDialog::update() {
  ImportChoices choices;
  choices.delimiter = static_cast<char>(delimiter_->currentData().toInt());
  choices.decimalComma = comma_->isChecked();
  choices.positionColumn = positionColumn_->value() - 1;
  choices.heightColumn = heightColumn_->value() - 1;
  choices.positionUnit = positionUnit_->currentData().toDouble();
  choices.heightUnit = heightUnit_->currentData().toDouble();
  choices.levelling = static_cast<Levelling>(levelling_->currentData().toInt());
  choices.flip = flip_->isChecked();
  choices.reverse = reverse_->isChecked();
  choices.heightScale = scale_->value();
  choices.resampleStep = step_->value() * 1e-3;
  profile_ = importProfile(text_, choices);
  showHead(*table_, profile_.head, profile_.columns);
  plot_->clearGraphs();
  QCPGraph* graph = plot_->addGraph();
  graph->setPen(QPen(plot_->style().curve(0), 1.4));
  if (profile_.points.size() < 500) graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4));
  if (profile_.problem.empty())
    for (const auto& point : profile_.points) graph->addData(point.position * 1e3, point.height * 1e6);
  plot_->rescaleAxes();
  plot_->yAxis->scaleRange(1.15);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  message_->setText(profile_.problem.empty() ? tr("%n points", nullptr, static_cast<int>(profile_.points.size()))
                                             : QString::fromStdString(profile_.problem));
  if (take_) take_->setEnabled(profile_.problem.empty());
}

}  // namespace squat::studio
