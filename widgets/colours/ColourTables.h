// widgets/colours/ColourTables.h - colours of curves and maps, shared by figures and scene. No Qt, no VTK.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace squat::colours {

struct Rgb {
  double red = 0, green = 0, blue = 0;  // 0..1
};

// Names that colourAt() knows. The first, "viridis", is the default; "viridis" and "cividis" are readable with every
// kind of colour blindness and in grey, "jet" is not and is there for comparison with older papers.
const std::vector<std::string>& mapNames();
bool isMapName(const std::string& name);

// Colour of `share` (clamped to 0..1) in the named map; an unknown name is read as "viridis".
Rgb colourAt(const std::string& map, double share);

// Curves: the eight colours of Okabe and Ito (2008), "Color Universal Design", ordered for contrast on white.
// Counts around when there are more curves than colours.
Rgb curveColour(std::size_t index);

// Runs that are laid over another one, whose two curves have the first two colours above: six that are far from those,
// from each other and from white and dark ground (40 and more in CIELAB, with the lighter shades on dark as well).
// Counts around.
constexpr std::size_t overlayColours = 6;
Rgb overlayColour(std::size_t index);

// Relative luminance, 0 black .. 1 white (ITU-R BT.709 weights on linear light).
double luminance(const Rgb& colour);

}  // namespace squat::colours
