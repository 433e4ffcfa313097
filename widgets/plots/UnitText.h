// widgets/plots/UnitText.h - units as they are printed.
#pragma once

#include <QString>
#include <string>

#include "text/Units.h"

namespace squat::plots {

// "m/s2" as m/s², "(m/s2)2/Hz" as (m/s²)²/Hz; also inside the brackets of a name with its unit; an unknown unit says
// so.
inline QString unitText(const std::string& unit) {
  if (unit.empty()) return QStringLiteral("unknown unit");
  return QString::fromStdString(unit.find('[') == std::string::npos ? text::printedUnit(unit)
                                                                    : text::withPrintedUnit(unit));
}

}  // namespace squat::plots
