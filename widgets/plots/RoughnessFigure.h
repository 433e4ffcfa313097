// widgets/plots/RoughnessFigure.h - levels of third octaves of wavelength beside the limit of ISO 3095.
#pragma once

#include <string>

#include "plots/FigureSheet.h"
#include "roughness/RoughnessGauge.h"

namespace squat::plots {

// Sheet `name`: the level that a record implies, between its bounds, over the wavelength.
FigureSheet roughnessFigure(const roughness::RecordRoughness& roughness, const std::string& name, const Style& style);

}  // namespace squat::plots
