// widgets/scene/VtkCollection.h - grids of many instants and the file that links them to their times.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>
#include <vector>

namespace squat::scene {

std::string numberedName(const std::string& stem, std::size_t number);  // STEM_007.vtu

class VtkCollection {
 public:
  VtkCollection(std::string folder, std::string stem);  // makes the folder

  // Writes the grid durably as `name`; `part` tells apart what stands beside each other at one time.
  void add(const vtkSmartPointer<vtkUnstructuredGrid>& grid, double time, int part, const std::string& name);
  // Writes STEM.pvd and returns all paths, that one last.
  std::vector<std::string> finish();

 private:
  std::string folder_, stem_, links_;
  std::vector<std::string> written_;
};

}  // namespace squat::scene
