// widgets/studio/common/FixedLabel.h - a text that comes and goes in a place that stays.
#pragma once

#include <QLabel>

namespace squat::studio {

// Its height is that of `lines` lines, whatever it says, so that nothing moves under the mouse. A longer text ends in
// an ellipsis; the tool tip has all of it.
class FixedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit FixedLabel(int lines = 1, QWidget* parent = nullptr);
  void say(const QString& text);   // in the colour of what is around it
  void warn(const QString& text);  // an error

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void setLines();
  int lines_;
};

}  // namespace squat::studio
