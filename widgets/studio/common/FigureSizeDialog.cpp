#include "studio/common/FigureSizeDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>
#include <array>

#include "studio/common/NumberBox.h"

namespace squat::studio {
namespace {

struct Preset {
  const char* name;
  double width, height;  // [mm]
};

// The last one is what the user types.
constexpr std::array<Preset, 5> presets{{{QT_TR_NOOP("Each figure's own"), 0, 0},
                                         {QT_TR_NOOP("One column"), 85, 60},
                                         {QT_TR_NOOP("Two columns"), 170, 90},
                                         {QT_TR_NOOP("Slide"), 254, 143},
                                         {QT_TR_NOOP("Other"), -1, -1}}};
constexpr int last = static_cast<int>(presets.size()) - 1;

using plots::PrintedSize;

QDoubleSpinBox* numberIn(QFormLayout& form, const QString& label, const QString& name, const QString& unit, double low,
                         double high) {
  auto* box = new NumberBox;
  box->setObjectName(name);
  box->setAccessibleName(QString(label).remove('&'));
  box->setRange(low, high);
  box->setDecimals(0);
  box->setSuffix(" " + unit);
  form.addRow(label, box);
  return box;
}

int presetOf(const plots::PrintedSize& size) {
  for (int row = 0; row < last; ++row)
    if (presets[static_cast<std::size_t>(row)].width == size.width &&
        presets[static_cast<std::size_t>(row)].height == size.height)
      return row;
  return last;
}

}  // namespace

FigureSizeDialog::FigureSizeDialog(const plots::PrintedSize& size, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Size of figures"));
  // Broken by hand: a label that wraps by itself takes room from the numbers below.
  auto* words =
      new QLabel(tr("Figures and pictures of the model are copied and exported\n"
                    "in this size, whatever the size of the window."));
  auto* form = new QFormLayout;
  preset_ = new QComboBox;
  preset_->setObjectName("figurePreset");
  preset_->setAccessibleName(tr("Size"));
  for (const auto& preset : presets) preset_->addItem(tr(preset.name));
  form->addRow(tr("&Size"), preset_);
  width_ = numberIn(*form, tr("&Width"), "figureWidth", tr("mm"), PrintedSize::minimumWidth, PrintedSize::maximumSide);
  height_ =
      numberIn(*form, tr("&Height"), "figureHeight", tr("mm"), PrintedSize::minimumHeight, PrintedSize::maximumSide);
  resolution_ = numberIn(*form, tr("&Resolution of PNG"), "figureResolution", tr("dpi"), PrintedSize::minimumResolution,
                         PrintedSize::maximumResolution);
  width_->setValue(size.width > 0 ? size.width : 85);
  height_->setValue(size.height > 0 ? size.height : 60);
  resolution_->setValue(size.resolution);
  connect(preset_, &QComboBox::currentIndexChanged, this, &FigureSizeDialog::takePreset);
  preset_->setCurrentIndex(presetOf(size));
  takePreset(preset_->currentIndex());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words);
  layout->addLayout(form);
  layout->addWidget(buttons);
}

void FigureSizeDialog::takePreset(int row) {
  const bool typed = row == last;
  if (row > 0 && !typed) {
    width_->setValue(presets[static_cast<std::size_t>(row)].width);
    height_->setValue(presets[static_cast<std::size_t>(row)].height);
  }
  width_->setEnabled(typed);
  height_->setEnabled(typed);
}

plots::PrintedSize FigureSizeDialog::size() const {
  if (preset_->currentIndex() == 0) return {0, 0, resolution_->value()};
  return {width_->value(), height_->value(), resolution_->value()};
}

plots::PrintedSize storedFigureSize() {
  const QSettings settings;
  const plots::PrintedSize otherwise;
  const double width = settings.value("figure/width", 0).toDouble(),
               height = settings.value("figure/height", 0).toDouble();
  const double resolution = settings.value("figure/resolution", otherwise.resolution).toDouble();
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  plots::PrintedSize size;
  if (within(width, PrintedSize::minimumWidth, PrintedSize::maximumSide) &&
      within(height, PrintedSize::minimumHeight, PrintedSize::maximumSide))
    size.width = width, size.height = height;
  if (within(resolution, PrintedSize::minimumResolution, PrintedSize::maximumResolution)) size.resolution = resolution;
  return size;
}

void storeFigureSize(const plots::PrintedSize& size) {
  QSettings settings;
  settings.setValue("figure/width", size.width);
  settings.setValue("figure/height", size.height);
  settings.setValue("figure/resolution", size.resolution);
}

}  // namespace squat::studio
