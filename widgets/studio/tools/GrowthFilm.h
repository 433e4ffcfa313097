// widgets/studio/tools/GrowthFilm.h - the rail's profile from stage to stage, by a slider or as a film.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "growth/Grow.h"
#include "plots/Style.h"

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

  void showGrowth(std::shared_ptr<const growth::Growth> growth);  // at its last stage
  void setStyle(const plots::Style& style);

 private:
  void draw();
  void play();
  void stop();
  void advance();

  plots::Style style_;
  std::shared_ptr<const growth::Growth> growth_;
  QSlider* stage_;
  QPushButton* play_;
  QLabel* says_;
  QVBoxLayout* layout_;
  plots::Figure* figure_ = nullptr;
  QTimer timer_;
};

}  // namespace squat::studio
