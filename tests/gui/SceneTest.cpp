// The 3-D view: one scale of colours for a whole animation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "case/CaseDescription.h"
#include "case/ParameterValue.h"
#include "render/SyntheticResult.h"
#include "scene/SceneView.h"

namespace squat::scene {
namespace {

// Two frames, the second one with half the stress of the first.
std::shared_ptr<results::RunResult> twoFrames() {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  results::SurfaceSnapshot weaker = result->snapshots.front();
  weaker.name = "frame 01";
  for (float& stress : weaker.vonMises) stress *= 0.5f;
  result->snapshots.push_back(weaker);
  return result;
}

// [MPa] that the colours of this frame reach.
double highestOf(SceneView& view, int frame) {
  SceneChoices choices;
  choices.snapshot = frame;
  view.setChoices(choices);
  view.render(64, 48);
  return view.highest();
}

// To the right, as positions run in all figures; how far follows from where the eye stands: the part of x across the
// line of sight. Seen from the front the wheel comes towards the eye.
TEST(Scene, theWheelRollsToTheRight) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  view->setResult(twoFrames());
  const std::pair<StandardView, double> expected[] = {{StandardView::overview, 0.75 / std::hypot(0.55, 0.75)},
                                                      {StandardView::contact, 0.75 / std::hypot(0.5, 0.75)},
                                                      {StandardView::side, 1},
                                                      {StandardView::front, 0},
                                                      {StandardView::top, 1}};
  for (const auto& [from, right] : expected) {
    view->lookFrom(from);
    view->render(64, 48);
    EXPECT_NEAR(view->heading(), right, 1e-4) << static_cast<int>(from);
  }
}

// The left side of a whole model is seen from outside, where the wheel rolls to the left; its colours count the
// contacts of both sides.
TEST(Scene, theSideViewOfAWholeModelShowsTheLeft) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  const auto whole = std::make_shared<const results::RunResult>(tests::syntheticWhole(3));
  view->setResult(whole);
  const double highest = highestOf(*view, 0);
  view->lookFrom(StandardView::side);
  EXPECT_NEAR(view->heading(), -1, 1e-4);
  EXPECT_NEAR(view->eye().azimuth, 90, 1e-6);  // outwards of the left rail: along y
  // On the right there are outer faces alone.
  const auto outer = std::make_shared<const results::RunResult>(tests::withoutCutFaces(tests::syntheticResult()));
  view->setResult(outer);
  EXPECT_NEAR(highest, 3 * highestOf(*view, 0), 1e-3);
  view->setResult(whole);
  view->lookFrom(StandardView::overview);
  EXPECT_GT(view->heading(), 0);
}

// Both wheelsets of a bogie are seen: the eye looks half-way between them, from farther away.
TEST(Scene, theViewsHoldBothWheelsets) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  const double contactAt = result->snapshots.front().position;
  for (const char* wheelbase : {"0", "2.5"}) {
    auto description = cases::defaultCase();
    cases::setValue(description, "bogie.wheelbase", wheelbase);
    results::setCase(*result, description);
    view->setResult(result);
    highestOf(*view, 0);
    const double half = 0.5 * std::stod(wheelbase);
    for (const auto from : {StandardView::overview, StandardView::side, StandardView::top}) {
      view->lookFrom(from);
      EXPECT_NEAR(view->eye().target[0], contactAt - half, 1e-5);
      EXPECT_GE(1.5 * view->eye().reach, half + 0.46);  // in a window of 3 to 2
    }
    view->lookFrom(StandardView::contact);
    EXPECT_NEAR(view->eye().target[0], contactAt, 1e-5);
  }
}

// The right contact is coloured on one scale with the left one.
TEST(Scene, bothContactsCountInThePressures) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  view->setResult(std::make_shared<const results::RunResult>(tests::syntheticWhole(1.5)));
  SceneChoices choices;
  choices.field = Field::contactPressure;
  choices.snapshot = 0;
  view->setChoices(choices);
  view->render(64, 48);
  EXPECT_NEAR(view->highest(), 1.5 * 1200, 1e-3);  // MPa: Hertz's pressure in the middle of the made-up patch
}

TEST(Scene, coloursKeepTheirRangeFromFrameToFrame) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  const auto result = twoFrames();
  view->setResult(result);
  const auto& stress = result->snapshots.front().vonMises;
  const double largest = 1e-6 * static_cast<double>(*std::max_element(stress.begin(), stress.end()));
  constexpr double ofFloat = 1e-6;  // relative: the field is kept in single precision
  EXPECT_NEAR(highestOf(*view, 0), largest, ofFloat * largest);
  EXPECT_NEAR(highestOf(*view, 1), largest, ofFloat * largest);
}

// What is clamped at the ends of the model has peaks of its own, which would darken the contact.
TEST(Scene, theRangeIsThatNearTheContact) {
  std::string reason;
  const auto view = SceneView::create(reason);
  ASSERT_TRUE(view) << reason;
  const auto result = twoFrames();
  auto& first = result->snapshots.front();
  const float before = *std::max_element(first.vonMises.begin(), first.vonMises.end());
  for (std::size_t i = 0; i < first.vonMises.size(); ++i) {
    const bool rail = result->surface.points[3 * i + 2] < -0.02f;  // below the wheel: it does not roll
    if (rail && std::abs(static_cast<double>(result->surface.points[3 * i]) - first.position) > 0.3)
      first.vonMises[i] = 5e9f;
  }
  ASSERT_GT(*std::max_element(first.vonMises.begin(), first.vonMises.end()), before);
  view->setResult(result);
  EXPECT_NEAR(highestOf(*view, 0), 1e-6 * static_cast<double>(before), 1e-3);
}

}  // namespace
}  // namespace squat::scene
