#include "plots/Style.h"

#include "colours/ColourTables.h"

namespace squat::plots {
namespace {

QFont fontOf(int pixels) {
  // The sans serif that Debian's fontconfig depends on: the same figure on every machine.
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(pixels);
  // Without hinting widths scale exactly, so a label fits at 300 dpi where it fits at 96.
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

// As it is seen on light or on dark ground.
QColor shade(const colours::Rgb& colour, bool dark) {
  const QColor plain = QColor::fromRgbF(colour.red, colour.green, colour.blue);
  if (!dark) return plain;
  return plain == QColor(Qt::black) ? QColor(Qt::white) : plain.lighter(125);
}

}  // namespace

QFont Style::labelFont() const { return fontOf(qRound(11 * fontScale)); }
QFont Style::tickFont() const { return fontOf(qRound(9 * fontScale)); }
QFont Style::captionFont() const { return fontOf(qRound(7 * fontScale)); }

QColor Style::curve(std::size_t index) const { return shade(colours::curveColour(index), dark); }
QColor Style::overlay(std::size_t index) const { return shade(colours::overlayColour(index), dark); }

Style lightStyle() {
  Style style;
  style.background = Qt::white;
  style.text = QColor(20, 20, 20);
  style.axis = QColor(60, 60, 60);
  style.grid = QColor(225, 225, 225);
  style.muted = QColor(110, 110, 110);
  style.band = QColor(0, 0, 0, 18);
  return style;
}

Style darkStyle() {
  Style style;
  style.background = QColor(32, 33, 36);
  style.text = QColor(232, 234, 237);
  style.axis = QColor(170, 172, 176);
  style.grid = QColor(62, 64, 68);
  style.muted = QColor(160, 162, 166);
  style.band = QColor(255, 255, 255, 22);
  style.dark = true;
  return style;
}

}  // namespace squat::plots
