// widgets/studio/common/MessageBar.h - what failed, why and what to do, in a line of the window that is always there.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace squat::studio {

// A sentence that does not fit ends in an ellipsis; "Details" shows all of it, with the details, above the line.
// Nothing moves when a message comes or goes.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void say(const QString& sentence, const QString& details = {});   // news
  void warn(const QString& sentence, const QString& details = {});  // a failure
  void clear();
  QString text() const;  // empty: there is no message
  bool isEmpty() const { return text().isEmpty(); }
  QString details() const { return details_; }
  void showDetails();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show(const QString& sentence, const QString& details, const QString& colour);
  void showButtons();
  QLabel* text_;
  QString details_;
  QToolButton *more_, *close_;
};

}  // namespace squat::studio
