#include "studio/project/NotesPanel.h"

namespace squat::studio {

NotesPanel::NotesPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("notes");
  setAccessibleName(tr("Notes"));
  setPlaceholderText(tr("Notes on this work. They are saved with the project (File > Save project as)."));
  setTabChangesFocus(true);
}

void NotesPanel::setNotes(const QString& notes) {
  setPlainText(notes);
  document()->clearUndoRedoStacks();
  document()->setModified(false);
}

}  // namespace squat::studio
