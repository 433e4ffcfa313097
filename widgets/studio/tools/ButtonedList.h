// widgets/studio/tools/ButtonedList.h - a short list with buttons at its side that add to it and take from it.
#pragma once

#include <QListWidget>
#include <QToolButton>
#include <QWidget>

namespace squat::studio {

class ButtonedList : public QWidget {
 public:
  // `name`: of the buttons, "addTarget" for "Target". The list's own name is for screen readers.
  ButtonedList(const QString& name, const QString& addText, const QString& listName, int lines,
               QWidget* parent = nullptr);

  QListWidget* list() const { return list_; }
  QToolButton* add() const { return add_; }
  QToolButton* remove() const { return remove_; }

 private:
  QListWidget* list_;
  QToolButton *add_, *remove_;
};

// A small button with a text, named for tests and screen readers.
QToolButton* textButton(const QString& text, const QString& name, QWidget* parent);

}  // namespace squat::studio
