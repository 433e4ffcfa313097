#include "studio/tools/JobsButton.h"

#include <QMenu>
#include <utility>

namespace squat::studio {

JobsButton::JobsButton(QWidget* parent) : QToolButton(parent), menu_(new QMenu(this)) {
  setObjectName("jobs");
  setAccessibleName(tr("What the tools compute"));
  setAutoRaise(true);
  setShortcut(QKeySequence("Ctrl+Alt+J"));
  setMenu(menu_);
  setPopupMode(QToolButton::InstantPopup);
  connect(menu_, &QMenu::aboutToShow, this, &JobsButton::fillMenu);
  setJobs({});
}

QSize JobsButton::sizeHint() const {
  constexpr int letters = 34;
  return {fontMetrics().horizontalAdvance(QString(letters, 'x')), fontMetrics().height() + 4};
}

void JobsButton::setJobs(std::vector<Job> jobs) {
  jobs_ = std::move(jobs);
  QString words = jobs_.empty() ? QString() : tr("%1: %2").arg(jobs_[0].title, jobs_[0].progress);
  if (jobs_.size() > 1) words = tr("%1 and %2 more").arg(words).arg(jobs_.size() - 1);
  constexpr int arrow = 24;
  setText(fontMetrics().elidedText(words, Qt::ElideMiddle, sizeHint().width() - arrow));
  setToolTip(jobs_.empty() ? tr("The tools compute nothing now (Ctrl+Alt+J)") : words + tr(" (Ctrl+Alt+J)"));
  setAccessibleDescription(words);
  setEnabled(!jobs_.empty());
}

// A job may end while the menu is open; its entries do nothing then.
void JobsButton::fillMenu() {
  menu_->clear();
  for (const Job& job : jobs_) {
    menu_->addAction(tr("Show %1").arg(job.title), this, job.show);
    menu_->addAction(tr("Cancel %1").arg(job.title), this, job.cancel);
  }
}

}  // namespace squat::studio
