#include "scene/SceneParts.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "colours/ColourTables.h"
#include "scene/ColourLookup.h"

namespace squat::scene {
namespace {

// The letters of the figures where Debian has them, else VTK's own.
void setLetters(vtkTextProperty& text, int pixels, bool dark) {
  static const char* const file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (std::filesystem::exists(file)) {
    text.SetFontFamily(VTK_FONT_FILE);
    text.SetFontFile(file);
  } else {
    text.SetFontFamilyToArial();
  }
  text.SetFontSize(pixels);
  text.SetItalic(false);
  text.SetBold(false);
  text.SetShadow(false);
  const double grey = dark ? 0.92 : 0.08;
  text.SetColor(grey, grey, grey);
}

// Colours of the map, fading into the part's own colour over the lowest tenth of the scale, so that parts can be told
// apart away from the contact.
vtkSmartPointer<vtkPolyData> withBlendedColours(const PartData& part, const Look& look) {
  constexpr double fade = 0.1;
  vtkDataArray* values = part.faces->GetPointData()->GetScalars();
  const auto own = partColour(part.name);
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetName("colours");
  shades->SetNumberOfComponents(3);
  shades->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) {
    const double share = (values->GetTuple1(i) - look.low) / (look.high - look.low);
    const double weight = std::isfinite(share) ? std::clamp(share / fade, 0.0, 1.0) : 0.0;
    const colours::Rgb map = colours::colourAt(look.colourMap, share);
    const double mixed[3] = {own[0] + weight * (map.red - own[0]), own[1] + weight * (map.green - own[1]),
                             own[2] + weight * (map.blue - own[2])};
    for (int channel = 0; channel < 3; ++channel)
      shades->SetTypedComponent(i, channel, static_cast<unsigned char>(std::lround(255 * mixed[channel])));
  }
  auto painted = vtkSmartPointer<vtkPolyData>::New();
  painted->ShallowCopy(part.faces);
  painted->GetPointData()->SetScalars(shades);
  return painted;
}

}  // namespace

std::array<double, 3> partColour(const std::string& partName) {
  if (partName.rfind("rail", 0) == 0) return {0.36, 0.52, 0.68};
  if (partName.rfind("sleeper", 0) == 0) return {0.80, 0.76, 0.66};
  if (partName.rfind("wheel rim", 0) == 0) return {0.84, 0.60, 0.30};
  if (partName.rfind("wheel", 0) == 0) return {0.74, 0.77, 0.79};
  return {0.6, 0.6, 0.6};
}

vtkSmartPointer<vtkActor> partActor(const PartData& part, const Look& look) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(part.faces);
  const bool coloured = look.field != Field::none && part.faces->GetPointData()->GetScalars();
  mapper->SetScalarVisibility(coloured);
  if (coloured && look.blend) {
    mapper->SetInputData(withBlendedColours(part, look));
    mapper->SetColorModeToDirectScalars();
  } else if (coloured) {
    mapper->SetLookupTable(lookupTable(look.colourMap, look.low, look.high));
    mapper->SetUseLookupTableScalarRange(true);
    mapper->SetInterpolateScalarsBeforeMapping(true);
  }
  if (!isCutFace(part.name))
    for (const auto& plane : look.cuts) mapper->AddClippingPlane(plane);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  const auto colour = partColour(part.name);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetInterpolationToFlat();
  property->SetAmbient(coloured ? 0.45 : 0.25);
  property->SetDiffuse(coloured ? 0.6 : 0.75);
  property->SetEdgeVisibility(look.edges);
  property->SetEdgeColor(0.25, 0.27, 0.30);
  property->SetLineWidth(static_cast<float>(0.8 * look.lines));
  return actor;
}

vtkSmartPointer<vtkActor> outlineActor(const PartData& part, const Look& look) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(part.faces);
  edges->SetFeatureAngle(25);
  edges->ColoringOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->SetScalarVisibility(false);
  for (const auto& plane : look.cuts) mapper->AddClippingPlane(plane);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.15, 0.17, 0.20);
  actor->GetProperty()->SetLineWidth(static_cast<float>(1.6 * look.lines));
  actor->GetProperty()->SetLighting(false);
  return actor;
}

vtkSmartPointer<vtkActor> springActor(vtkPolyData* lines, double width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.80, 0.20, 0.15);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->SetLighting(false);
  return actor;
}

vtkSmartPointer<vtkScalarBarActor> colourBar(const Look& look, const std::array<double, 4>& location, int textPixels) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(lookupTable(look.colourMap, look.low, look.high));
  bar->SetNumberOfLabels(6);
  bar->SetLabelFormat(look.high < 10 ? "%.3g" : "%.0f");
  bar->UnconstrainedFontSizeOn();
  bar->SetTitle("");
  bar->SetBarRatio(0.25);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(location[0], location[1]);
  bar->SetWidth(location[2]);
  bar->SetHeight(location[3]);
  setLetters(*bar->GetLabelTextProperty(), textPixels, look.dark);
  return bar;
}

vtkSmartPointer<vtkTextActor> textActor(const std::string& text, double x, double y, int pixels, bool dark,
                                        double across) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(x, y);
  vtkTextProperty* property = actor->GetTextProperty();
  setLetters(*property, pixels, dark);
  if (across >= 1)
    property->SetJustificationToRight();
  else if (across > 0)
    property->SetJustificationToCentered();
  return actor;
}

double roundUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value / 5)));
  for (double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (5 * step * decade >= value) return 5 * step * decade;
  return 50 * decade;
}

void aim(vtkRenderer& renderer, const std::array<double, 3>& target, const std::array<double, 3>& direction,
         double reach) {
  vtkCamera* camera = renderer.GetActiveCamera();
  camera->SetFocalPoint(target.data());
  camera->SetPosition(target[0] + 5 * direction[0], target[1] + 5 * direction[1], target[2] + 5 * direction[2]);
  camera->SetViewUp(0, 0, 1);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(reach);
  renderer.ResetCameraClippingRange();
}

}  // namespace squat::scene
