// widgets/scene/Picture.h - pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace squat::scene {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // from the top line down, 3 per pixel

  bool empty() const { return rgb.empty(); }
};

// Writes a PNG whole or not at all, with its resolution [dpi] in it. Throws FileError.
void writePng(const Picture& picture, const std::string& path, double resolution = 300);

}  // namespace squat::scene
