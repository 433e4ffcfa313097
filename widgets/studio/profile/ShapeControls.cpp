#include "studio/profile/ShapeControls.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <map>
#include <set>

#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "studio/common/EditorHabits.h"
#include "studio/common/NumberBox.h"
#include "studio/common/Words.h"
#include "studio/profile/EditedDefect.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {
namespace {

constexpr int sliderSteps = 500;

// Measures of each shape, besides half_width, which belongs to the parabolic lateral shape.
const std::map<std::string, std::set<std::string>>& measuresOf() {
  static const std::map<std::string, std::set<std::string>> table{
      {"none", {}},
      {"cut", {"defect.length", "defect.depth", "defect.ramp"}},
      {"cosine", {"defect.length", "defect.depth"}},
      {"w-shape", {"defect.length", "defect.depth", "defect.middle_height"}},
      {"dip-with-wave",
       {"defect.length", "defect.depth", "defect.wave_length", "defect.wave_depth", "defect.wave_count"}},
      {"profile", {"defect.height_scale"}}};
  return table;
}

QComboBox* choiceBox(const std::string& key, EditedDefect& edited, QWidget* parent) {
  auto* box = new QComboBox(parent);
  if (const auto* parameter = cases::findParameter(key))
    for (const auto& name : parameter->choices) box->addItem(QString::fromStdString(name));
  box->setObjectName("shape " + QString::fromStdString(key));
  box->setAccessibleName(QString::fromStdString(key));
  QObject::connect(box, &QComboBox::activated, box, [&edited, key, box] {
    const std::string chosen = box->currentText().toStdString();
    // A sampled profile needs points: those of the shape seen so far.
    if (key == "defect.shape" && chosen == "profile" && edited.description().defect.points.empty() &&
        edited.description().defect.lines.empty())
      edited.edit(QObject::tr("Convert the shape into points"), asPoints(edited.description()));
    else
      edited.setParameter(key, chosen);
  });
  return box;
}

}  // namespace

ShapeControls::ShapeControls(EditedDefect& defect, QWidget* parent) : QWidget(parent), defect_(defect) {
  shape_ = choiceBox("defect.shape", defect, this);
  lateral_ = choiceBox("defect.lateral", defect, this);
  auto* top = new QGridLayout;
  top->addWidget(new QLabel(tr("Shape"), this), 0, 0);
  top->addWidget(shape_, 0, 1);
  top->addWidget(new QLabel(tr("Across the rail"), this), 1, 0);
  top->addWidget(lateral_, 1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addLayout(top);
  addMeasure("defect.length", 5, 120);
  addMeasure("defect.depth", 0, 0.6);
  addMeasure("defect.ramp", 0.5, 20);
  addMeasure("defect.middle_height", 0, 1);
  addMeasure("defect.wave_length", 10, 80);
  addMeasure("defect.wave_depth", 0, 0.3);
  addMeasure("defect.wave_count", 0, 6);
  addMeasure("defect.height_scale", 0, 3);
  addMeasure("defect.half_width", 4, 36);
  letWheelPass(*this);
  leaveUndoToWindow(*this);
  connect(&defect_, &EditedDefect::changed, this, &ShapeControls::update);
  update();
}

void ShapeControls::addMeasure(const std::string& key, double from, double to) {
  const cases::Parameter* parameter = cases::findParameter(key);
  if (!parameter) return;
  const QString name = QString::fromStdString(key);
  auto* row = new QWidget(this);
  auto* slider = new QSlider(Qt::Horizontal, row);
  slider->setRange(0, sliderSteps);
  slider->setAccessibleName(name);
  slider->setObjectName("slider " + name);
  slider->setToolTip(QString::fromStdString(parameter->doc));
  auto* number = new NumberBox(row);
  number->setRange(parameter->minimum, parameter->maximum);
  number->setDecimals(parameter->integer ? 0 : 3);
  number->setSingleStep(parameter->integer ? 1 : (to - from) / 50);
  number->setKeyboardTracking(false);
  number->setAccessibleName(name);
  number->setObjectName("number " + name);
  number->setSuffix(parameter->unit == "-" ? QString() : " " + printedUnits(QString::fromStdString(parameter->unit)));
  auto* grid = new QGridLayout(row);
  grid->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(parameterLabel(key), row);
  label->setBuddy(number);
  grid->addWidget(label, 0, 0);
  grid->addWidget(number, 0, 1);
  grid->addWidget(slider, 1, 0, 1, 2);
  layout()->addWidget(row);
  const std::size_t index = measures_.size();
  measures_.push_back({key, row, slider, number, from, to});
  connect(slider, &QSlider::sliderPressed, this, [this] { gesture_ = defect_.newGesture(); });
  connect(slider, &QSlider::sliderReleased, this, [this] { gesture_ = 0; });
  connect(slider, &QSlider::valueChanged, this, [this, index](int step) {
    const Measure& measure = measures_[index];
    const double value = measure.from + (measure.to - measure.from) * step / sliderSteps;
    setMeasure(measure, QString::number(value, 'g', 4).toDouble(), gesture_);  // a slider gives round numbers
  });
  connect(number, &QDoubleSpinBox::valueChanged, this,
          [this, index](double value) { setMeasure(measures_[index], value, 0); });
}

void ShapeControls::setMeasure(const Measure& measure, double value, int gesture) {
  const cases::Parameter* parameter = cases::findParameter(measure.key);
  cases::CaseDescription after = defect_.description();
  const QString text = parameter->integer ? QString::number(std::lround(value)) : QString::number(value, 'g', 12);
  if (cases::trySetValue(after, *parameter, text.toStdString())) return;
  defect_.edit(tr("Change %1").arg(QString::fromStdString(measure.key)), after, gesture);
}

void ShapeControls::update() {
  const auto& description = defect_.description();
  const auto* shape = cases::findParameter("defect.shape");
  const std::string name = cases::valueText(description, *shape);
  shape_->setCurrentText(QString::fromStdString(name));
  lateral_->setCurrentIndex(static_cast<int>(description.defect.lateral));
  const auto shown = measuresOf().find(name);
  for (const Measure& measure : measures_) {
    const bool wanted = measure.key == "defect.half_width"
                            ? description.defect.lateral == cases::LateralShape::parabolic
                            : shown != measuresOf().end() && shown->second.count(measure.key) > 0;
    measure.row->setVisible(wanted);
    const double value = cases::numberInUnit(description, *cases::findParameter(measure.key));
    const QSignalBlocker quietSlider(measure.slider), quietNumber(measure.number);
    measure.number->setValue(value);
    measure.slider->setValue(
        static_cast<int>(std::lround(sliderSteps * (value - measure.from) / (measure.to - measure.from))));
  }
}

}  // namespace squat::studio
