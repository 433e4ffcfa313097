#include "studio/tools/GrowthFilm.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <utility>

#include "growth/GrowthFiles.h"
#include "plots/GrowthFigures.h"

namespace squat::studio {

namespace {

constexpr int pause = 250;  // [ms] from stage to stage

// In place of what stands there.
void placeFigure(QGridLayout& grid, int row, int column, int rows, std::unique_ptr<plots::Figure> figure) {
  if (auto* before = grid.itemAtPosition(row, column)) {
    QWidget* old = before->widget();
    grid.removeWidget(old);
    delete old;
  }
  grid.addWidget(figure.release(), row, column, rows, 1);
}

}  // namespace

GrowthFilm::GrowthFilm(const plots::Style& style, QWidget* parent)
    : QWidget(parent),
      style_(style),
      stage_(new QSlider(Qt::Horizontal, this)),
      play_(new QPushButton(tr("&Play"), this)),
      says_(new QLabel(tr("Press Start: the rail is shown here from stage to stage, as it grows."), this)),
      figures_(new QWidget(this)),
      grid_(new QGridLayout(figures_)),
      layout_(new QVBoxLayout(this)) {
  stage_->setObjectName("growthStage");
  stage_->setAccessibleName(tr("Stage of the growth"));
  play_->setObjectName("growthPlay");
  figures_->hide();
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setColumnStretch(0, 3), grid_->setColumnStretch(1, 2);
  auto* row = new QHBoxLayout;
  row->addWidget(play_);
  row->addWidget(stage_, 1);
  layout_->addWidget(says_);
  layout_->addLayout(row);
  layout_->addStretch(1);
  stage_->setEnabled(false), play_->setEnabled(false);
  timer_.setInterval(pause);
  connect(stage_, &QSlider::valueChanged, this, &GrowthFilm::draw);
  connect(play_, &QPushButton::clicked, this, &GrowthFilm::play);
  connect(&timer_, &QTimer::timeout, this, &GrowthFilm::advance);
}

void GrowthFilm::showGrowth(std::shared_ptr<const growth::Growth> growth, double tonnage) {
  stop();
  const int last = static_cast<int>(growth->stages.size()) - 1;
  take(std::move(growth), tonnage, last);
}

void GrowthFilm::follow(std::shared_ptr<const growth::Growth> growth, double tonnage) {
  const int last = static_cast<int>(growth->stages.size()) - 1;
  const bool isAnother = !growth_ || growth->stages.size() < growth_->stages.size();
  if (isAnother) stop();
  const bool atItsEnd = stage_->value() == stage_->maximum() && !timer_.isActive();
  take(std::move(growth), tonnage, isAnother || atItsEnd ? last : stage_->value());
}

void GrowthFilm::take(std::shared_ptr<const growth::Growth> growth, double tonnage, int stage) {
  growth_ = std::move(growth);
  tonnage_ = tonnage;
  const int last = static_cast<int>(growth_->stages.size()) - 1;
  stage_->setEnabled(last > 0), play_->setEnabled(last > 0);
  const QSignalBlocker quiet(stage_);
  stage_->setRange(0, last);
  stage_->setValue(stage);
  draw();
  drawCurves();
}

void GrowthFilm::setStyle(const plots::Style& style) {
  style_ = style;
  draw();
  drawCurves();
}

void GrowthFilm::draw() {
  if (!growth_) return;
  const auto stage = static_cast<std::size_t>(stage_->value());
  says_->setText(QString::fromStdString(growth::stageLine(growth_->stages[stage])));
  auto profile = plots::stageFigure(*growth_, stage, style_);
  profile->setAccessibleName(tr("Profile of the rail at this stage"));
  profile->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  placeFigure(*grid_, 0, 0, 3, std::move(profile));
  if (!figures_->isHidden()) return;
  delete layout_->takeAt(layout_->count() - 1);  // what kept the words at the top
  layout_->insertWidget(0, figures_, 1);
  figures_->show();
}

void GrowthFilm::drawCurves() {
  if (!growth_) return;
  const QString names[] = {tr("Depth against traffic"), tr("Length of the dip against traffic"),
                           tr("Acceleration and forces against traffic")};
  int row = 0;
  for (auto& curve : plots::growthCurves(*growth_, tonnage_, style_)) {
    curve->setAccessibleName(names[row]);
    curve->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    curve->setMinimumSize(180, 95);
    placeFigure(*grid_, row, 1, 1, std::move(curve));
    ++row;
  }
}

void GrowthFilm::play() {
  if (timer_.isActive()) return stop();
  if (stage_->value() == stage_->maximum()) stage_->setValue(0);
  play_->setText(tr("&Pause"));
  timer_.start();
}

void GrowthFilm::stop() {
  timer_.stop();
  play_->setText(tr("&Play"));
}

void GrowthFilm::advance() {
  stage_->setValue(stage_->value() + 1);
  if (stage_->value() == stage_->maximum()) stop();
}

}  // namespace squat::studio
