// widgets/scene/ModelPicture.h - the figure "model": the model near the contact, and the stress around the contact.
#pragma once

#include <string>

#include "results/RunResult.h"
#include "scene/Picture.h"

namespace squat::scene {

struct ModelPictureOutcome {
  bool written = false;
  std::string reason;  // why not, in one sentence
};

// On paper; two columns of a journal unless another size is asked for.
struct PictureSize {
  double width = 170, height = 90;  // [mm]
  double resolution = 300;          // [dpi]

  static constexpr int maximumPixels = 8192;  // of a side, within what graphics drivers draw
};

// Left the parts, springs and mesh near the contact, and of a bogie the outlines of its second wheelset; right a
// close-up, cut at y = 0 so that the contact is seen, coloured by von Mises stress. Empty, with the reason, where this
// machine cannot draw it, the result has no surface or the picture would have too many pixels. Takes the snapshot named
// "impact", else the last one that has stresses.
Picture modelPicture(const results::RunResult& result, const std::string& colourMap, std::string& reason,
                     const PictureSize& size = {});

// As above, to a file. Throws FileError where it cannot be written.
ModelPictureOutcome writeModelPicture(const results::RunResult& result, const std::string& colourMap,
                                      const std::string& path, const PictureSize& size = {});

}  // namespace squat::scene
