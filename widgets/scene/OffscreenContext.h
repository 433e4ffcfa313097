// widgets/scene/OffscreenContext.h - an OpenGL context that needs no display: EGL without a surface.
#pragma once

#include <memory>
#include <string>

namespace squat::scene {

// One OpenGL 3.2 core context. Belongs to the thread that makes it current; not to be shared between threads.
class OffscreenContext {
 public:
  // Null, with the reason in one sentence, where this machine has no EGL that can do it. Never aborts.
  static std::unique_ptr<OffscreenContext> create(std::string& reason);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  bool makeCurrent();
  bool isCurrent() const;

 private:
  struct Handles;
  explicit OffscreenContext(std::unique_ptr<Handles> handles);
  std::unique_ptr<Handles> handles_;
};

}  // namespace squat::scene
