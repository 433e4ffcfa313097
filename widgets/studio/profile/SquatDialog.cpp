#include "studio/profile/SquatDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "case/ParameterTable.h"
#include "case/Validation.h"
#include "plots/LineFigure.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/NumberBox.h"
#include "studio/common/Words.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {
namespace {

struct Usual {
  double length, depth;  // [m]
};

// A usual size of each class; the severe one is that of the case class-c-squat.
constexpr std::array<Usual, 3> usualSizes{{{0.028, 0.07e-3}, {0.048, 0.18e-3}, {0.057, 0.30e-3}}};

constexpr std::array<cases::DefectShape, 4> forms{cases::DefectShape::cosine, cases::DefectShape::wshape,
                                                  cases::DefectShape::dipWithWave, cases::DefectShape::cut};

QString classText(const QString& name, double length, double depth, bool beyond) {
  return (beyond ? QObject::tr("%1: beyond %2 mm or %3 mm deep") : QObject::tr("%1: up to %2 mm long and %3 mm deep"))
      .arg(name)
      .arg(1e3 * length, 0, 'f', 0)
      .arg(1e3 * depth, 0, 'f', 2);
}

}  // namespace

SquatDialog::SquatDialog(cases::CaseDescription base, const plots::Style& style, QWidget* parent)
    : QDialog(parent), base_(std::move(base)), style_(style), layout_(new QVBoxLayout(this)) {
  setWindowTitle(tr("Squat by class and form"));
  setObjectName("squatDialog");
  const detection::SeverityLimits limits;
  auto* form = new QFormLayout;
  severity_ = new QComboBox(this);
  severity_->setObjectName("squatClass");
  severity_->setAccessibleName(tr("Class"));
  severity_->addItem(classText(tr("Light (A)"), limits.lightLength, limits.lightDepth, false));
  severity_->addItem(classText(tr("Moderate (B)"), limits.moderateLength, limits.moderateDepth, false));
  severity_->addItem(classText(tr("Severe (C)"), limits.moderateLength, limits.moderateDepth, true));
  form->addRow(tr("&Class"), severity_);
  form_ = new QComboBox(this);
  form_->setObjectName("squatForm");
  form_->setAccessibleName(tr("Form"));
  form_->addItems({tr("Smooth dip"), tr("W shape: a ridge in the middle"), tr("Dip with waves behind it"),
                   tr("Flat cut with ramps")});
  form->addRow(tr("&Form"), form_);
  layout_->addLayout(form);
  length_ = number("squatLength", tr("Length"), 5, 150);
  depth_ = number("squatDepth", tr("Depth"), 0.01, 1);
  length_->setDecimals(0);
  depth_->setDecimals(2);
  depth_->setSingleStep(0.01);
  form->addRow(tr("&Length"), length_);
  form->addRow(tr("&Depth"), depth_);
  problem_ = new FixedLabel(2, this);
  problem_->setObjectName("squatProblem");
  layout_->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout_->addWidget(buttons);
  takeSeverity(0);
  connect(severity_, &QComboBox::activated, this, &SquatDialog::takeSeverity);
  connect(form_, &QComboBox::activated, this, &SquatDialog::draw);
  for (QDoubleSpinBox* box : {length_, depth_}) connect(box, &QDoubleSpinBox::valueChanged, this, &SquatDialog::draw);
  resize(480, 460);
}

QDoubleSpinBox* SquatDialog::number(const QString& name, const QString& label, double low, double high) {
  auto* box = new NumberBox(this);
  box->setObjectName(name);
  box->setAccessibleName(label);
  box->setRange(low, high);
  box->setSuffix(tr(" mm"));
  return box;
}

detection::Severity SquatDialog::severity() const {
  constexpr double rounding = 1e-9;  // [m] of numbers typed in mm
  return detection::severityOf(1e-3 * length_->value() - rounding, 1e-3 * depth_->value() - rounding);
}

void SquatDialog::takeSeverity(int severity) {
  const Usual& usual = usualSizes[static_cast<std::size_t>(severity)];
  const QSignalBlocker quietLength(length_), quietDepth(depth_);
  length_->setValue(1e3 * usual.length);
  depth_->setValue(1e3 * usual.depth);
  draw();
}

cases::CaseDescription SquatDialog::description() const {
  const cases::CaseDescription defaults = cases::defaultCase();
  cases::CaseDescription after = base_;
  auto& defect = after.defect;
  defect.shape = forms[static_cast<std::size_t>(form_->currentIndex())];
  defect.length = 1e-3 * length_->value();
  defect.depth = 1e-3 * depth_->value();
  // What a squat of this size usually has beside; the sliders change it afterwards. Keys of the other forms would have
  // no effect: they are left as they are.
  if (defect.shape == cases::DefectShape::cut) defect.ramp = std::min(defaults.defect.ramp, 0.25 * defect.length);
  if (defect.shape == cases::DefectShape::wshape) defect.middleHeight = defaults.defect.middleHeight;
  if (defect.shape == cases::DefectShape::dipWithWave) {
    defect.waveLength = defaults.defect.waveLength;
    defect.waveCount = defaults.defect.waveCount;
    defect.waveDepth = 0.2 * defect.depth;
  }
  return after;
}

// Of the squat alone: what else is wrong with the case stands in its form.
void SquatDialog::judge() {
  QString wrong;
  for (const auto& problem : cases::validate(description()).problems)
    if (wrong.isEmpty() && problem.key.rfind("defect.", 0) == 0)
      wrong = tr("%1 must be %2. %3")
                  .arg(parameterLabel(problem.key), printedUnits(QString::fromStdString(problem.allowed)),
                       QString::fromStdString(problem.advice));
  problem_->warn(wrong);
  ok_->setEnabled(wrong.isEmpty());
}

void SquatDialog::draw() {
  const QSignalBlocker quiet(severity_);
  severity_->setCurrentIndex(static_cast<int>(severity()));
  judge();
  const ProfileView view = profileView(description());
  auto figure = std::make_unique<plots::Figure>("squat", style_);
  figure->xAxis->setLabel(tr("Along the rail [mm]"));
  figure->yAxis->setLabel(tr("Height [µm]"));
  const auto add = [&](const std::vector<cases::ProfilePoint>& points, const QString& label, std::size_t colour) {
    plots::Curve curve;
    for (const auto& point : points) {
      curve.x.push_back(1e3 * point.position);
      curve.y.push_back(1e6 * point.height);
    }
    curve.label = label;
    curve.colour = colour;
    plots::addCurve(*figure, curve);
  };
  add(view.surface, tr("rail surface"), 0);
  add(view.wheelPath, tr("path of a rigid wheel"), 1);
  const double reach = 1e3 * (description().defect.length + 0.02);
  const bool waves = description().defect.shape == cases::DefectShape::dipWithWave;
  figure->xAxis->setRange(
      -reach, waves ? reach + 1e3 * description().defect.waveLength * description().defect.waveCount : reach);
  plots::fitWithZero(*figure);
  figure->setMinimumSize(360, 220);
  figure->setAccessibleName(tr("The squat, and the path of a rigid wheel over it"));
  delete picture_;
  picture_ = figure.release();
  layout_->insertWidget(1, picture_, 1);
}

}  // namespace squat::studio
