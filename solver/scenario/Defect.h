// solver/scenario/Defect.h - the shape of a defect as numbers; DefectSurface.h makes the surface of it.
#pragma once

#include <string>
#include <vector>

namespace squat::scenario {

enum class DefectShape { none, cut, cosine, wshape, dipWithWave, profile };
enum class LateralShape { uniform, parabolic };
enum class ProfileFilter { none, outliers, median };

struct ProfilePoint {
  double position = 0;  // [m] along the track
  double height = 0;    // [m] up positive: a dip is negative
};

// One of several profiles side by side.
struct ProfileLine {
  double lateral = 0;  // [m] on the rail's crown, from its middle outwards
  std::vector<ProfilePoint> points;
};

struct Defect {
  DefectShape shape = DefectShape::none;
  double length = 0;        // [m] of the dip
  double depth = 0;         // [m] positive
  double ramp = 0;          // [m] of each ramp of the cut
  double waveLength = 0;    // [m] trailing wave
  double waveDepth = 0;     // [m] amplitude of its dips
  double waveCount = 0;     // number of trailing waves
  double middleHeight = 0;  // [-] W shape: height of the middle ridge as a share of the depth
  LateralShape lateral = LateralShape::uniform;
  double halfWidth = 0;              // [m] parabolic: half width where the defect fades out
  std::string file;                  // path of the profile as the case names it
  std::vector<ProfilePoint> points;  // the profile as read, shape == profile
  std::vector<ProfileLine> lines;    // several profiles side by side; they count before points
  double from = 0, to = 0;           // [m] stretch of the profile that counts, in its own positions; equal: all of it
  ProfileFilter filter = ProfileFilter::none;  // of the points (MeasuredProfile.h)
  double filterWidth = 0;                      // [m] of its window
  double lateralCentre = 0;                    // [m] sideways shift of the whole defect on the crown
  double heightScale = 0;                      // [-] profile: factor on all heights
  bool level = false;      // profile: the line through its first and last point is the undisturbed surface
  bool moveNodes = false;  // surface nodes moved (true) or the profile as a term of the gap function (false)
};

}  // namespace squat::scenario
