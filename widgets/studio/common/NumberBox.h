// widgets/studio/common/NumberBox.h - a spin box for numbers that are typed with a decimal point or a decimal comma.
#pragma once

#include <QDoubleSpinBox>

namespace squat::studio {

// A comma becomes a point as it is typed; one more of either is refused. QDoubleSpinBox takes the comma of English for
// what stands between thousands, and reads "0,15" as 15. Prefix and suffix hold neither comma nor point.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& input, int& pos) const override;
  double valueFromText(const QString& text) const override;
  void fixup(QString& input) const override;
};

}  // namespace squat::studio
