// The 3-D view: one scale of colours for a whole animation.
#include <gtest/gtest.h>

#include <QLabel>
#include <memory>

#include "render/SyntheticResult.h"
#include "scene/SceneView.h"
#include "scene/SurfaceData.h"

namespace squat::scene {
namespace {

// Two frames, the second one with half the stress of the first.
std::shared_ptr<const results::RunResult> twoFrames() {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  results::SurfaceSnapshot weaker = result->snapshots.front();
  weaker.name = "frame 01";
  for (float& stress : weaker.vonMises) stress *= 0.5f;
  result->snapshots.push_back(weaker);
  return result;
}

TEST(Scene, coloursKeepTheirRangeFromFrameToFrame) {
  std::string reason;
  const auto view = SceneView::create(reason);
  if (!view) GTEST_SKIP() << reason;
  const auto result = twoFrames();
  view->setResult(result);
  SceneChoices choices;
  double highest[2];
  for (const int frame : {0, 1}) {
    choices.snapshot = frame;
    view->setChoices(choices);
    view->render(64, 48);
    highest[frame] = view->highest();
  }
  EXPECT_DOUBLE_EQ(highest[0], highest[1]);
  // 620 MPa of the bell and 12 MPa of the rest is the most that the made-up stress can be; the nearest point of the
  // coarse surface has not all of the bell.
  EXPECT_LE(highest[0], 632);
  EXPECT_GT(highest[0], 0.5 * 632);
}

TEST(Scene, theLargestValueIsThatNearTheContactAtItsInstant) {
  auto result = *twoFrames();
  auto& far = result.snapshots[0];
  // A point 0.3 m and more from the contact: what is clamped at the ends of the model does not count.
  const auto places = placesOf(result.surface, far, 1);
  const double contactAt = wheelCentre(result.surface)[0] + far.wheelTravel;
  for (std::size_t i = 0; i < far.vonMises.size(); ++i)
    if (std::abs(static_cast<double>(places[3 * i]) - contactAt) > 0.3) far.vonMises[i] = 5e9f;
  EXPECT_LE(largestNearContact(result.surface, far, Field::vonMises, 0.1), 632);
}

}  // namespace
}  // namespace squat::scene
