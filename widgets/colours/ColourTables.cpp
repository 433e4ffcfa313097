#include "colours/ColourTables.h"

#include <algorithm>
#include <cmath>

namespace squat::colours {
namespace {

constexpr Rgb fromHex(unsigned hex) {
  return {((hex >> 16) & 255u) / 255.0, ((hex >> 8) & 255u) / 255.0, (hex & 255u) / 255.0};
}

// Ten even stations of each map; straight lines in between stay within 1 % of the published 256-entry tables.
// viridis: van der Walt and Smith (2015). cividis: Nunez, Anderton and Renslow (2018), PLoS ONE 13(7).
constexpr std::array<Rgb, 10> viridis{fromHex(0x440154), fromHex(0x482878), fromHex(0x3e4989), fromHex(0x31688e),
                                      fromHex(0x26828e), fromHex(0x1f9e89), fromHex(0x35b779), fromHex(0x6ece58),
                                      fromHex(0xb5de2b), fromHex(0xfde725)};
constexpr std::array<Rgb, 10> cividis{fromHex(0x00224e), fromHex(0x123570), fromHex(0x3b496c), fromHex(0x575d6d),
                                      fromHex(0x707173), fromHex(0x8a8678), fromHex(0xa59c74), fromHex(0xc3b369),
                                      fromHex(0xe1cc55), fromHex(0xfee838)};
constexpr std::array<Rgb, 9> jet{fromHex(0x00007f), fromHex(0x0000ff), fromHex(0x007fff),
                                 fromHex(0x00ffff), fromHex(0x7fff7f), fromHex(0xffff00),
                                 fromHex(0xff7f00), fromHex(0xff0000), fromHex(0x7f0000)};

template <std::size_t count>
Rgb interpolate(const std::array<Rgb, count>& table, double share) {
  const double location = (std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0) * (count - 1);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(location), count - 2);
  const double weight = location - static_cast<double>(below);
  const Rgb& a = table[below];
  const Rgb& b = table[below + 1];
  return {a.red + weight * (b.red - a.red), a.green + weight * (b.green - a.green),
          a.blue + weight * (b.blue - a.blue)};
}

double linearLight(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

}  // namespace

const std::vector<std::string>& mapNames() {
  static const std::vector<std::string> names{"viridis", "cividis", "jet"};
  return names;
}

bool isMapName(const std::string& name) {
  return std::find(mapNames().begin(), mapNames().end(), name) != mapNames().end();
}

Rgb colourAt(const std::string& map, double share) {
  if (map == "jet") return interpolate(jet, share);
  if (map == "cividis") return interpolate(cividis, share);
  return interpolate(viridis, share);
}

Rgb curveColour(std::size_t index) {
  static constexpr std::array<Rgb, 8> curves{fromHex(0x0072b2), fromHex(0xd55e00), fromHex(0x009e73),
                                             fromHex(0xcc79a7), fromHex(0xe69f00), fromHex(0x56b4e9),
                                             fromHex(0x000000), fromHex(0xf0e442)};
  return curves[index % curves.size()];
}

Rgb overlayColour(std::size_t index) {
  static constexpr std::array<Rgb, overlayColours> overlays{fromHex(0x009e73), fromHex(0xcc79a7), fromHex(0x000000),
                                                            fromHex(0x8fb800), fromHex(0x5e3c99), fromHex(0x666666)};
  return overlays[index % overlays.size()];
}

double luminance(const Rgb& colour) {
  return 0.2126 * linearLight(colour.red) + 0.7152 * linearLight(colour.green) + 0.0722 * linearLight(colour.blue);
}

}  // namespace squat::colours
