// widgets/plots/UnitText.h - units as they are printed.
#pragma once

#include <QString>
#include <string>

#include "laboratory/PrintedUnit.h"

namespace squat::plots {

// "m/s2" as m/s², "(m/s2)2/Hz" as (m/s²)²/Hz; also inside the brackets of a name with its unit; an unknown unit says
// so.
inline QString unitText(const std::string& unit) {
  if (unit.empty()) return QStringLiteral("unknown unit");
  return QString::fromStdString(unit.find('[') == std::string::npos ? laboratory::printedUnit(unit)
                                                                    : laboratory::withPrintedUnit(unit));
}

}  // namespace squat::plots
