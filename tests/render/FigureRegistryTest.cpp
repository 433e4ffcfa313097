// The registry of figures: what has a row is built, written, listed and refused in one place.
#include "case/CaseDescription.h"
#include "plots/FigureRegistry.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "case/ParameterTable.h"
#include "core/Errors.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureFiles.h"
#include "plots/Figures.h"
#include "plots/Overlays.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "render/WithoutDisplay.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using FigureRegistry = tests::WithoutDisplay;

TEST_F(FigureRegistry, everyRowIsComplete) {
  std::set<std::string> names, tabs;
  for (const auto& row : figureRegistry()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
    EXPECT_TRUE(tabs.insert(row.tab).second) << row.tab << " stands twice";
    EXPECT_FALSE(row.title.empty()) << row.name;
    EXPECT_TRUE(row.needs.starts_with("Needs ") && row.needs.ends_with(".")) << row.name << ": " << row.needs;
    ASSERT_NE(row.applies, nullptr) << row.name;
    EXPECT_EQ(row.build != nullptr, row.kind == FigureKind::plot) << row.name;
    EXPECT_EQ(&figureRow(row.name), &row);
  }
}

// The made-up run has something for every figure; drawn figures differ from the notice of an empty result.
TEST_F(FigureRegistry, everyRowIsBuiltAndNamedAsItsFile) {
  const auto full = tests::syntheticResult();
  results::RunResult empty;
  for (const auto& row : figureRegistry()) {
    EXPECT_TRUE(row.applies(full)) << row.name;
    EXPECT_FALSE(row.applies(empty)) << row.name;
    if (row.kind != FigureKind::plot) continue;
    const auto figure = buildFigure(row, full, lightStyle());
    EXPECT_EQ(figure->name().toStdString(), row.name);
    const auto unit = QString::fromStdString("[" + unitOf(row.axis) + "]");
    EXPECT_TRUE(figure->xAxis->label().endsWith(unit)) << row.name << ": " << figure->xAxis->label().toStdString();
    const auto notice = buildFigure(row, empty, lightStyle());
    EXPECT_NE(toSvg(*figure), toSvg(*notice)) << row.name;
  }
}

TEST_F(FigureRegistry, everyRowIsWrittenByItsName) {
  const std::string folder = tests::freshFolder("registry");
  for (const auto& row : figureRegistry()) {
    const auto written = renderFigures(tests::syntheticResult(), folder, {{row.name}, {"png"}});
    ASSERT_EQ(written.size(), 1u) << row.name;
    EXPECT_EQ(std::filesystem::path(written[0]).filename().string(), row.name + ".png");
    EXPECT_GT(std::filesystem::file_size(written[0]), 5000u) << row.name;  // an empty figure has some 3000
  }
}

TEST_F(FigureRegistry, helpListsEveryRowWithItsTitle) {
  const std::string list = figureList();
  for (const auto& row : figureRegistry())
    EXPECT_THAT(list, AllOf(HasSubstr("  " + row.name + " "), HasSubstr(row.title)));
}

TEST_F(FigureRegistry, anUnknownNameIsAnErrorThatListsTheNames) {
  try {
    figureRow("defect");
    FAIL() << "no error";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("--figures"), HasSubstr("defect,"), HasSubstr("residual_stress")));
  }
  EXPECT_THROW(buildFigure(figureRow("model"), tests::syntheticResult(), lightStyle()), CaseError);
}

// A result without what a row needs: refused by name, left out of the rest.
TEST_F(FigureRegistry, whatDoesNotApplyIsLeftOutAndRefusedByName) {
  auto result = tests::syntheticResult();
  result.permanent = {};
  result.patches.clear();
  const std::string folder = tests::freshFolder("registry-lacking");
  for (const auto& path : renderFigures(result, folder, {{}, {"svg"}}))
    EXPECT_NE(std::filesystem::path(path).stem(), "contact_patch") << path;
  for (const char* name : {"contact_patch", "permanent_change", "residual_stress"}) try {
      renderFigures(result, folder, {{name}, {"svg"}});
      FAIL() << name;
    } catch (const CaseError& error) {
      EXPECT_THAT(error.what(), HasSubstr(figureRow(name).needs));
    }
}

TEST_F(FigureRegistry, aRunOfAnElasticRailIsNotAskedForItsResidualStress) {
  auto description = cases::defaultCase();
  description.rail.plastic = false;
  EXPECT_THROW(checkRequest({{"residual_stress"}}, &description), CaseError);
  description.rail.plastic = true;
  EXPECT_NO_THROW(checkRequest({{"residual_stress"}}, &description));
  EXPECT_THROW(checkRequest({{"no_such"}}, &description), CaseError);
}

// The first window is centred half a segment behind the start of the record, at -200 mm; the figure begins there, or at
// -100 mm.
TEST_F(FigureRegistry, settingsReachTheShortTimeTransform) {
  const auto result = tests::syntheticResult();
  const auto begins = [&](std::size_t segment) {
    FigureSettings settings;
    settings.segment = segment;
    settings.hop = 1;  // 1.2 mm at 30 m/s and 25 kHz
    return buildFigure(figureRow("stft"), result, lightStyle(), settings)->xAxis->range().lower;
  };
  EXPECT_NEAR(begins(128), -100, 1.2);
  EXPECT_NEAR(begins(256), -200 + 1.2 * 128, 1.2);
}

// A signal of the catalogue that names a figure is drawn in it, in the unit of its axis, and laid over other runs.
TEST_F(FigureRegistry, signalsOfTheCatalogueAreDrawnInTheirFigures) {
  auto result = tests::syntheticResult();
  // A single wheelset has no second one: a bogie's own numbers.
  std::vector<double> second(result.time.size());
  for (std::size_t i = 0; i < second.size(); ++i) second[i] = 8e4 + static_cast<double>(i);
  result.signals.push_back({signals::names::secondContactForce, "N", "", second});
  int drawn = 0;
  for (const auto& row : signals::signalCatalogue()) {
    if (!row.curve.figure || row.left) continue;  // a half model has no right side
    const auto& figureOfIt = figureRow(row.curve.figure);
    EXPECT_TRUE(figureOfIt.needs.find(row.name) != std::string::npos || *row.curve.tab == 0) << row.name;
    const auto figure = figureOfIt.build(result, lightStyle(), {});
    const auto& values = *result.signal(row.name);
    const auto middle = static_cast<int>(values.size() / 2);
    bool found = false;
    for (int g = 0; g < figure->graphCount(); ++g) {
      if (figure->graph(g)->name() != row.curve.label) continue;
      found = true;
      EXPECT_DOUBLE_EQ(figure->graph(g)->data()->at(middle)->value,
                       row.curve.factor * values[static_cast<std::size_t>(middle)]);
    }
    EXPECT_TRUE(found) << row.name;
    ++drawn;
  }
  EXPECT_GE(drawn, 4);  // two forces, two accelerations beside the track
}

// Of a whole model both sides stand in one figure, each by its name, the right one in the unit of the axis as well.
TEST_F(FigureRegistry, bothSidesOfAWholeModelAreDrawnTogether) {
  auto result = tests::syntheticResult();
  const auto valueAt = [&](const Figure& figure, const QString& label, int at) {
    for (int g = 0; g < figure.graphCount(); ++g)
      if (figure.graph(g)->name().startsWith(label)) return figure.graph(g)->data()->at(at)->value;
    ADD_FAILURE() << label.toStdString() << " is missing";
    return 0.0;
  };
  const std::pair<const char*, const char*> signals[] = {{"aba_filtered", "aba_right_filtered"},
                                                         {"contact_force", "contact_force_right"}};
  for (const auto& [left, right] : signals) {
    auto channel = results::Channel{right, "", "", *result.signal(left)};
    for (double& value : channel.values) value *= 0.5;
    result.signals.push_back(channel);
  }
  const int at = 300;
  const auto aba = figureRow("aba_position").build(result, lightStyle(), {});
  EXPECT_DOUBLE_EQ(valueAt(*aba, "axle box, right", at), 0.5 * valueAt(*aba, "axle box, left (", at));
  EXPECT_DOUBLE_EQ(valueAt(*aba, "wheel, left (", at), (*result.signal("wheel_acceleration_filtered"))[at]);
  const auto force = figureRow("contact_force").build(result, lightStyle(), {});
  EXPECT_DOUBLE_EQ(valueAt(*force, "vertical, right", at), 0.5e-3 * (*result.signal("contact_force"))[at]);
  EXPECT_DOUBLE_EQ(valueAt(*force, "vertical, left", at), 1e-3 * (*result.signal("contact_force"))[at]);
  EXPECT_DOUBLE_EQ(valueAt(*force, "longitudinal, left", at), 1e-3 * (*result.signal("creep_force"))[at]);
  const auto psd = figureRow("psd").build(result, lightStyle(), {});
  EXPECT_DOUBLE_EQ(valueAt(*psd, "axle box, left", at), result.psd[at]);
  EXPECT_DOUBLE_EQ(valueAt(*psd, "wheel, left", at), result.psdWheel[at]);
}

// A half model has one side, which needs no name; of a whole one, figures of the left side alone say so.
TEST_F(FigureRegistry, theLeftSideIsNamedWhereThereIsARightOne) {
  auto result = tests::syntheticResult();
  for (const char* name : {"aba_position", "aba_time", "contact_force", "trackside", "psd", "scalogram"})
    for (const char* word : {", left", "left side"})
      EXPECT_FALSE(toSvg(*figureRow(name).build(result, lightStyle(), {})).contains(word)) << name;
  result.signals.push_back({"aba_right", "m/s2", "", *result.signal("aba_filtered")});
  for (const char* name : {"psd", "scalogram", "stft", "defect_profile", "contact_patch"})
    EXPECT_TRUE(toSvg(*figureRow(name).build(result, lightStyle(), {})).contains("left side: ")) << name;
  EXPECT_FALSE(toSvg(*figureRow("aba_time").build(result, lightStyle(), {})).contains("left side: "));
}

// The same run begun half a second earlier, laid over itself in time: the wheels pass the defect together.
TEST_F(FigureRegistry, overlaidRunsStandOnTheAxisOfTheShownOne) {
  const auto shown = tests::syntheticResult();
  auto other = std::make_shared<results::RunResult>(shown);
  for (double& time : other->time) time += 0.5;
  signals::PowerSpectrum spectrum;
  spectrum.frequency = other->frequency, spectrum.density = other->psd;
  const std::vector<OverlaidRun> overlays{{other, spectrum, "earlier"}};
  for (const auto& row : figureRegistry()) {
    if (!row.overlay) continue;
    const auto alone = buildFigure(row, shown, lightStyle());
    const auto both = buildFigure(row, shown, lightStyle(), {}, overlays);
    ASSERT_EQ(both->graphCount(), alone->graphCount() + 1) << row.name;
    const auto* over = both->graph(both->graphCount() - 1);
    EXPECT_EQ(over->name(), "earlier") << row.name;
    ASSERT_EQ(over->dataCount(), both->graph(0)->dataCount()) << row.name;
    for (const int i : {0, over->dataCount() / 2, over->dataCount() - 1})
      EXPECT_NEAR(over->data()->at(i)->key, both->graph(0)->data()->at(i)->key, 1e-9) << row.name;  // [ms], [mm], [Hz]
  }
}

}  // namespace
}  // namespace squat::plots
