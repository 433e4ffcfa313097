// widgets/scene/SceneView.h - the model as a picture that can be turned, for a window that paints it. No VTK in here.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "results/RunResult.h"
#include "scene/Field.h"
#include "scene/Picture.h"

namespace squat::scene {

enum class StandardView { overview, contact, side, front, top };

struct SceneChoices {
  Field field = Field::vonMises;
  std::string colourMap = "viridis";
  int snapshot = -1;  // index into the result's snapshots; -1: configuration at the start
  double displacementScale = 1;
  bool edges = true, springs = true, dark = false;
  bool cut = false;  // at y = 0; inner faces are shown there
};

// Where the eye stands as seen from what it looks at, and how much it sees.
struct Eye {
  double azimuth = 0, elevation = 0;  // [degrees] in the plane of the rail, from x towards y; above that plane
  double reach = 0;                   // [m] from the middle of the picture to its upper edge
  std::array<double, 3> target{};     // [m]
};

// Belongs to the thread that made it.
class SceneView {
 public:
  // Null, with the reason, where this machine has no OpenGL without a display.
  static std::unique_ptr<SceneView> create(std::string& reason);
  ~SceneView();

  // The first one is seen as a whole, or around the contact where the model is cut; later ones from where the eye is.
  void setResult(std::shared_ptr<const results::RunResult> result);
  void setChoices(const SceneChoices& choices);
  const SceneChoices& choices() const;

  // `moving`: coarser and without the lines of the mesh, for a smooth motion. `pixelRatio`: pixels of the picture for
  // one of a plain screen, so that letters keep their size.
  Picture render(int width, int height, bool moving = false, double pixelRatio = 1);

  void rotate(double right, double up);           // [degrees] of the eye around the focal point
  void pan(double right, double up, int height);  // [pixels] of a picture of that height
  void zoom(double factor);                       // above 1: nearer
  void lookFrom(StandardView view);
  // Of the rolling direction along the picture: 1 to the right, -1 to the left, 0 towards or away from the eye.
  double heading() const;
  Eye eye() const;
  // Largest value of the field over all snapshots of the result, in the unit of fieldName(): the colours stand for the
  // same values in every frame of an animation.
  double highest() const;

 private:
  struct Parts;
  explicit SceneView(std::unique_ptr<Parts> parts);
  void rebuild();
  void showLegend();
  void showHeading();
  std::unique_ptr<Parts> parts_;
};

}  // namespace squat::scene
