#include "scene/SurfaceData.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace squat::scene {
namespace {

using Point = std::array<double, 3>;

Point pointAt(const std::vector<float>& values, std::size_t index) {
  return {static_cast<double>(values[3 * index]), static_cast<double>(values[3 * index + 1]),
          static_cast<double>(values[3 * index + 2])};
}

// Rotation about the wheel's axis (parallel to y, positive rotation carries the top forward), then travel along x.
Point rolled(const Point& point, const Point& centre, double rotation, double travel) {
  const double x = point[0] - centre[0], z = point[2] - centre[2];
  const double c = std::cos(rotation), s = std::sin(rotation);
  return {centre[0] + c * x + s * z + travel, point[1], centre[2] - s * x + c * z};
}

float fieldAt(const results::SurfaceSnapshot& snapshot, Field field, std::size_t point) {
  switch (field) {
    case Field::vonMises:
      return point < snapshot.vonMises.size() ? 1e-6f * snapshot.vonMises[point] : 0.0f;
    case Field::plasticStrain:
      return point < snapshot.plasticStrain.size() ? snapshot.plasticStrain[point] : 0.0f;
    case Field::displacement: {
      if (3 * point + 2 >= snapshot.displacement.size()) return 0.0f;
      const Point u = pointAt(snapshot.displacement, point);
      return static_cast<float>(1e6 * std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
    }
    case Field::contactPressure:
    case Field::stickSlip:
    case Field::none:
      break;
  }
  return 0.0f;
}

struct PartBuilder {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkFloatArray> values;
  std::vector<vtkIdType> pointOf;  // surface point -> point of the part, -1 not yet used
};

}  // namespace

std::string fieldName(Field field) {
  switch (field) {
    case Field::vonMises:
      return "von Mises stress [MPa]";
    case Field::plasticStrain:
      return "Plastic strain [-]";
    case Field::displacement:
      return "Displacement [µm]";
    case Field::contactPressure:
      return "Contact pressure [MPa]";
    case Field::stickSlip:
      return "Stick and slip";
    case Field::none:
      break;
  }
  return {};
}

bool rolls(const std::string& partName) { return partName.rfind("wheel", 0) == 0; }

bool isCutFace(const std::string& partName) {
  const std::string ending = " cut";
  return partName.size() > ending.size() &&
         partName.compare(partName.size() - ending.size(), ending.size(), ending) == 0;
}

std::array<double, 3> wheelCentre(const results::SurfaceMesh& surface) {
  Point low{1e30, 0, 1e30}, high{-1e30, 0, -1e30};
  for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
    const std::size_t part = surface.part[quad];
    if (part >= surface.partNames.size() || !rolls(surface.partNames[part]) || isCutFace(surface.partNames[part]))
      continue;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto index = static_cast<std::size_t>(surface.quads[4 * quad + corner]);
      if (3 * index + 2 >= surface.points.size()) continue;
      const Point point = pointAt(surface.points, index);
      for (std::size_t axis : {0u, 2u}) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
    }
  }
  if (low[0] > high[0]) return {0, 0, 0};
  return {0.5 * (low[0] + high[0]), 0, 0.5 * (low[2] + high[2])};
}

bool hasBothSides(const results::SurfaceMesh& surface) {
  constexpr double beyondCentre = -1.2;  // [m] half of the widest gauge and more; the rail's axis is at 0
  for (std::size_t i = 1; i < surface.points.size(); i += 3)
    if (surface.points[i] < beyondCentre) return true;
  return false;
}

double middleAcross(const results::SurfaceMesh& surface) {
  constexpr double ofHalf = -0.12;  // [m]
  if (!hasBothSides(surface)) return ofHalf;
  float low = 0, high = 0;
  for (std::size_t i = 1; i < surface.points.size(); i += 3)
    low = std::min(low, surface.points[i]), high = std::max(high, surface.points[i]);
  return 0.5 * static_cast<double>(low + high);
}

std::vector<float> locationsOf(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot,
                               double displacementScale) {
  const std::size_t count = surface.points.size() / 3;
  const Point centre = wheelCentre(surface);
  std::vector<bool> rolling(count, false);
  for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
    const std::size_t part = surface.part[quad];
    if (part >= surface.partNames.size() || !rolls(surface.partNames[part])) continue;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto index = static_cast<std::size_t>(surface.quads[4 * quad + corner]);
      if (index < count) rolling[index] = true;
    }
  }
  std::vector<float> locations;
  locations.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    Point location = pointAt(surface.points, i);
    if (rolling[i]) location = rolled(location, centre, snapshot.wheelRotation, snapshot.wheelTravel);
    const bool moved = 3 * i + 2 < snapshot.displacement.size();
    const Point u = moved ? pointAt(snapshot.displacement, i) : Point{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis)
      locations.push_back(static_cast<float>(location[axis] + displacementScale * u[axis]));
  }
  return locations;
}

double largestNearContact(const results::SurfaceMesh& surface, const results::SurfaceSnapshot& snapshot, Field field,
                          double reach) {
  const std::vector<float> locations = locationsOf(surface, snapshot, 1);
  const double contactAt = wheelCentre(surface)[0] + snapshot.wheelTravel;
  double largest = 0;
  for (const auto corner : surface.quads) {
    const auto index = static_cast<std::size_t>(corner);
    if (3 * index + 2 >= locations.size() || !(std::abs(static_cast<double>(locations[3 * index]) - contactAt) < reach))
      continue;
    const auto value = static_cast<double>(fieldAt(snapshot, field, index));
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  return largest;
}

std::vector<PartData> partData(const results::SurfaceMesh& surface, const results::SurfaceSnapshot* snapshot,
                               Field field, double displacementScale) {
  const std::size_t pointCount = surface.points.size() / 3;
  const std::vector<float> locations = snapshot ? locationsOf(surface, *snapshot, displacementScale) : surface.points;
  std::vector<PartData> parts;
  for (std::size_t part = 0; part < surface.partNames.size(); ++part) {
    PartBuilder builder;
    builder.pointOf.assign(pointCount, -1);
    builder.values->SetName("field");
    for (std::size_t quad = 0; quad < surface.part.size() && 4 * quad + 3 < surface.quads.size(); ++quad) {
      if (surface.part[quad] != part) continue;
      std::array<vtkIdType, 4> corners{};
      bool valid = true;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto index = static_cast<std::size_t>(surface.quads[4 * quad + corner]);
        valid = valid && index < pointCount;
        if (!valid) break;
        vtkIdType& own = builder.pointOf[index];
        if (own < 0) {
          const Point location = pointAt(locations, index);
          if (snapshot) {
            builder.values->InsertNextValue(fieldAt(*snapshot, field, index));
          }
          own = builder.points->InsertNextPoint(location.data());
        }
        corners[corner] = own;
      }
      if (valid) builder.faces->InsertNextCell(4, corners.data());
    }
    if (builder.faces->GetNumberOfCells() == 0) continue;
    PartData data{surface.partNames[part], vtkSmartPointer<vtkPolyData>::New()};
    data.faces->SetPoints(builder.points);
    data.faces->SetPolys(builder.faces);
    if (snapshot && field != Field::none && !isOfPatch(field)) data.faces->GetPointData()->SetScalars(builder.values);
    parts.push_back(std::move(data));
  }
  return parts;
}

vtkSmartPointer<vtkPolyData> springLines(const results::SurfaceMesh& surface, double wheelTravel) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  constexpr int turns = 5;
  for (std::size_t spring = 0; 6 * spring + 5 < surface.springs.size(); ++spring) {
    const Point from = pointAt(surface.springs, 2 * spring), to = pointAt(surface.springs, 2 * spring + 1);
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const double shift = std::max(from[2], to[2]) > 0.05 ? wheelTravel : 0;  // suspension, not pad or ballast
    // The zigzag swings along x for upright springs and along z for those along the track.
    const bool upright = std::abs(to[2] - from[2]) > 0.5 * length;
    const double swing = std::min(0.18 * length, 0.02);
    lines->InsertNextCell(2 * turns + 2);
    for (int i = 0; i <= 2 * turns + 1; ++i) {
      const double share = static_cast<double>(i) / (2 * turns + 1);
      const double aside = i == 0 || i == 2 * turns + 1 ? 0 : (i % 2 ? swing : -swing);
      Point location;
      for (std::size_t axis = 0; axis < 3; ++axis) location[axis] = from[axis] + share * (to[axis] - from[axis]);
      location[0] += shift + (upright ? aside : 0);
      if (!upright) location[2] += aside;
      lines->InsertCellPoint(points->InsertNextPoint(location.data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

}  // namespace squat::scene
