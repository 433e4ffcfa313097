#include "studio/runs/AlignDialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <exception>

#include "studio/common/FixedLabel.h"
#include "studio/common/NumberBox.h"
#include "studio/runs/AlignCommand.h"

namespace squat::studio {
namespace {

constexpr double farthest = 1e6;              // [mm]
constexpr double slowest = 1, fastest = 200;  // [m/s]

bool differs(const QDoubleSpinBox& box, double value) {
  return std::abs(box.value() - value) > 0.5 * std::pow(10.0, -box.decimals());
}

}  // namespace

AlignDialog::AlignDialog(RunStore& store, int row, QWidget* parent)
    : QDialog(parent),
      store_(store),
      measured_{store.at(row).record, store.at(row).reading},
      first_(measured_),
      shown_(measured_.record),
      problem_(new FixedLabel(2, this)) {
  setObjectName("alignDialog");
  setWindowTitle(tr("Align “%1”").arg(store.at(row).label));
  // Broken by hand: a label that wraps by itself takes room from the numbers below.
  auto* words = new QLabel(tr("Type the values, or drag the\nsignal along the track in the figure."), this);
  position_ = numberOf("alignPosition", tr("Position of the largest value"), tr("mm"), -farthest, farthest, 1);
  speed_ = numberOf("alignSpeed", tr("Speed"), tr("m/s"), slowest, fastest, 3);
  gain_ = numberOf("alignGain", tr("Gain"), QString(), project::minimumGain, project::maximumGain, 3);
  gain_->setSingleStep(0.05);
  speed_->setSingleStep(0.1);
  auto* form = new QFormLayout;
  form->addRow(tr("&Position of the largest value:"), position_);
  form->addRow(tr("&Speed:"), speed_);
  form->addRow(tr("&Gain:"), gain_);
  const bool ownPositions = measured_.record->chainage || !(measured_.reading.options.speed > 0);
  speed_->setEnabled(!ownPositions);
  if (ownPositions) {
    speed_->setToolTip(tr("The file has positions or a speed of its own"));
    speed_->setSpecialValueText(tr("from file"));
  }
  auto* buttons = new QDialogButtonBox(this);
  auto* automatic = buttons->addButton(tr("&Automatic"), QDialogButtonBox::ResetRole);
  automatic->setObjectName("alignAutomatic");
  automatic->setToolTip(tr("Where it matches the current run best; no gain"));
  auto* back = buttons->addButton(tr("As &before"), QDialogButtonBox::ResetRole);
  back->setObjectName("alignBack");
  buttons->addButton(QDialogButtonBox::Close);  // last, as it stands: else Tab goes round between the other two
  // Return enters a number; it presses no button.
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(automatic, &QPushButton::clicked, this, &AlignDialog::layAutomatically);
  connect(back, &QPushButton::clicked, this, [this] { lay(first_.reading); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&store_, &RunStore::rowsRemoved, this, [this] {
    if (this->row() < 0) reject();
  });
  connect(&store_, &RunStore::modelReset, this, &QDialog::reject);
  connect(&store_, &RunStore::dataChanged, this, [this] {
    if (isVisible() && this->row() < 0) reject();  // an earlier step is undone: it lies as nothing here says
  });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words);
  layout->addLayout(form);
  layout->addWidget(problem_);
  layout->addWidget(buttons);
  showValues();
  for (auto* box : {position_, speed_, gain_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &AlignDialog::layAsTyped);
}

QDoubleSpinBox* AlignDialog::numberOf(const QString& name, const QString& label, const QString& unit, double low,
                                      double high, int decimals) {
  auto* box = new NumberBox(this);
  box->setObjectName(name);
  box->setAccessibleName(label);
  box->setRange(low, high);
  box->setDecimals(decimals);
  if (!unit.isEmpty()) box->setSuffix(" " + unit);
  box->setKeyboardTracking(false);  // a number is taken when it is typed whole
  return box;
}

void AlignDialog::showValues() {
  const QSignalBlocker noPosition(position_), noSpeed(speed_), noGain(gain_);
  position_->setValue(measured_.reading.impact * 1e3);
  speed_->setValue(speed_->isEnabled() ? measured_.reading.options.speed : speed_->minimum());
  gain_->setValue(measured_.reading.gain);
}

void AlignDialog::layAsTyped() {
  project::MeasuredReading wanted = measured_.reading;
  // Boxes show rounded numbers: what was not changed keeps all its digits.
  if (differs(*position_, wanted.impact * 1e3)) wanted.impact = position_->value() * 1e-3, wanted.isAutomatic = false;
  if (differs(*gain_, wanted.gain)) wanted.gain = gain_->value();
  if (speed_->isEnabled() && differs(*speed_, wanted.options.speed)) wanted.options.speed = speed_->value();
  lay(wanted, wanted.isAutomatic ? store_.currentResult().get() : nullptr);
}

// Where the file cannot be read any more, all stays as it was.
void AlignDialog::lay(const project::MeasuredReading& wanted, const signals::Record* beside) {
  const int at = row();
  if (at < 0) return;
  problem_->clear();
  try {
    measured_ = project::realigned(measured_, wanted, beside);
  } catch (const std::exception& error) {
    problem_->warn(QString::fromStdString(error.what()));
  }
  shown_ = measured_.record;
  store_.setMeasured(at, measured_);
  showValues();
}

void AlignDialog::layAutomatically() {
  auto wanted = first_.reading;
  wanted.impact = 0, wanted.gain = 1, wanted.isAutomatic = true;
  lay(wanted, store_.currentResult().get());
}

void AlignDialog::done(int result) {
  if (const int at = row(); at >= 0 && store_.at(at).dragged) lay(measured_.reading);
  if (const int at = row(); at >= 0 && !isSameAlignment(first_.reading, measured_.reading)) Q_EMIT aligned(at, first_);
  QDialog::done(result);
}

void AlignDialog::shift(double metres, bool done) {
  const int at = row();
  if (at < 0 || (metres == 0 && !store_.at(at).dragged)) return;  // a click drags nothing
  auto reading = measured_.reading;
  reading.impact += metres, reading.isAutomatic = false;
  if (done) return lay(reading);
  const QSignalBlocker quiet(position_);
  position_->setValue(reading.impact * 1e3);
  shown_ = project::moved(*measured_.record, metres);
  store_.setMeasured(at, {shown_, reading}, true);
}

}  // namespace squat::studio
