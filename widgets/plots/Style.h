// widgets/plots/Style.h - how figures look: sizes, fonts and colours in one place.
// Figures are drawn in units of 1/96 inch, on screen as in files: 321 units are one journal column (85 mm), a font of
// 11 units is 8 pt there.
#pragma once

#include <QColor>
#include <QFont>
#include <string>

namespace squat::plots {

constexpr double unitsPerMillimetre = 96.0 / 25.4;

struct Style {
  QColor background, text, axis, grid, muted, band;
  std::string colourMap = "viridis";
  bool dark = false;
  double fontScale = 1;  // larger letters for a window, which is read from farther away

  QFont labelFont() const;    // axis labels, 8 pt
  QFont tickFont() const;     // numbers and legend, 7 pt
  QFont captionFont() const;  // case and hash in the corner, 5.5 pt
  QColor curve(std::size_t index) const;
  QColor overlay(std::size_t index) const;  // of a run that is laid over another
};

Style lightStyle();  // files are always light
Style darkStyle();

}  // namespace squat::plots
