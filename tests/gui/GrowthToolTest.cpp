// Growth under traffic in the studio: film, table and forecast are those of the command.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>

#include "gui/ToolsOfAWindow.h"
#include "studio/common/MessageBar.h"
#include "studio/tools/KeyRows.h"

namespace squat::studio {
namespace {

TEST_F(Tools, theGrowthIsThatOfTheCommand) {
  for (const auto& [key, value] : {std::pair{"growth.wheelsets", "1"}, {"motion.torque", "0"}})
    window_.document().setParameter(key, value);
  ToolWindow* growth = open("growth");
  growth->form()->findChild<QDoubleSpinBox*>("tonnage")->setValue(0.05);
  auto* stage = growth->findChild<QSlider*>("growthStage");
  growth->start();
  // Two stages, and so a film, are there before the end.
  ASSERT_TRUE(tests::passes([&] { return stage->isEnabled() || !growth->isBusy(); }, tests::patience));
  EXPECT_TRUE(growth->isComputing());
  ASSERT_TRUE(tests::passes([&] { return !growth->isBusy(); }, tests::patience));
  const QString printed = command(
      {"grow", "growth/case/short.toml", "--mesh", "tiny", "--tonnage", "0.05", "-o", "command", "--no-figures"});
  EXPECT_GT(read("growth/short-growth.csv").size(), 200);
  EXPECT_EQ(read("growth/short-growth.csv"), read("command/short-growth.csv"));
  EXPECT_EQ(printed.section("\nwritten:", 0, 0), growth->text());
  EXPECT_FALSE(read("growth/short_growth.svg").isEmpty());
  EXPECT_TRUE(growth->findChild<QPushButton*>("toolOpenCase")->isVisible());
  // The film begins with the rail as it was, and ends with the last stage, which is shown at first.
  ASSERT_GT(stage->maximum(), 1);
  EXPECT_EQ(stage->value(), stage->maximum());
  growth->findChild<QPushButton*>("growthPlay")->click();
  EXPECT_EQ(stage->value(), 0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return stage->value() == stage->maximum(); }, 20000));
}

TEST_F(Tools, aForecastNeedsAKeyAndItsLimits) {
  ToolWindow* growth = open("growth");
  auto* rows = growth->form()->findChild<KeyRows*>();
  auto* growths = growth->form()->findChild<QSpinBox*>("forecastGrowths");
  EXPECT_FALSE(rows->isEnabled() || growths->isEnabled());
  growth->form()->findChild<QAbstractButton*>("growthForecast")->click();
  EXPECT_TRUE(rows->isEnabled() && growths->isEnabled());
  growth->start();
  EXPECT_FALSE(growth->isBusy());
  EXPECT_TRUE(growth->messages()->text().contains("key that is uncertain")) << growth->messages()->text().toStdString();
  // What is wrong with it is said before anything has grown.
  rows->setTexts({"growth.wear_coeficient=5e-5:2e-4"});
  ASSERT_NO_FATAL_FAILURE(finish(*growth));
  EXPECT_TRUE(growth->messages()->text().contains("growth.wear_coeficient"))
      << growth->messages()->text().toStdString();
  EXPECT_TRUE(read("growth/short-growth.csv").isEmpty());
}

TEST_F(Tools, theForecastIsThatOfTheCommand) {
  for (const auto& [key, value] : {std::pair{"growth.wheelsets", "1"}, {"motion.torque", "0"}})
    window_.document().setParameter(key, value);
  ToolWindow* growth = open("growth");
  growth->form()->findChild<QDoubleSpinBox*>("tonnage")->setValue(0.05);
  growth->form()->findChild<QAbstractButton*>("growthForecast")->click();
  const QString key = "growth.wear_coefficient=5e-5:2e-4";
  growth->form()->findChild<KeyRows*>()->setTexts({key});
  growth->form()->findChild<QSpinBox*>("forecastGrowths")->setValue(2);
  ASSERT_NO_FATAL_FAILURE(finish(*growth));
  const QString printed = command({"grow", "growth/case/short.toml", "--mesh", "tiny", "--tonnage", "0.05",
                                   "--uncertain", key, "--growths", "2", "-o", "command", "--no-figures"});
  EXPECT_GT(read("growth/short-forecast.csv").size(), 200);
  EXPECT_EQ(read("growth/short-forecast.csv"), read("command/short-forecast.csv"));
  const auto sentence = [](const QString& text) {
    return "Forecast" + text.section("Forecast", 1).section('\n', 0, 0);
  };
  EXPECT_TRUE(printed.contains("Forecast from 2 growths")) << printed.toStdString();
  EXPECT_EQ(sentence(growth->text()), sentence(printed));
  EXPECT_FALSE(read("growth/short_forecast.svg").isEmpty());
  EXPECT_EQ(growth->findChild<QTabWidget*>()->count(), 5);  // film, text, log, growth, forecast
}

}  // namespace
}  // namespace squat::studio
