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

// Left the parts, springs and mesh near the contact; right a close-up, cut at y = 0 so that the contact is seen,
// coloured by von Mises stress. Width 170 mm (two columns) at 300 dpi. Empty, with the reason, where this machine
// cannot draw it or the result has no surface. Takes the snapshot named "impact", else the last one that has stresses.
Picture modelPicture(const results::RunResult& result, const std::string& colourMap, std::string& reason);

// As above, to a file. Throws FileError where it cannot be written.
ModelPictureOutcome writeModelPicture(const results::RunResult& result, const std::string& colourMap,
                                      const std::string& path);

}  // namespace squat::scene
