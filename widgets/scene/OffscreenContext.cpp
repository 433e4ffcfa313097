#include "scene/OffscreenContext.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>

namespace squat::scene {

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

// Displays that do not need a window system, the surest first. The display is shared by all contexts of the process and
// therefore never terminated.
EGLDisplay openDisplay() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  EGLDisplay display = EGL_NO_DISPLAY;
  if (extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless"))
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

EGLContext openContext(EGLDisplay display) {
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const EGLint anySurface[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
    if (!eglChooseConfig(display, anySurface, &config, 1, &count) || count < 1) return EGL_NO_CONTEXT;
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}

std::unique_ptr<OffscreenContext> OffscreenContext::create(std::string& reason) {
  auto handles = std::make_unique<Handles>();
  handles->display = openDisplay();
  if (handles->display == EGL_NO_DISPLAY) {
    reason = "no EGL display without a window system was found (install libegl1 and libgl1-mesa-dri)";
    return nullptr;
  }
  handles->context = openContext(handles->display);
  std::unique_ptr<OffscreenContext> context(new OffscreenContext(std::move(handles)));
  if (context->handles_->context == EGL_NO_CONTEXT || !context->makeCurrent()) {
    reason = "EGL gave no OpenGL 3.2 context (install libgl1-mesa-dri)";
    return nullptr;
  }
  return context;
}

OffscreenContext::~OffscreenContext() {
  if (handles_->context == EGL_NO_CONTEXT) return;
  if (isCurrent()) eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(handles_->display, handles_->context);
}

bool OffscreenContext::makeCurrent() {
  eglBindAPI(EGL_OPENGL_API);
  return eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context) == EGL_TRUE;
}

bool OffscreenContext::isCurrent() const {
  eglBindAPI(EGL_OPENGL_API);
  return eglGetCurrentContext() == handles_->context;
}

}  // namespace squat::scene
