// widgets/scene/SurfacelessWindow.h - a VTK render window on an OffscreenContext.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

#include "scene/OffscreenContext.h"
#include "scene/Picture.h"

namespace squat::scene {

class SurfacelessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static SurfacelessWindow* New();
  vtkTypeMacro(SurfacelessWindow, vtkGenericOpenGLRenderWindow)

      // Null, with the reason, where there is no context to be had.
      static vtkSmartPointer<SurfacelessWindow> create(std::string& reason);

  void MakeCurrent() override;
  bool IsCurrent() override;
  int GetColorBufferSizes(int* rgba) override;
  Picture renderPicture(int width, int height);

 protected:
  SurfacelessWindow() = default;
  ~SurfacelessWindow() override;
  void OpenGLInitContext() override;

 private:
  std::unique_ptr<OffscreenContext> context_;
};

}  // namespace squat::scene
