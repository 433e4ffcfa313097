// widgets/studio/common/MessageBar.h - what failed, why and what to do, in the window itself; details on demand.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace squat::studio {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void say(const QString& sentence, const QString& details = {});   // news
  void warn(const QString& sentence, const QString& details = {});  // a failure
  QString text() const;

 private:
  void show(const QString& sentence, const QString& details, const QString& colour);
  QLabel *text_, *details_;
  QToolButton* more_;
};

}  // namespace squat::studio
