#include "analysis/FigureSettings.h"

#include "text/Text.h"

namespace squat::analysis {

std::string nameOf(SpectrumScale scale) { return std::string(spectrumScaleNames.at(static_cast<std::size_t>(scale))); }

std::optional<SpectrumScale> spectrumScaleNamed(std::string_view name) {
  for (std::size_t i = 0; i < spectrumScaleNames.size(); ++i)
    if (text::lowerCase(spectrumScaleNames[i]) == text::lowerCase(name)) return static_cast<SpectrumScale>(i);
  return std::nullopt;
}

}  // namespace squat::analysis
