// widgets/scene/ColourLookup.h - our colour tables as VTK knows them.
#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <string>

namespace squat::scene {

vtkSmartPointer<vtkLookupTable> lookupTable(const std::string& map, double low, double high);

}  // namespace squat::scene
