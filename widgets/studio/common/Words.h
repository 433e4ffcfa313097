// widgets/studio/common/Words.h - keys, units and legends as they are printed in the window, and as machines read them.
#pragma once

#include <QString>

namespace squat::studio {

// "rail.young_modulus" -> "Young's modulus"
QString parameterLabel(const std::string& key);

// ASCII units of files as print has them: "m/s2" -> "m/s²", "us" -> "µs".
QString printedUnits(QString text);

// A legend or run label as a short name: "axle box (−92 … 106)" -> "axle_box".
QString machineName(const QString& legend);

// A label of an axis as a column: "Vertical acceleration [m/s²]" -> "acceleration [m/s2]".
QString columnName(const QString& axisLabel);

}  // namespace squat::studio
