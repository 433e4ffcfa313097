// widgets/studio/model/ScenePanel.h - the model in 3-D with its controls.
#pragma once

#include <QTimer>
#include <QWidget>

#include "scene/SceneView.h"
#include "studio/runs/RunStore.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace squat::studio {

class SceneWidget;

class ScenePanel : public QWidget {
  Q_OBJECT
 public:
  ScenePanel(RunStore& store, bool dark, QWidget* parent = nullptr);

  SceneWidget* scene() const { return scene_; }
  void setDark(bool dark);
  void savePicture();  // ask for a place
  void saveSeries();

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  QWidget* makeControls();
  QWidget* makeTime();
  void showResult();
  void apply();

  RunStore& store_;
  SceneWidget* scene_;
  scene::SceneChoices choices_;
  QComboBox* field_;
  QDoubleSpinBox* scale_;
  QCheckBox *cut_, *edges_;
  QSlider* time_;
  QLabel* moment_;
  QPushButton* play_;
  QTimer animation_;
};

}  // namespace squat::studio
