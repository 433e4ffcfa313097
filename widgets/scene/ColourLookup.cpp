#include "scene/ColourLookup.h"

#include "colours/ColourTables.h"

namespace squat::scene {

vtkSmartPointer<vtkLookupTable> lookupTable(const std::string& map, double low, double high) {
  constexpr int entries = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(entries);
  for (int i = 0; i < entries; ++i) {
    const colours::Rgb colour = colours::colourAt(map, static_cast<double>(i) / (entries - 1));
    table->SetTableValue(i, colour.red, colour.green, colour.blue);
  }
  table->SetTableRange(low, high > low ? high : low + 1);
  return table;
}

}  // namespace squat::scene
