#include "studio/common/EditorHabits.h"

#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace squat::studio {
namespace {

class WheelFilter : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* editor = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || !editor || editor->hasFocus()) return false;
    event->ignore();  // so that it goes to what stands around
    return true;
  }
};

// The text of a spin box may be its value written otherwise ("0.20 mm").
bool isTyping(const QObject* editor) {
  if (const auto* line = qobject_cast<const QLineEdit*>(editor)) return line->isModified();
  if (const auto* number = qobject_cast<const QDoubleSpinBox*>(editor))
    return number->valueFromText(number->text()) != number->value();
  return false;
}

// A line edit claims the keys even where it has nothing to undo.
class UndoFilter : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride || isTyping(watched)) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void letWheelPass(QWidget& part) {
  auto* filter = new WheelFilter(&part);
  for (auto* editor : part.findChildren<QWidget*>()) {
    const bool turns =
        editor->inherits("QComboBox") || editor->inherits("QAbstractSpinBox") || editor->inherits("QSlider");
    if (!turns) continue;
    editor->setFocusPolicy(Qt::StrongFocus);  // the wheel alone does not give the focus either
    editor->installEventFilter(filter);
  }
}

void leaveUndoToWindow(QWidget& part) {
  auto* filter = new UndoFilter(&part);
  for (auto* editor : part.findChildren<QWidget*>())
    if (editor->inherits("QLineEdit") || editor->inherits("QAbstractSpinBox")) editor->installEventFilter(filter);
}

}  // namespace squat::studio
