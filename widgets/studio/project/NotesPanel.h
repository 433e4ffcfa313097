// widgets/studio/project/NotesPanel.h - notes on the work, kept in the project.
#pragma once

#include <QPlainTextEdit>

namespace squat::studio {

class NotesPanel : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit NotesPanel(QWidget* parent = nullptr);
  void setNotes(const QString& notes);  // of another project: nothing of the one before can be undone
};

}  // namespace squat::studio
