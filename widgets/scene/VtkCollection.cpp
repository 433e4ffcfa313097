#include "scene/VtkCollection.h"

#include <vtkNew.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::scene {

std::string numberedName(const std::string& stem, std::size_t number) {
  char text[32];
  std::snprintf(text, sizeof text, "_%03zu.vtu", number);
  return stem + text;
}

VtkCollection::VtkCollection(std::string folder, std::string stem)
    : folder_(std::move(folder)), stem_(std::move(stem)) {
  makeFolder(folder_);
}

void VtkCollection::add(const vtkSmartPointer<vtkUnstructuredGrid>& grid, double time, int part,
                        const std::string& name) {
  written_.push_back(folder_ + "/" + name);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetInputData(grid);
  if (writer->Write() != 1) throw FileError(written_.back(), "", "cannot be made", "the result may be damaged");
  writeDurably(written_.back(), std::string_view(writer->GetOutputString()));
  char link[80];
  std::snprintf(link, sizeof link, "<DataSet timestep=\"%.9g\" part=\"%d\" file=\"", time, part);
  links_ += link + name + "\"/>\n";
}

std::vector<std::string> VtkCollection::finish() {
  written_.push_back(folder_ + "/" + stem_ + ".pvd");
  writeDurably(written_.back(),
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" + links_ +
                   "</Collection>\n</VTKFile>\n");
  return written_;
}

}  // namespace squat::scene
