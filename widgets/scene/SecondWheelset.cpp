#include "scene/SecondWheelset.h"

#include <vtkProperty.h>

#include <cmath>

#include "case/Resolve.h"

namespace squat::scene {

double secondWheelsetFrom(const results::RunResult& result) {
  if (!result.resolvedCase) return 0;
  const auto& bogie = result.resolvedCase->scenario.bogie;
  return bogie.hasSecond() ? bogie.offset() : 0;
}

std::vector<vtkSmartPointer<vtkActor>> secondWheelsetActors(const results::RunResult& result,
                                                            const results::SurfaceSnapshot* snapshot,
                                                            const Look& look) {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  const double from = secondWheelsetFrom(result);
  if (from == 0) return actors;
  for (const auto& part : partData(result.surface, snapshot, Field::none, 0)) {
    if (!rolls(part.name) || isCutFace(part.name)) continue;
    const auto& actor = actors.emplace_back(outlineActor(part, look));
    actor->SetPosition(from, 0, 0);
    actor->GetProperty()->SetColor(0.5, 0.5, 0.5);
  }
  return actors;
}

double reachOfBoth(double reach, double secondFrom) {
  return reach + 0.4 * std::abs(secondFrom);  // half of it, as long as a view at an angle shows it
}

}  // namespace squat::scene
