// widgets/studio/profile/ShapeControls.h - shape of the defect and a slider for each of its measures.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>
#include <string>
#include <vector>

namespace squat::studio {

class EditedDefect;

// Which measures are shown follows the shape; their ranges come from the parameter table.
class ShapeControls : public QWidget {
  Q_OBJECT
 public:
  explicit ShapeControls(EditedDefect& defect, QWidget* parent = nullptr);

 private:
  struct Measure {
    std::string key;
    QWidget* row;
    QSlider* slider;
    QDoubleSpinBox* number;
    double from, to;  // of the slider: the usual part of the allowed range
  };
  void addMeasure(const std::string& key, double from, double to);
  void setMeasure(const Measure& measure, double value, int gesture);
  void update();

  EditedDefect& defect_;
  QComboBox *shape_, *lateral_;
  std::vector<Measure> measures_;
  int gesture_ = 0;
};

}  // namespace squat::studio
