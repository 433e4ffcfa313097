// widgets/plots/SpectrumScale.h - how a spectrum is drawn. No Qt: a headless build knows the option too.
#pragma once

#include <array>
#include <string_view>

namespace squat::plots {

enum class SpectrumScale { linear, logarithmic, decibel, thirdOctaves };

// As they are typed, in the order of the enumerators.
constexpr std::array<std::string_view, 4> spectrumScaleNames{"linear", "log", "dB", "third-octaves"};

}  // namespace squat::plots
