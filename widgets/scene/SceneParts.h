// widgets/scene/SceneParts.h - the actors that every picture of the model is made of.
#pragma once

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

#include "scene/SurfaceData.h"

namespace squat::scene {

struct Look {
  Field field = Field::vonMises;
  std::string colourMap = "viridis";
  double low = 0, high = 1;                     // of the field, in the unit of fieldName()
  bool edges = true;                            // lines of the mesh
  bool blend = false;                           // where the field is low the part keeps its own colour
  bool dark = false;                            // background
  double lines = 1;                             // factor on the width of lines
  std::vector<vtkSmartPointer<vtkPlane>> cuts;  // only what lies on the side of each normal is shown
};

// Plain colours by part where `look.field` is none.
std::array<double, 3> partColour(const std::string& partName);
vtkSmartPointer<vtkActor> partActor(const PartData& part, const Look& look);
// Sharp edges and borders of the part.
vtkSmartPointer<vtkActor> outlineActor(const PartData& part, const Look& look);
vtkSmartPointer<vtkActor> springActor(vtkPolyData* lines, double width);

// Colour bar for `look`, upright; place and size as shares of the renderer; `textPixels` high letters.
vtkSmartPointer<vtkScalarBarActor> colourBar(const Look& look, const std::array<double, 4>& location, int textPixels);

// Text at a place given as shares of the renderer; `across` is the share of the text's width left of the place.
vtkSmartPointer<vtkTextActor> textActor(const std::string& text, double x, double y, int pixels, bool dark,
                                        double across = 0);

// Upper end of a scale with five even stretches of a round length.
double roundUp(double value);

// From the model to the eye that sees it as a whole: from the side of the track's middle, so that rolling is to the
// right. The axle box is on the other side of the wheel. An eye that sees both stands nearly in front of the wheel and
// 39 degrees above it, and shows neither rail nor wheel well.
inline constexpr std::array<double, 3> overviewFrom{0.55, -0.75, 0.42};

// Looks at `target` from `direction` (from target to eye), with `reach` metres from the middle to the upper edge.
void aim(vtkRenderer& renderer, const std::array<double, 3>& target, const std::array<double, 3>& direction,
         double reach);

}  // namespace squat::scene
