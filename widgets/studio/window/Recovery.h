// widgets/studio/window/Recovery.h - unsaved changes survive a crash.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

#include "case/CaseDescription.h"

namespace squat::studio {

class CaseDocument;

// Keeps a copy of the changed case in `folder`, a few seconds after each change, under this process's number; gone as
// soon as the case is saved or the program ends in order.
class Recovery : public QObject {
  Q_OBJECT
 public:
  Recovery(CaseDocument& document, const QString& folder, QObject* parent = nullptr);
  ~Recovery() override;

  struct Found {
    cases::CaseDescription description;
    QString name;
  };
  // The copy that a process left which is no more; it is taken out of the folder. Unreadable ones are thrown away.
  static std::optional<Found> take(const QString& folder);

  void saveNow();
  void setHeld(bool held);  // nothing is kept: a project keeps the case
  void setDelay(int milliseconds) { timer_.setInterval(milliseconds); }

 private:
  QString file() const;
  CaseDocument& document_;
  QString folder_;
  QTimer timer_;
  bool held_ = false;
};

}  // namespace squat::studio
