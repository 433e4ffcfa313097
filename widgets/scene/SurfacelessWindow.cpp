#include "scene/SurfacelessWindow.h"

#include <vtkObjectFactory.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cstring>

namespace squat::scene {

vtkStandardNewMacro(SurfacelessWindow);

vtkSmartPointer<SurfacelessWindow> SurfacelessWindow::create(std::string& reason) {
  auto context = OffscreenContext::create(reason);
  if (!context) return nullptr;
  auto window = vtkSmartPointer<SurfacelessWindow>::New();
  window->context_ = std::move(context);
  window->SetReadyForRendering(true);
  window->SetMapped(1);
  window->SetIsCurrent(true);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetAlphaBitPlanes(1);
  return window;
}

SurfacelessWindow::~SurfacelessWindow() {
  // Graphics resources are released in the context they were made in, while it still exists.
  if (context_ && context_->makeCurrent()) Finalize();
}

void SurfacelessWindow::MakeCurrent() {
  if (context_) context_->makeCurrent();
}

bool SurfacelessWindow::IsCurrent() { return context_ && context_->isCurrent(); }

// Of the buffers that VTK renders into. Its own answer is that of the window's, and there are none: since version 9.3
// it warns that it has no answer.
int SurfacelessWindow::GetColorBufferSizes(int* rgba) {
  std::fill_n(rgba, 4, 8);
  return 4 * 8;
}

void SurfacelessWindow::OpenGLInitContext() {
  if (!Initialized && context_) {
    context_->makeCurrent();
    // GLEW of the system looks for GLX last, when every OpenGL function has been loaded: not finding it does no harm.
    const GLenum outcome = glewInit();
    GlewInitValid = outcome == GLEW_OK || outcome == GLEW_ERROR_NO_GLX_DISPLAY;
    Initialized = GlewInitValid;
  }
  Superclass::OpenGLInitContext();
}

Picture SurfacelessWindow::renderPicture(int width, int height) {
  MakeCurrent();
  SetSize(width, height);
  Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0);
  Picture picture;
  const std::size_t row = 3 * static_cast<std::size_t>(width);
  if (static_cast<std::size_t>(pixels->GetNumberOfValues()) != row * static_cast<std::size_t>(height)) return picture;
  picture.width = width;
  picture.height = height;
  picture.rgb.resize(row * static_cast<std::size_t>(height));
  for (int line = 0; line < height; ++line)  // OpenGL counts lines from below
    std::memcpy(&picture.rgb[row * static_cast<std::size_t>(line)],
                pixels->GetPointer(static_cast<vtkIdType>(row) * (height - 1 - line)), row);
  return picture;
}

}  // namespace squat::scene
