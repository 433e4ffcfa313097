#include "scene/PatchActor.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "colours/ColourTables.h"
#include "scene/PatchFaces.h"

namespace squat::scene {
namespace {

constexpr double lift = 3e-5;  // [m] above the rail, so that the rail does not shine through

std::array<double, 3> colourOf(const results::PatchSnapshot& patch, std::size_t i, const Look& look) {
  if (look.field == Field::stickSlip) return i < patch.slipping.size() && patch.slipping[i] ? slipColour : stickColour;
  const double share = (1e-6 * static_cast<double>(patch.pressure[i]) - look.low) / (look.high - look.low);
  const colours::Rgb colour = colours::colourAt(look.colourMap, share);
  return {colour.red, colour.green, colour.blue};
}

}  // namespace

double largestPressure(const results::PatchSnapshot& patch) {
  double largest = patch.right ? largestPressure(*patch.right) : 0;
  for (const float pressure : patch.pressure)
    if (std::isfinite(pressure)) largest = std::max(largest, 1e-6 * static_cast<double>(pressure));
  return largest;
}

vtkSmartPointer<vtkActor> patchActor(const results::PatchSnapshot& patch, const std::vector<PartData>& parts,
                                     double contactAt, const Look& look) {
  const PatchFaces patchQuads = patchFaces(patch, parts, contactAt, lift);
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetNumberOfComponents(3);
  for (const std::size_t i : patchQuads.point) {
    const auto colour = colourOf(patch, i, look);
    unsigned char bytes[3];
    for (std::size_t channel = 0; channel < 3; ++channel)
      bytes[channel] = static_cast<unsigned char>(std::lround(255 * colour[channel]));
    shades->InsertNextTypedTuple(bytes);
  }
  const auto& data = patchQuads.faces;
  data->GetCellData()->SetScalars(shades);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(false);
  return actor;
}

}  // namespace squat::scene
