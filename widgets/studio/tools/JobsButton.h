// widgets/studio/tools/JobsButton.h - what the tools compute now, in a fixed place of the main window.
#pragma once

#include <QToolButton>
#include <functional>
#include <vector>

class QMenu;

namespace squat::studio {

// How far one computation is, and what can be done with it.
struct Job {
  QString title, progress;  // "Study", "43 %, 1 min left"
  std::function<void()> show, cancel;
};

// Shows the progress of the first one and the number of others; its menu shows and cancels each. Its width is always
// the same.
class JobsButton : public QToolButton {
  Q_OBJECT
 public:
  explicit JobsButton(QWidget* parent = nullptr);
  void setJobs(std::vector<Job> jobs);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 private:
  void fillMenu();
  std::vector<Job> jobs_;
  QMenu* menu_;
};

}  // namespace squat::studio
