// The film of a growth that is still computed: it grows with each stage, and nobody who looks at an earlier one is
// disturbed.
#include "studio/tools/GrowthFilm.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "plots/Figure.h"

namespace squat::studio {
namespace {

constexpr double wholeTraffic = 4e9;  // [kg]

// A dip that becomes deeper by 0.1 mm with each stage, a megatonne apart.
std::shared_ptr<const growth::Growth> grown(int stages) {
  auto growth = std::make_shared<growth::Growth>();
  growth->x = {-0.02, 0, 0.02}, growth->y = {-0.01, 0.01}, growth->line = 0.01;
  for (int i = 0; i < stages; ++i) {
    growth::Stage stage;
    stage.tonnage = 1e9 * i, stage.depth = 1e-4 * (i + 1), stage.length = 0.03;
    stage.peakAcceleration = 50 + 10 * i, stage.largestForce = 1.2e5, stage.smallestForce = 8e4;
    growth->stages.push_back(stage);
    growth->shapes.push_back({0, 0, -stage.depth, -stage.depth, 0, 0});
  }
  return growth;
}

class Film : public testing::Test {
 protected:
  void SetUp() override {
    film_.resize(1000, 600);
    film_.show();
  }
  plots::Figure* figure(const QString& name) const {
    for (auto* each : film_.findChildren<plots::Figure*>())
      if (each->name() == name) return each;
    return nullptr;
  }
  int points(const QString& name) const { return figure(name)->graph(0)->dataCount(); }

  GrowthFilm film_{plots::lightStyle()};
  QSlider* stage_ = film_.findChild<QSlider*>("growthStage");
  QPushButton* play_ = film_.findChild<QPushButton*>("growthPlay");
};

TEST_F(Film, growsWithEachStage) {
  EXPECT_EQ(figure("growth_stage"), nullptr);
  for (int stages = 1; stages <= 4; ++stages) {
    film_.follow(grown(stages), wholeTraffic);
    EXPECT_EQ(stage_->maximum(), stages - 1);
    EXPECT_EQ(stage_->value(), stages - 1);
    EXPECT_EQ(play_->isEnabled(), stages > 1);
    for (const char* name : {"growth_depth", "growth_length", "growth_response"}) {
      ASSERT_TRUE(figure(name)) << name;
      EXPECT_EQ(points(name), stages) << name;
      // The axis is that of the whole traffic from the beginning on: curves grow into it.
      EXPECT_EQ(figure(name)->xAxis->range().upper, 4) << name;
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return figure("growth_stage")->isVisible(); }));
  }
  // The last stage is drawn: 0.4 mm deep in the middle.
  EXPECT_NEAR(figure("growth_stage")->graph(1)->data()->at(1)->value, -0.4, 1e-12);
}

TEST_F(Film, leavesTheStageThatOneLooksAt) {
  film_.follow(grown(3), wholeTraffic);
  stage_->setValue(1);
  film_.follow(grown(4), wholeTraffic);
  EXPECT_EQ(stage_->value(), 1);
  EXPECT_EQ(stage_->maximum(), 3);
  EXPECT_EQ(points("growth_depth"), 4);
  play_->click();  // from there
  film_.follow(grown(5), wholeTraffic);
  EXPECT_EQ(play_->text(), "&Pause");
  EXPECT_EQ(stage_->value(), 1);
  // Another growth begins; then it ends.
  film_.follow(grown(1), wholeTraffic);
  EXPECT_EQ(stage_->value(), 0);
  EXPECT_EQ(play_->text(), "&Play");
  film_.follow(grown(2), wholeTraffic);
  stage_->setValue(0);
  film_.showGrowth(grown(3), wholeTraffic);
  EXPECT_EQ(stage_->value(), 2);
}

}  // namespace
}  // namespace squat::studio
