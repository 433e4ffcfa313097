// widgets/plots/UnitText.h - units as they are printed.
#pragma once

#include <QString>
#include <string>

namespace squat::plots {

// "m/s2" as m/s², "(m/s2)2/Hz" as (m/s²)²/Hz; a unit that nobody named says so.
inline QString unitText(const std::string& unit) {
  if (unit.empty()) return QStringLiteral("unit not named");
  const QString two(QChar(0x00B2));
  return QString::fromStdString(unit).replace("s2", "s" + two).replace(")2", ")" + two);
}

}  // namespace squat::plots
