// widgets/studio/common/HeightUnit.h - in what heights of the profile are shown and typed.
#pragma once

#include <QString>

namespace squat::studio {

struct HeightUnit {
  QString name = QStringLiteral("µm");
  double perMetre = 1e6;
  int digits = 1;  // after the point, of a place under the mouse
};

inline HeightUnit micrometres() { return {}; }
inline HeightUnit millimetres() { return {QStringLiteral("mm"), 1e3, 4}; }

}  // namespace squat::studio
