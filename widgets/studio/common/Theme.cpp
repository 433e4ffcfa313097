#include "studio/common/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>

namespace squat::studio {
namespace {

QPalette darkPalette() {
  const QColor ground(40, 41, 44), base(56, 58, 62), text(232, 234, 237), muted(140, 142, 146), accent(86, 180, 233);
  QPalette palette(text, ground);
  palette.setColor(QPalette::Window, ground);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, ground);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, muted);
  palette.setColor(QPalette::Button, QColor(70, 72, 76));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::Highlight, QColor(0, 114, 178));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, muted);
  palette.setColor(QPalette::Disabled, QPalette::Light, ground);  // else disabled entries of menus are embossed
  return palette;
}

}  // namespace

void applyTheme(bool dark) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(dark ? darkPalette() : QApplication::style()->standardPalette());
}

bool requestedDark() {
  constexpr int middle = 128;  // of the lightness
  const bool desktop = QApplication::palette().color(QPalette::Window).lightness() < middle;
  return QSettings().value("dark", desktop).toBool();
}

plots::Style figureStyle(bool dark) {
  plots::Style style = dark ? plots::darkStyle() : plots::lightStyle();
  style.fontScale = 1.25;
  return style;
}

}  // namespace squat::studio
