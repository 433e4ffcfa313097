#include "studio/model/ScenePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "scene/ModelPicture.h"
#include "scene/VtkExport.h"
#include "studio/common/ButtonKeys.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/FlowLayout.h"
#include "studio/common/LocationToSave.h"
#include "studio/common/NumberBox.h"
#include "studio/model/SceneWidget.h"

namespace squat::studio {

ScenePanel::ScenePanel(RunStore& store, bool dark, QWidget* parent)
    : QWidget(parent), store_(store), scene_(new SceneWidget(this)) {
  choices_.dark = dark;
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(makeControls());
  layout->addWidget(scene_, 1);
  layout->addWidget(makeTime());
  animation_.setInterval(120);
  connect(&animation_, &QTimer::timeout, this,
          [this] { time_->setValue(time_->value() < time_->maximum() ? time_->value() + 1 : 0); });
  connect(&store_, &RunStore::currentChanged, this, &ScenePanel::showResult);
  showResult();
}

namespace {

// Narrower than a push button: seven of them fit into a small window.
QToolButton* toolButton(const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

}  // namespace

QWidget* ScenePanel::makeControls() {
  auto* bar = new QWidget(this);
  auto* flow = new FlowLayout(bar);
  field_ = new QComboBox(bar);
  for (const auto field : {scene::Field::vonMises, scene::Field::plasticStrain, scene::Field::displacement,
                           scene::Field::contactPressure, scene::Field::stickSlip})
    field_->addItem(QString::fromStdString(scene::fieldName(field)), static_cast<int>(field));
  field_->addItem(tr("Parts"), static_cast<int>(scene::Field::none));
  field_->setAccessibleName(tr("Coloured by"));
  scale_ = new NumberBox(bar);
  scale_->setRange(0, 10000);
  scale_->setValue(1);
  scale_->setPrefix(tr("Displacement × "));
  scale_->setDecimals(0);
  scale_->setAccessibleName(tr("Displacement scale"));
  cut_ = new QCheckBox(tr("Cut"), bar);
  cut_->setToolTip(tr("Cut at the middle of the running surface to show the contact"));
  cut_->setChecked(true);
  edges_ = new QCheckBox(tr("Mesh"), bar);
  edges_->setChecked(true);
  for (QWidget* each : std::initializer_list<QWidget*>{field_, scale_, cut_, edges_}) flow->addWidget(each);
  const QList<QPair<QString, scene::StandardView>> views{{tr("All"), scene::StandardView::overview},
                                                         {tr("Contact"), scene::StandardView::contact},
                                                         {tr("Side"), scene::StandardView::side},
                                                         {tr("Front"), scene::StandardView::front},
                                                         {tr("Top"), scene::StandardView::top}};
  for (const auto& [text, view] : views) {
    auto* button = toolButton(text, bar);
    button->setAccessibleName(tr("View: %1").arg(text));
    button->setObjectName("view " + text);
    flow->addWidget(button);
    const auto chosen = view;
    // The contact is seen in the cut alone; the other views show the model whole.
    connect(button, &QToolButton::clicked, this, [this, chosen] {
      cut_->setChecked(chosen == scene::StandardView::contact);
      scene_->lookFrom(chosen);
    });
  }
  giveKeys(*bar, {{"view " + tr("All"), "Alt+1"},
                  {"view " + tr("Contact"), "Alt+2"},
                  {"view " + tr("Side"), "Alt+3"},
                  {"view " + tr("Front"), "Alt+4"},
                  {"view " + tr("Top"), "Alt+5"}});
  auto* picture = toolButton(tr("Picture…"), bar);
  flow->addWidget(picture);
  auto* series = toolButton(tr("VTK…"), bar);
  series->setToolTip(tr("Export the frames for ParaView (.pvd, .vtu)"));
  flow->addWidget(series);
  connect(series, &QToolButton::clicked, this, &ScenePanel::saveSeries);
  connect(picture, &QToolButton::clicked, this, &ScenePanel::savePicture);
  connect(field_, &QComboBox::currentIndexChanged, this, &ScenePanel::apply);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, &ScenePanel::apply);
  connect(cut_, &QCheckBox::toggled, this, &ScenePanel::apply);
  connect(edges_, &QCheckBox::toggled, this, &ScenePanel::apply);
  return bar;
}

QWidget* ScenePanel::makeTime() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  play_ = new QPushButton(tr("Play"), bar);
  play_->setCheckable(true);
  play_->setObjectName("play");
  giveKeys(*bar, {{"play", "Ctrl+Shift+P"}});
  time_ = new QSlider(Qt::Horizontal, bar);
  time_->setAccessibleName(tr("Frame"));
  time_->setObjectName("moment");
  moment_ = new QLabel(bar);
  moment_->setMinimumWidth(150);
  layout->addWidget(play_);
  layout->addWidget(time_, 1);
  layout->addWidget(moment_);
  connect(play_, &QPushButton::toggled, this, [this](bool on) {
    play_->setText(on ? tr("Stop") : tr("Play"));
    play_->setShortcut(QKeySequence("Ctrl+Shift+P"));  // the text has taken it
    on ? animation_.start() : animation_.stop();
  });
  connect(time_, &QSlider::valueChanged, this, &ScenePanel::apply);
  return bar;
}

void ScenePanel::showResult() {
  const ResultPointer result = store_.currentResult();
  const int count = result ? static_cast<int>(result->snapshots.size()) : 0;
  int shown = count - 1;
  for (int i = 0; i < count; ++i)
    if (result->snapshots[static_cast<std::size_t>(i)].name == "impact") shown = i;
  time_->setRange(0, std::max(count - 1, 0));
  time_->setEnabled(count > 1);
  play_->setEnabled(count > 1);
  if (count < 2) play_->setChecked(false);
  time_->setValue(std::max(shown, 0));
  const bool reading = result && store_.at(store_.current()).fields == Fields::inFile;
  scene_->setHint(reading  ? tr("The model of this run is being read.")
                  : result ? tr("This result holds no model.")
                           : tr("Run a case or open a result to see the model."));
  scene_->setResult(result);
  apply();
}

void ScenePanel::apply() {
  const ResultPointer result = store_.currentResult();
  const int count = result ? static_cast<int>(result->snapshots.size()) : 0;
  choices_.field = static_cast<scene::Field>(field_->currentData().toInt());
  choices_.displacementScale = scale_->value();
  choices_.cut = cut_->isChecked();
  choices_.edges = edges_->isChecked();
  choices_.snapshot = count > 0 ? time_->value() : -1;
  moment_->clear();
  if (choices_.snapshot >= 0 && choices_.snapshot < count) {
    const auto& snapshot = result->snapshots[static_cast<std::size_t>(choices_.snapshot)];
    moment_->setText(tr("%1: %2 mm, %3 ms")
                         .arg(QString::fromStdString(snapshot.name))
                         .arg(snapshot.position * 1e3, 0, 'f', 1)
                         .arg(snapshot.time * 1e3, 0, 'f', 2));
  }
  // One frame after the other is drawn as a motion, the last one in full.
  scene_->setChoices(choices_, animation_.isActive() || time_->isSliderDown());
}

void ScenePanel::setDark(bool dark) {
  choices_.dark = dark;
  apply();
}

void ScenePanel::saveSeries() {
  const ResultPointer result = store_.currentResult();
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Export frames to folder"));
  if (folder.isEmpty() || !result) return;
  try {
    scene::writeVtkSeries(*result, folder.toStdString());
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

void ScenePanel::savePicture() {
  const QString path = locationToSave(this, tr("Save picture"), "model.png", tr("PNG (*.png)"));
  if (path.isEmpty()) return;
  const auto size = storedFigureSize();
  const double width = size.width > 0 ? size.width : 170, height = size.width > 0 ? size.height : 119;  // [mm]
  const double pixels = size.resolution / 25.4;
  if (std::max(width, height) * pixels > scene::PictureSize::maximumPixels)
    return void(Q_EMIT failed(tr("The picture would have more than %1 pixels on a side: choose a lower resolution in "
                                 "Figure > Size of figures.")
                                  .arg(scene::PictureSize::maximumPixels)));
  // Letters and lines have their usual size on paper, smaller ones in a narrow picture.
  const double pixelRatio = size.resolution / 96 * std::clamp(width / 170, 0.7, 1.0);
  const QImage picture = scene_->picture(static_cast<int>(std::lround(width * pixels)),
                                         static_cast<int>(std::lround(height * pixels)), pixelRatio);
  if (picture.isNull()) return void(Q_EMIT failed(tr("The picture cannot be drawn: %1").arg(scene_->reason())));
  if (!picture.save(path, "PNG")) Q_EMIT failed(tr("%1 cannot be written").arg(path));
}

}  // namespace squat::studio
