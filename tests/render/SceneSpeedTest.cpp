// Frames a second of the model on the mesh of the paper in software rendering, at 1000 x 700: turned by the mouse, and
// animated from frame to frame. Judged by processor time, as other programs may be busy; wall time is printed beside.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "case/CaseFile.h"
#include "case/MeshPresets.h"
#include "case/ParameterTable.h"
#include "case/Resolve.h"
#include "model/Model.h"
#include "scene/SceneView.h"
#include "simulation/SurfaceFields.h"

namespace squat {
namespace {

constexpr int width = 1000, height = 700, frames = 12;
constexpr double cores = 2;  // that the picture may use

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::shared_ptr<results::RunResult> paperResult() {
  cases::CaseDescription description = cases::defaultCase();
  cases::applyPreset(description, cases::MeshPreset::paper);
  const model::Model model = model::buildModel(cases::resolve(description));
  const simulation::SurfaceFields fields(model);
  auto result = std::make_shared<results::RunResult>();
  result->surface = fields.mesh();
  AlignedVector state(model.stateSize, 0.0);
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = 1e-6 * static_cast<double>(i % 7);  // some field
  for (int frame = 0; frame < 3; ++frame)
    result->snapshots.push_back(
        fields.snapshot("frame", state, 1e-3 * frame, 0.03 * frame, 0.03 * frame / description.wheelset.radius, {}));
  return result;
}

template <class Step>
void judge(const char* what, const Step& step) {
  step(0);  // the first one makes buffers
  const auto start = std::chrono::steady_clock::now();
  const double used = processorSeconds();
  for (int frame = 1; frame <= frames; ++frame) step(frame);
  const double processor = (processorSeconds() - used) / frames;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / frames;
  std::printf("%-28s %5.1f frames a second of wall time, %5.1f by processor time on two cores (10 asked)\n", what,
              1 / wall, cores / processor);
  EXPECT_GT(cores / processor, 10) << what;
}

TEST(SceneSpeed, paperMeshMoves) {
  const auto result = paperResult();
  std::printf("%zu faces, %zu points on the surface\n", result->surface.part.size(), result->surface.points.size() / 3);
  std::string reason;
  const auto view = scene::SceneView::create(reason);
  ASSERT_NE(view, nullptr) << reason;
  view->setResult(result);
  scene::SceneChoices choices;
  choices.snapshot = 1;
  view->setChoices(choices);
  judge("turning", [&](int) {
    view->rotate(3, 1);
    ASSERT_FALSE(view->render(width, height, true).empty());
  });
  judge("animation", [&](int frame) {
    choices.snapshot = frame % 3;
    view->setChoices(choices);
    ASSERT_FALSE(view->render(width, height, true).empty());
  });
  // The fine picture after the motion, for information.
  const auto start = std::chrono::steady_clock::now();
  ASSERT_FALSE(view->render(width, height).empty());
  std::printf("at rest %.0f ms\n",
              1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace
}  // namespace squat
