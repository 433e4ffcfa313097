// widgets/plots/UnitText.h - units as they are printed.
#pragma once

#include <QString>
#include <string>

namespace squat::plots {

// "m/s2" as m/s².
inline QString unitText(const std::string& unit) {
  return QString::fromStdString(unit).replace("s2", QString("s") + QChar(0x00B2));
}

}  // namespace squat::plots
