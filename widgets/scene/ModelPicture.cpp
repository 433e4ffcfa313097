#include "scene/ModelPicture.h"

#include <vtkCamera.h>
#include <vtkMapper.h>

#include <algorithm>
#include <cmath>

#include "scene/SceneParts.h"
#include "scene/SurfacelessWindow.h"

namespace squat::scene {
namespace {

constexpr int width = 2008, height = 1063;  // 170 mm x 90 mm at 300 dpi
constexpr int labelPixels = 33;             // 8 pt
constexpr int captionPixels = 23;           // 5.5 pt
constexpr double division = 0.44;           // share of the width that the left picture takes
constexpr double barLeft = 0.88;            // where the colour bar begins
constexpr double bodyTop = 0.93;            // share of the height below the caption

const results::SurfaceSnapshot* chosenSnapshot(const results::RunResult& result) {
  const results::SurfaceSnapshot* chosen = nullptr;
  for (const auto& snapshot : result.snapshots) {
    if (snapshot.vonMises.empty()) continue;
    chosen = &snapshot;
    if (snapshot.name == "impact") break;
  }
  return chosen;
}

vtkSmartPointer<vtkRenderer> newRenderer(SurfacelessWindow& window, double left, double right, double bottom,
                                         double top) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(left, bottom, right, top);
  renderer->SetBackground(1, 1, 1);
  window.AddRenderer(renderer);
  return renderer;
}

vtkSmartPointer<vtkPlane> planeAt(double x, double y, double z, double nx, double ny, double nz) {
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(x, y, z);
  plane->SetNormal(nx, ny, nz);
  return plane;
}

void addOverview(SurfacelessWindow& window, const results::RunResult& result, const results::SurfaceSnapshot* snapshot,
                 double contactAt) {
  auto renderer = newRenderer(window, 0, division, 0, bodyTop);
  Look look;
  look.field = Field::none;
  look.edges = false;  // too fine for this distance: they would blacken it
  look.cuts = {planeAt(contactAt - 0.8, 0, 0, 1, 0, 0), planeAt(contactAt + 0.8, 0, 0, -1, 0, 0)};
  for (const auto& part : partData(result.surface, snapshot, Field::none, 1.0)) {
    if (isCutFace(part.name)) continue;
    renderer->AddActor(partActor(part, look));
    renderer->AddActor(outlineActor(part, look));
  }
  const auto springs = springActor(springLines(result.surface, snapshot ? snapshot->wheelTravel : 0), 2.5);
  for (const auto& plane : look.cuts) springs->GetMapper()->AddClippingPlane(plane);
  renderer->AddActor(springs);
  aim(*renderer, {contactAt, -0.12, 0.24}, {0.55, 0.75, 0.42}, 0.95);
}

// With inner faces at y = 0 both bodies are cut there and the stress below the surface is seen; without them the wheel
// is hidden and the rail's surface is seen from above.
void addCloseUp(SurfacelessWindow& window, const results::RunResult& result, const results::SurfaceSnapshot* snapshot,
                double contactAt, const std::string& colourMap) {
  auto renderer = newRenderer(window, division, barLeft, 0, bodyTop);
  Look look;
  look.colourMap = colourMap;
  look.field = snapshot ? Field::vonMises : Field::none;
  const auto parts = partData(result.surface, snapshot, look.field, 1.0);
  look.high = roundUp(std::max(largestNear(parts, contactAt, 0.03), 1.0));
  const bool cut = std::any_of(parts.begin(), parts.end(), [](const PartData& part) { return isCutFace(part.name); });
  if (cut) look.cuts = {planeAt(0, 0, 0, 0, -1, 0)};
  for (const auto& part : parts)
    if (cut || !rolls(part.name)) renderer->AddActor(partActor(part, look));
  if (cut)
    aim(*renderer, {contactAt, 0, 0.0005}, {0.12, 0.97, 0.14}, 0.034);
  else
    aim(*renderer, {contactAt, 0, -0.004}, {0.3, 0.6, 0.75}, 0.045);
  renderer->AddActor2D(textActor(cut ? "cut at y = 0" : "rail, wheel hidden", 0.03, 0.03, labelPixels, cut));
  if (!snapshot) return;
  auto bar = newRenderer(window, barLeft, 1, 0, bodyTop);
  bar->AddActor2D(colourBar(look, {0.08, 0.04, 0.9, 0.83}, labelPixels));
  bar->AddActor2D(textActor("von Mises", 0.08, 0.95, labelPixels, false));
  bar->AddActor2D(textActor("[MPa]", 0.08, 0.905, labelPixels, false));
}

void addCaption(SurfacelessWindow& window, const results::RunResult& result, const results::SurfaceSnapshot* snapshot) {
  auto renderer = newRenderer(window, 0, 1, bodyTop, 1);
  std::string left = result.title.empty() ? result.stem : result.title;
  if (snapshot) {
    char location[80];
    std::snprintf(location, sizeof location, ", wheel at %.0f mm (%s)", 1e3 * snapshot->position,
                  snapshot->name.c_str());
    left += location;
  }
  if (!result.complete) left = "incomplete (" + result.stopReason + "): " + left;
  renderer->AddActor2D(textActor(left, 0.01, 0.35, captionPixels, false));
  renderer->AddActor2D(textActor(result.stem + "  " + result.caseHash, 0.99, 0.35, captionPixels, false, 1.0));
}

}  // namespace

Picture modelPicture(const results::RunResult& result, const std::string& colourMap, std::string& reason) {
  if (result.surface.quads.empty() || result.surface.points.empty()) {
    reason = "the result has no surface of the model";
    return {};
  }
  const auto window = SurfacelessWindow::create(reason);
  if (!window) return {};
  const results::SurfaceSnapshot* snapshot = chosenSnapshot(result);
  const double contactAt = wheelCentre(result.surface)[0] + (snapshot ? snapshot->wheelTravel : 0);
  addOverview(*window, result, snapshot, contactAt);
  addCloseUp(*window, result, snapshot, contactAt, colourMap);
  addCaption(*window, result, snapshot);
  Picture picture = window->renderPicture(width, height);
  if (picture.empty()) reason = "OpenGL drew nothing";
  return picture;
}

ModelPictureOutcome writeModelPicture(const results::RunResult& result, const std::string& colourMap,
                                      const std::string& path) {
  ModelPictureOutcome outcome;
  const Picture picture = modelPicture(result, colourMap, outcome.reason);
  if (picture.empty()) return outcome;
  writePng(picture, path);
  outcome.written = true;
  return outcome;
}

}  // namespace squat::scene
