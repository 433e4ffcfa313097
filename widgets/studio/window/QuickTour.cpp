#include "studio/window/QuickTour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

namespace squat::studio {
namespace {

constexpr int cardWidth = 340, gap = 10;  // [pixels]

// Right of the part, left of it, below or above, where the card has room; else in the part's middle.
QPoint cornerBeside(const QRect& part, const QSize& card, const QRect& window) {
  const int x = part.center().x() - card.width() / 2, y = part.center().y() - card.height() / 2;
  const QPoint choices[] = {{part.right() + gap, y},
                            {part.left() - gap - card.width(), y},
                            {x, part.top() - gap - card.height()},
                            {x, part.bottom() + gap}};
  const auto within = [&](QPoint corner) {
    return QPoint(std::clamp(corner.x(), gap, std::max(gap, window.width() - card.width() - gap)),
                  std::clamp(corner.y(), gap, std::max(gap, window.height() - card.height() - gap)));
  };
  for (const QPoint& corner : choices) {
    const QPoint moved = within(corner);
    if (!QRect(moved, card).intersects(part)) return moved;
  }
  return within({x, y});
}

}  // namespace

QuickTour::QuickTour(std::vector<Stop> stops, QWidget& window)
    : QFrame(&window), all_(std::move(stops)), window_(window), outline_(new QFrame(&window)) {
  setObjectName("quickTour");
  setAccessibleName(tr("Quick tour"));
  setAttribute(Qt::WA_DeleteOnClose);
  outline_->setObjectName("quickTourOutline");
  outline_->setAttribute(Qt::WA_TransparentForMouseEvents);
  outline_->setStyleSheet("#quickTourOutline { border: 3px solid palette(highlight); border-radius: 4px; }");
  outline_->show();
  focusBefore_ = window.focusWidget();
  makeCard();
  window_.installEventFilter(this);
  show();
  go(0);
}

void QuickTour::makeCard() {
  setFrameShape(QFrame::StyledPanel);
  setStyleSheet(
      "#quickTour { background: palette(window); border: 1px solid palette(highlight); border-radius: 4px; }");
  title_ = new QLabel(this);
  title_->setObjectName("quickTourTitle");
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  words_ = new QLabel(this);
  words_->setObjectName("quickTourWords");
  words_->setWordWrap(true);
  count_ = new QLabel(this);
  auto* close = new QPushButton(tr("&Close"), this);
  close->setObjectName("quickTourClose");
  close->setToolTip(tr("End the tour (Esc); Help > Quick tour shows it again"));
  back_ = new QPushButton(tr("&Back"), this);
  back_->setObjectName("quickTourBack");
  next_ = new QPushButton(tr("&Next"), this);
  next_->setObjectName("quickTourNext");
  connect(close, &QPushButton::clicked, this, &QuickTour::end);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QuickTour::end);
  connect(back_, &QPushButton::clicked, this, [this] { go(stop_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { go(stop_ + 1); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(count_);
  buttons->addStretch();
  for (QPushButton* button : {close, back_, next_}) buttons->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(words_);
  layout->addLayout(buttons);
}

void QuickTour::go(int stop) {
  if (stop >= stops()) return end();
  stop_ = std::max(stop, 0);
  const Stop& shown = all_[static_cast<std::size_t>(stop_)];
  if (part_) part_->removeEventFilter(this);
  part_ = shown.part();
  if (part_) part_->installEventFilter(this);
  title_->setText(shown.title);
  words_->setText(shown.words);
  count_->setText(tr("%1 of %2").arg(stop_ + 1).arg(stops()));
  back_->setEnabled(stop_ > 0);
  next_->setText(stop_ + 1 < stops() ? tr("&Next") : tr("Fi&nish"));
  setAccessibleDescription(shown.title + ". " + shown.words);  // what a screen reader says
  settle();
  if (stop_ == 0) next_->setFocus();
}

void QuickTour::settle() {
  if (!part_ || !outline_) return;
  setFixedWidth(cardWidth);
  const QMargins margins = layout()->contentsMargins() + contentsMargins();
  words_->setMinimumHeight(words_->heightForWidth(cardWidth - margins.left() - margins.right()));
  layout()->activate();
  const QRect part(window_.mapFromGlobal(part_->mapToGlobal(QPoint())), part_->size());  // a dock may float
  outline_->setGeometry(part);
  outline_->setVisible(part_->isVisible() && part_->window() == &window_);
  resize(cardWidth, sizeHint().height());
  move(cornerBeside(part, size(), window_.rect()));
  outline_->raise();
  raise();
}

bool QuickTour::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide)
    QMetaObject::invokeMethod(this, &QuickTour::settle, Qt::QueuedConnection);  // once the layout has settled
  return QFrame::eventFilter(watched, event);
}

void QuickTour::end() {
  if (outline_) outline_->deleteLater(), outline_->hide();
  window_.removeEventFilter(this);
  if (focusBefore_) focusBefore_->setFocus();
  close();
}

}  // namespace squat::studio
