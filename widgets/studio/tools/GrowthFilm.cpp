#include "studio/tools/GrowthFilm.h"

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

}  // namespace

GrowthFilm::GrowthFilm(const plots::Style& style, QWidget* parent)
    : QWidget(parent),
      style_(style),
      stage_(new QSlider(Qt::Horizontal, this)),
      play_(new QPushButton(tr("&Play"), this)),
      says_(new QLabel(tr("When the growth has ended, the rail is shown here from stage to stage."), this)),
      layout_(new QVBoxLayout(this)) {
  stage_->setObjectName("growthStage");
  stage_->setAccessibleName(tr("Stage of the growth"));
  play_->setObjectName("growthPlay");
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

void GrowthFilm::showGrowth(std::shared_ptr<const growth::Growth> growth) {
  stop();
  growth_ = std::move(growth);
  const int last = static_cast<int>(growth_->stages.size()) - 1;
  stage_->setEnabled(last > 0), play_->setEnabled(last > 0);
  const QSignalBlocker quiet(stage_);
  stage_->setRange(0, last);
  stage_->setValue(last);
  draw();
}

void GrowthFilm::setStyle(const plots::Style& style) {
  style_ = style;
  draw();
}

void GrowthFilm::draw() {
  if (!growth_) return;
  const auto stage = static_cast<std::size_t>(stage_->value());
  says_->setText(QString::fromStdString(growth::stageLine(growth_->stages[stage])));
  auto* before = std::exchange(figure_, plots::stageFigure(*growth_, stage, style_).release());
  figure_->setAccessibleName(tr("Profile of the rail at this stage"));
  figure_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  if (before) {
    delete layout_->replaceWidget(before, figure_);
    delete before;
  } else {
    delete layout_->takeAt(layout_->count() - 1);
    layout_->insertWidget(0, figure_, 1);
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
