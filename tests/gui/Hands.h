// tests/gui/Hands.h - what a user's hands do: keys, menus, dialogs. Nothing in here calls a slot.
#pragma once

#include <QPoint>
#include <QString>
#include <QStringList>
#include <memory>

class QWidget;

namespace squat::tests {

inline constexpr int patience = 240000;  // [ms] for busy machines and sanitizers; below the time that a test has
inline constexpr double pixel = 0.01;    // of an axis: a pixel of some 400, and rounding

// Keys as the window system sends them: to the window, which is brought to the front; whatever has the focus takes
// them.
void press(QWidget& window, int key, Qt::KeyboardModifiers modifiers = {});
void type(QWidget& window, const QString& text);  // ASCII

// The mouse at a place of the window, so that a widget which is covered or out of sight cannot be hit.
void click(QWidget& target);
void drag(QWidget& target, const QPoint& from, const QPoint& to);  // places in the target

// One notch towards the user over the target, which may be out of sight. What it does not take goes to what it stands
// in.
void turnWheel(QWidget& target);

// Opens the menus one after the other with the mouse and clicks the last entry. Titles without "&".
void clickMenu(QWidget& window, const QStringList& titles);

// Waits for the next dialog that opens, types `path` into its name line and presses Return. Files are opened, saved and
// folders chosen in the same way. Make it before the dialog opens; `done()` tells whether one came.
class FileDialogTyping {
 public:
  explicit FileDialogTyping(const QString& path);
  ~FileDialogTyping();
  bool done() const;

 private:
  struct Watch;
  std::unique_ptr<Watch> watch_;
};

// The same for a question: clicks the button with this text (without "&").
class BoxAnswer {
 public:
  explicit BoxAnswer(const QString& button);
  ~BoxAnswer();
  bool done() const;
  QString question() const;

 private:
  struct Watch;
  std::unique_ptr<Watch> watch_;
};

}  // namespace squat::tests
