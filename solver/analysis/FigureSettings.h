// solver/analysis/FigureSettings.h - how the figures of a run are computed and drawn: what a call, the studio and a
// project choose.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace squat::analysis {

enum class SpectrumScale { linear, logarithmic, decibel, thirdOctaves };

// As they are typed and kept in files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 4> spectrumScaleNames{"linear", "log", "dB", "third-octaves"};
std::string nameOf(SpectrumScale scale);
std::optional<SpectrumScale> spectrumScaleNamed(std::string_view name);  // upper and lower case alike

struct Section {
  double from = 0, to = 0;  // [m] of the wheel's position
  bool operator==(const Section&) const = default;
};

struct FigureSettings {
  double cutoff = 2000;            // [Hz] low-pass, Butterworth of order 4 forward and back
  std::string window = "hann";     // of the spectrum
  std::optional<Section> section;  // that the spectrum is computed from; none: that of the run
  SpectrumScale spectrum = SpectrumScale::linear;
  int moment = -1;                     // of the contact patch, index into the result's patches; -1: the impact
  std::size_t segment = 128, hop = 0;  // [samples] of the short-time Fourier transform; hop 0: a 32nd of the segment
  std::string colours = "viridis";     // of maps: "viridis", "cividis", "jet"
  bool operator==(const FigureSettings&) const = default;
};

}  // namespace squat::analysis
