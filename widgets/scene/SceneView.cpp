#include "scene/SceneView.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "scene/PatchActor.h"
#include "scene/PatchFaces.h"
#include "scene/SceneParts.h"
#include "scene/SecondWheelset.h"
#include "scene/SurfacelessWindow.h"

namespace squat::scene {

namespace {
constexpr double barLeft = 0.88;  // share of the width where the colour bar begins
constexpr int letters = 12;       // [pixels] high where a pixel of the screen is one of the picture
}  // namespace

struct SceneView::Parts {
  vtkSmartPointer<SurfacelessWindow> window;
  vtkSmartPointer<vtkRenderer> renderer, bar;
  std::shared_ptr<const results::RunResult> result;
  SceneChoices choices;
  std::vector<vtkSmartPointer<vtkActor>> surfaces;
  vtkSmartPointer<vtkTextActor> heading;  // which way the wheel rolls
  vtkSmartPointer<vtkTextActor> title;    // quantity and unit of the colours
  vtkSmartPointer<vtkTextActor> second;   // what the outlines of a second wheelset are
  bool hasSecond = false;                 // and whether they are drawn
  bool stale = true, placed = false;
  double highest = 0, contactAt = 0, pixelRatio = 1;
  std::map<Field, double> largest;  // over all snapshots, once asked for
  Look look;
};

namespace {

double largestOfAll(const results::RunResult& result, Field field) {
  constexpr double reach = 0.1;  // [m] about the contact: what is clamped far away has peaks of its own
  double largest = 0;
  for (const auto& snapshot : result.snapshots) {
    const results::PatchSnapshot* patch = isOfPatch(field) ? patchOf(result, snapshot.name) : nullptr;
    largest = std::max(largest, patch              ? largestPressure(*patch)
                                : isOfPatch(field) ? 0.0
                                                   : largestNearContact(result.surface, snapshot, field, reach));
  }
  return largest;
}

}  // namespace

SceneView::SceneView(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

SceneView::~SceneView() = default;

std::unique_ptr<SceneView> SceneView::create(std::string& reason) {
  auto parts = std::make_unique<Parts>();
  parts->window = SurfacelessWindow::create(reason);
  if (!parts->window) return nullptr;
  parts->renderer = vtkSmartPointer<vtkRenderer>::New();
  parts->window->AddRenderer(parts->renderer);
  parts->bar = vtkSmartPointer<vtkRenderer>::New();
  parts->bar->SetViewport(1, 0, 1, 1);
  parts->window->AddRenderer(parts->bar);
  return std::unique_ptr<SceneView>(new SceneView(std::move(parts)));
}

void SceneView::setResult(std::shared_ptr<const results::RunResult> result) {
  parts_->result = std::move(result);
  parts_->largest.clear();
  parts_->stale = true;
}

void SceneView::setChoices(const SceneChoices& choices) {
  parts_->choices = choices;
  parts_->stale = true;
}

const SceneChoices& SceneView::choices() const { return parts_->choices; }

double SceneView::highest() const { return parts_->highest; }

void SceneView::rebuild() {
  Parts& my = *parts_;
  my.stale = false;
  my.surfaces.clear();
  my.renderer->RemoveAllViewProps();
  const double ground = my.choices.dark ? 0.13 : 1.0;
  my.renderer->SetBackground(ground, ground, my.choices.dark ? 0.14 : 1.0);
  if (!my.result) return;
  const auto& snapshots = my.result->snapshots;
  const bool has = my.choices.snapshot >= 0 && my.choices.snapshot < static_cast<int>(snapshots.size());
  const results::SurfaceSnapshot* snapshot = has ? &snapshots[static_cast<std::size_t>(my.choices.snapshot)] : nullptr;
  const double contactBefore = my.contactAt;
  my.contactAt = wheelCentre(my.result->surface)[0] + (snapshot ? snapshot->wheelTravel : 0);
  Look look;
  look.field = snapshot ? my.choices.field : Field::none;
  look.colourMap = my.choices.colourMap;
  look.edges = my.choices.edges;
  look.blend = true;
  look.dark = my.choices.dark;
  const auto parts = partData(my.result->surface, snapshot, look.field, my.choices.displacementScale);
  const results::PatchSnapshot* patch =
      snapshot && isOfPatch(look.field) ? patchOf(*my.result, snapshot->name) : nullptr;
  my.highest = 0;
  if (look.field != Field::none) {
    const auto [known, isNew] = my.largest.try_emplace(look.field, 0.0);
    if (isNew) known->second = largestOfAll(*my.result, look.field);
    my.highest = known->second;
  }
  look.high = roundUp(my.highest > 0 ? my.highest : 1);
  if (my.choices.cut) {
    look.cuts.push_back(vtkSmartPointer<vtkPlane>::New());
    look.cuts.back()->SetNormal(0, 1, 0);
  }
  for (const auto& part : parts) {
    if (isCutFace(part.name) && !my.choices.cut) continue;
    if (isOfPatch(look.field) && rolls(part.name)) continue;  // it stands over the patch
    my.surfaces.push_back(partActor(part, look));
    my.renderer->AddActor(my.surfaces.back());
  }
  if (patch)
    for (const auto& contact : contactsInPlace(*patch, my.result->surface))
      my.renderer->AddActor(patchActor(contact, parts, my.contactAt, look));
  // As the first wheelset, it would stand over the patch.
  const auto outlines = isOfPatch(look.field) ? std::vector<vtkSmartPointer<vtkActor>>()
                                              : secondWheelsetActors(*my.result, snapshot, look);
  for (const auto& outline : outlines) my.renderer->AddActor(outline);
  my.hasSecond = !outlines.empty();
  if (my.choices.springs)
    my.renderer->AddActor(springActor(springLines(my.result->surface, snapshot ? snapshot->wheelTravel : 0), 1.5));
  if (isOfPatch(look.field) && snapshot && !patch)
    my.renderer->AddActor2D(
        textActor("no contact patch was stored for this frame", 0.5, 0.94, letters, look.dark, 0.5));
  const bool nothingYields = snapshot && look.field == Field::plasticStrain && !(my.highest > 0);
  if (nothingYields)
    my.renderer->AddActor2D(
        textActor("no plastic strain (rail.plastic enables it)", 0.5, 0.94, letters, look.dark, 0.5));
  my.look = look;
  if (nothingYields) my.look.field = Field::none;  // no colours, no scale
  showLegend();
  if (!my.placed) {
    my.placed = true;
    lookFrom(my.choices.cut ? StandardView::contact : StandardView::overview);
  } else {
    // The eye travels with the wheel.
    double focal[3], eye[3];
    vtkCamera* camera = my.renderer->GetActiveCamera();
    camera->GetFocalPoint(focal);
    camera->GetPosition(eye);
    const double travelled = my.contactAt - contactBefore;
    camera->SetFocalPoint(focal[0] + travelled, focal[1], focal[2]);
    camera->SetPosition(eye[0] + travelled, eye[1], eye[2]);
  }
}

// Right of the model: the scale of the colours, or what sticks and what slips. Above it, what lines without a mesh are.
void SceneView::showLegend() {
  Parts& my = *parts_;
  const Look& look = my.look;
  const int high = std::max(1, static_cast<int>(std::lround(letters * my.pixelRatio)));
  const bool none = look.field == Field::none;
  my.bar->RemoveAllViewProps();
  my.bar->SetBackground(my.renderer->GetBackground());
  if (my.title) my.renderer->RemoveActor2D(my.title);
  my.renderer->SetViewport(0, 0, none ? 1.0 : barLeft, 1);
  my.bar->SetViewport(none ? 1.0 : barLeft, 0, 1, 1);
  if (my.second) my.renderer->RemoveActor2D(my.second);
  if (my.hasSecond) {
    my.second = textActor(kSecondWheelset, 0.02, 0.94, high, look.dark);
    my.renderer->AddActor2D(my.second);
  }
  if (none) return;
  my.title = textActor(fieldName(look.field), 0.98, 0.02, high, look.dark, 1);
  my.title->GetTextProperty()->SetBackgroundColor(my.renderer->GetBackground());
  my.title->GetTextProperty()->SetBackgroundOpacity(0.7);
  my.renderer->AddActor2D(my.title);
  if (look.field != Field::stickSlip) {
    my.bar->AddActor2D(colourBar(look, {0.12, 0.06, 0.8, 0.86}, high));
    return;
  }
  const std::pair<const char*, std::array<double, 3>> names[] = {{"sticks", stickColour}, {"slips", slipColour}};
  double height = 0.86;
  for (const auto& [name, colour] : names) {
    auto text = textActor(name, 0.12, height, high, look.dark);
    text->GetTextProperty()->SetColor(colour[0], colour[1], colour[2]);
    text->GetTextProperty()->SetBold(true);
    my.bar->AddActor2D(text);
    height -= 0.06;
  }
}

// Which way the wheel rolls on the picture; nothing where it comes towards the eye.
void SceneView::showHeading() {
  Parts& my = *parts_;
  if (my.heading) my.renderer->RemoveActor2D(my.heading);
  if (!my.result || my.surfaces.empty()) return;
  constexpr double minimum = 0.2;
  if (std::abs(heading()) < minimum) return;
  const int high = std::max(1, static_cast<int>(std::lround(letters * my.pixelRatio)));
  my.heading = textActor(heading() > 0 ? "rolls \u2192" : "\u2190 rolls", 0.02, 0.02, high, my.look.dark);
  my.heading->GetTextProperty()->SetBackgroundColor(my.renderer->GetBackground());  // readable on any part
  my.heading->GetTextProperty()->SetBackgroundOpacity(0.7);
  my.renderer->AddActor2D(my.heading);
}

double SceneView::heading() const {
  return parts_->renderer->GetActiveCamera()->GetModelViewTransformMatrix()->GetElement(0, 0);
}

Eye SceneView::eye() const {
  constexpr double degrees = 180 / std::numbers::pi;
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const double* direction = camera->GetDirectionOfProjection();
  Eye eye;
  eye.azimuth = degrees * std::atan2(-direction[1], -direction[0]);
  eye.elevation = degrees * -std::asin(std::clamp(direction[2], -1.0, 1.0));
  eye.reach = camera->GetParallelScale();
  camera->GetFocalPoint(eye.target.data());
  return eye;
}

Picture SceneView::render(int width, int height, bool moving, double pixelRatio) {
  const bool otherLetters = std::exchange(parts_->pixelRatio, pixelRatio) != pixelRatio;
  if (parts_->stale)
    rebuild();
  else if (otherLetters)
    showLegend();
  for (const auto& surface : parts_->surfaces)
    surface->GetProperty()->SetEdgeVisibility(parts_->choices.edges && !moving);
  showHeading();
  parts_->window->SetMultiSamples(moving ? 0 : 4);
  parts_->renderer->ResetCameraClippingRange();
  return parts_->window->renderPicture(std::max(width, 16), std::max(height, 16));
}

void SceneView::rotate(double right, double up) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  camera->Azimuth(right);
  // Straight above or below the view would flip over.
  const double* direction = camera->GetDirectionOfProjection();
  const double elevation = -std::asin(std::clamp(direction[2], -1.0, 1.0)) * 180 / std::numbers::pi;
  camera->Elevation(std::clamp(up, -88 - elevation, 88 - elevation));
  camera->SetViewUp(0, 0, 1);
}

void SceneView::pan(double right, double up, int height) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const double perPixel = 2 * camera->GetParallelScale() / std::max(height, 1);
  camera->OrthogonalizeViewUp();
  const double* direction = camera->GetDirectionOfProjection();
  const double* above = camera->GetViewUp();
  const double side[3] = {direction[1] * above[2] - direction[2] * above[1],
                          direction[2] * above[0] - direction[0] * above[2],
                          direction[0] * above[1] - direction[1] * above[0]};
  double focal[3], eye[3];
  camera->GetFocalPoint(focal);
  camera->GetPosition(eye);
  for (int axis = 0; axis < 3; ++axis) {
    const double shift = -perPixel * (right * side[axis] + up * above[axis]);
    focal[axis] += shift;
    eye[axis] += shift;
  }
  camera->SetFocalPoint(focal);
  camera->SetPosition(eye);
  camera->SetViewUp(0, 0, 1);
}

void SceneView::zoom(double factor) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  camera->SetParallelScale(std::clamp(camera->GetParallelScale() / factor, 1e-3, 50.0));
}

// From the side of the track's middle, so that the wheel rolls to the right, as the axes of all figures run. There the
// right side of a whole model would stand before the left one, which the case's keys describe: its side view is that
// from outside on the left, where the wheel rolls to the left.
void SceneView::lookFrom(StandardView view) {
  if (parts_->stale && parts_->placed) rebuild();
  const double x = parts_->contactAt;
  const bool isWhole = parts_->result && hasBothSides(parts_->result->surface);
  const double middle = isWhole ? middleAcross(parts_->result->surface) : 0;
  const double second = parts_->result ? secondWheelsetFrom(*parts_->result) : 0, between = x + 0.5 * second;
  switch (view) {
    case StandardView::overview:
      return aim(*parts_->renderer, {between, isWhole ? middle : -0.1, 0.22}, overviewFrom,
                 reachOfBoth(isWhole ? 1.2 : 0.75, second));
    case StandardView::contact:
      if (isOfPatch(parts_->choices.field)) return aim(*parts_->renderer, {x, 0, 0}, {0.3, -0.5, 0.8}, 0.014);
      return parts_->choices.cut ? aim(*parts_->renderer, {x, 0, 0}, {0.25, -0.95, 0.16}, 0.06)
                                 : aim(*parts_->renderer, {x, 0, 0}, {0.5, -0.75, 0.3}, 0.08);
    case StandardView::side:
      return aim(*parts_->renderer, {between, 0, 0.25}, {0, isWhole ? 1.0 : -1.0, 0}, reachOfBoth(0.75, second));
    case StandardView::front:
      return aim(*parts_->renderer, {x, isWhole ? middle : -0.2, 0.25}, {1, 0, 0}, isWhole ? 1.1 : 0.75);
    case StandardView::top:
      return aim(*parts_->renderer, {between, isWhole ? middle : -0.1, 0.2}, {0.0001, -0.02, 1},
                 reachOfBoth(isWhole ? 1.4 : 0.9, second));
  }
}

}  // namespace squat::scene
