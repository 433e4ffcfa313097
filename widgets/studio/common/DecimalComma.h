// widgets/studio/common/DecimalComma.h - numbers typed with a decimal comma.
#pragma once

#include <QString>

namespace squat::studio {

// "0,15 mm" as "0.15 mm". Only for texts of one number: in a list a comma separates. A text with several commas, or
// with a point beside the comma, stays as it is: one of them may stand between thousands.
inline QString withDecimalPoint(QString text) {
  return text.count(',') == 1 && !text.contains('.') ? text.replace(',', '.') : text;
}

}  // namespace squat::studio
