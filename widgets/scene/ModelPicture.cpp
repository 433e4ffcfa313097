#include "scene/ModelPicture.h"

#include <vtkCamera.h>
#include <vtkMapper.h>

#include <algorithm>
#include <cmath>

#include "scene/SceneParts.h"
#include "scene/SecondWheelset.h"
#include "scene/SurfacelessWindow.h"

namespace squat::scene {
namespace {

constexpr double labelPoints = 8, captionPoints = 5.5;
constexpr double division = 0.44;  // share of the width that the left picture takes
constexpr double barShare = 0.12;  // of the width that the colour bar takes, with letters of full size
constexpr double bodyTop = 0.93;   // share of the height below the caption

struct Pixels {
  int width, height;
  int label, caption;  // heights of letters
  double line;         // of a line that is one pixel wide at 300 dpi
  double barLeft;      // share of the width where the colour bar begins
};

int pixels(double millimetres, double resolution) {
  return static_cast<int>(std::lround(millimetres / 25.4 * resolution));
}

// A narrow picture has smaller letters, so that caption and scale keep their room; never below 0.7 of their size.
Pixels pixelsOf(const PictureSize& size) {
  const double narrow = size.width / PictureSize{}.width, smaller = std::clamp(narrow, 0.7, 1.0);
  const double letters = smaller * size.resolution / 72;
  return {pixels(size.width, size.resolution),
          pixels(size.height, size.resolution),
          static_cast<int>(std::lround(letters * labelPoints)),
          static_cast<int>(std::lround(letters * captionPoints)),
          size.resolution / PictureSize{}.resolution,
          1 - barShare * std::max(1.0, smaller / narrow)};
}

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
                 double contactAt, const Pixels& pixels) {
  auto renderer = newRenderer(window, 0, division, 0, bodyTop);
  Look look;
  look.lines = pixels.line;
  look.field = Field::none;
  look.edges = false;  // too fine for this distance: they would blacken it
  const double second = secondWheelsetFrom(result);
  look.cuts = {planeAt(contactAt + std::min(second, 0.0) - 0.8, 0, 0, 1, 0, 0),
               planeAt(contactAt + std::max(second, 0.0) + 0.8, 0, 0, -1, 0, 0)};
  for (const auto& part : partData(result.surface, snapshot, Field::none, 1.0)) {
    if (isCutFace(part.name)) continue;
    renderer->AddActor(partActor(part, look));
    renderer->AddActor(outlineActor(part, look));
  }
  const auto springs =
      springActor(springLines(result.surface, snapshot ? snapshot->wheelTravel : 0), 2.5 * pixels.line);
  for (const auto& plane : look.cuts) springs->GetMapper()->AddClippingPlane(plane);
  renderer->AddActor(springs);
  for (const auto& outline : secondWheelsetActors(result, snapshot, look)) renderer->AddActor(outline);
  if (second != 0) renderer->AddActor2D(textActor(kSecondWheelset, 0.03, 0.03, pixels.label, false));
  const double reach = hasBothSides(result.surface) ? 1.35 : 0.95;
  aim(*renderer, {contactAt + 0.5 * second, middleAcross(result.surface), 0.24}, overviewFrom,
      reachOfBoth(reach, second));
}

// With inner faces at y = 0 both bodies are cut there and the stress below the surface is seen; without them the wheel
// is hidden and the rail's surface is seen from above.
void addCloseUp(SurfacelessWindow& window, const results::RunResult& result, const results::SurfaceSnapshot* snapshot,
                double contactAt, const std::string& colourMap, const Pixels& pixels) {
  auto renderer = newRenderer(window, division, pixels.barLeft, 0, bodyTop);
  Look look;
  look.lines = pixels.line;
  look.colourMap = colourMap;
  look.field = snapshot ? Field::vonMises : Field::none;
  const auto parts = partData(result.surface, snapshot, look.field, 1.0);
  const double highest = snapshot ? largestNearContact(result.surface, *snapshot, look.field, 0.03) : 0;
  look.high = roundUp(std::max(highest, 1.0));
  const bool cut = std::any_of(parts.begin(), parts.end(), [](const PartData& part) { return isCutFace(part.name); });
  if (cut) look.cuts = {planeAt(0, 0, 0, 0, 1, 0)};
  for (const auto& part : parts)
    if (cut || !rolls(part.name)) renderer->AddActor(partActor(part, look));
  if (cut)
    aim(*renderer, {contactAt, 0, 0.0005}, {0.12, -0.97, 0.14}, 0.034);
  else
    aim(*renderer, {contactAt, 0, -0.004}, {0.3, -0.6, 0.75}, 0.045);
  const std::string side = hasBothSides(result.surface) ? "left: " : "";
  const std::string words = side + (cut ? "cut at y = 0" : "rail, wheel hidden");
  renderer->AddActor2D(textActor(words, 0.03, 0.03, pixels.label, cut));
  if (!snapshot) return;
  auto bar = newRenderer(window, pixels.barLeft, 1, 0, bodyTop);
  bar->AddActor2D(colourBar(look, {0.08, 0.04, 0.9, 0.83}, pixels.label));
  bar->AddActor2D(textActor("von Mises", 0.08, 0.95, pixels.label, false));
  bar->AddActor2D(textActor("[MPa]", 0.08, 0.905, pixels.label, false));
}

void addCaption(SurfacelessWindow& window, const results::RunResult& result, const results::SurfaceSnapshot* snapshot,
                int letters) {
  auto renderer = newRenderer(window, 0, 1, bodyTop, 1);
  std::string left = result.title.empty() ? result.stem : result.title;
  if (snapshot) {
    char location[80];
    std::snprintf(location, sizeof location, ", wheel at %.0f mm (%s)", 1e3 * snapshot->position,
                  snapshot->name.c_str());
    left += location;
  }
  if (!result.complete) left = "incomplete (" + result.stopReason + "): " + left;
  renderer->AddActor2D(textActor(left, 0.01, 0.35, letters, false));
  renderer->AddActor2D(textActor(result.stem + "  " + result.caseHash, 0.99, 0.35, letters, false, 1.0));
}

}  // namespace

Picture modelPicture(const results::RunResult& result, const std::string& colourMap, std::string& reason,
                     const PictureSize& size) {
  if (result.surface.quads.empty() || result.surface.points.empty()) {
    reason = "the result has no surface of the model";
    return {};
  }
  const Pixels pixels = pixelsOf(size);
  if (std::max(pixels.width, pixels.height) > PictureSize::maximumPixels) {
    reason = "it would have more than " + std::to_string(PictureSize::maximumPixels) +
             " pixels on a side; choose a lower resolution";
    return {};
  }
  const auto window = SurfacelessWindow::create(reason);
  if (!window) return {};
  const results::SurfaceSnapshot* snapshot = chosenSnapshot(result);
  const double contactAt = wheelCentre(result.surface)[0] + (snapshot ? snapshot->wheelTravel : 0);
  addOverview(*window, result, snapshot, contactAt, pixels);
  addCloseUp(*window, result, snapshot, contactAt, colourMap, pixels);
  addCaption(*window, result, snapshot, pixels.caption);
  Picture picture = window->renderPicture(pixels.width, pixels.height);
  if (picture.empty()) reason = "OpenGL drew nothing";
  return picture;
}

ModelPictureOutcome writeModelPicture(const results::RunResult& result, const std::string& colourMap,
                                      const std::string& path, const PictureSize& size) {
  ModelPictureOutcome outcome;
  const Picture picture = modelPicture(result, colourMap, outcome.reason, size);
  if (picture.empty()) return outcome;
  writePng(picture, path);
  outcome.written = true;
  return outcome;
}

}  // namespace squat::scene
