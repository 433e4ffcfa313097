// widgets/studio/tools/GrowthFilm.h - the rail's profile from stage to stage, by a slider or as a film, and the curves
// against tonnage; both grow while the growth is computed.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "growth/Grow.h"
#include "plots/Style.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace squat::plots {
class Figure;
}

namespace squat::studio {

class GrowthFilm : public QWidget {
  Q_OBJECT
 public:
  explicit GrowthFilm(const plots::Style& style, QWidget* parent = nullptr);

  // Of traffic up to `tonnage` [kg]; at its last stage.
  void showGrowth(std::shared_ptr<const growth::Growth> growth, double tonnage);
  // A growth that is still computed. An earlier stage that the user looks at, or a film that plays, is left alone.
  void follow(std::shared_ptr<const growth::Growth> growth, double tonnage);
  void setStyle(const plots::Style& style);

 private:
  void take(std::shared_ptr<const growth::Growth> growth, double tonnage, int stage);
  void draw();
  void drawCurves();
  void play();
  void stop();
  void advance();

  plots::Style style_;
  std::shared_ptr<const growth::Growth> growth_;
  QSlider* stage_;
  QPushButton* play_;
  QLabel* says_;
  QWidget* figures_;
  QGridLayout* grid_;  // of the figures: the profile, and the curves beside it
  QVBoxLayout* layout_;
  double tonnage_ = 0;
  QTimer timer_;
};

}  // namespace squat::studio
