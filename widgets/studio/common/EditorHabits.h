// widgets/studio/common/EditorHabits.h - how editors share the mouse wheel and the undo keys with what stands around
// them.
#pragma once

class QWidget;

namespace squat::studio {

// Combo boxes, spin boxes and sliders in `part` take the wheel only while they have the focus: a form that is scrolled
// does not change the values that pass under the pointer.
void letWheelPass(QWidget& part);

// Undo and redo pressed in the line edits and spin boxes in `part` are those of the window, unless something is typed
// there that has not been entered yet.
void leaveUndoToWindow(QWidget& part);

}  // namespace squat::studio
