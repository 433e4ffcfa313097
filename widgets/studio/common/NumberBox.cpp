#include "studio/common/NumberBox.h"

#include <QLocale>

#include "studio/common/DecimalComma.h"

namespace squat::studio {

// Numbers look the same on every system, as in the form and in files.
NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) { setLocale(QLocale::c()); }

QValidator::State NumberBox::validate(QString& input, int& pos) const {
  input = withDecimalPoint(input);
  return input.contains(',') ? QValidator::Invalid : QDoubleSpinBox::validate(input, pos);
}

double NumberBox::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(withDecimalPoint(text));
}

// Qt's would take the commas out of a text that validate() has refused: "1,234.5" would become 1234.5.
void NumberBox::fixup(QString&) const {}

}  // namespace squat::studio
