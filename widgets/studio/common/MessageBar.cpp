#include "studio/common/MessageBar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "studio/common/FixedLabel.h"

namespace squat::studio {
namespace {

// A button that comes and goes keeps its place.
QToolButton* makeButton(const QString& text, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setAccessibleName(name);
  button->setAutoRaise(true);
  QSizePolicy keepsPlace = button->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  button->setSizePolicy(keepsPlace);
  button->hide();
  return button;
}

}  // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  text_ = new FixedLabel(1, this);
  text_->setObjectName("message");
  more_ = makeButton(tr("Details"), tr("Details of the message"), this);
  more_->setObjectName("messageDetails");
  more_->setShortcut(QKeySequence("Ctrl+Alt+D"));
  more_->setToolTip(tr("Show the whole message (Ctrl+Alt+D)"));
  close_ = makeButton(QChar(0x2715), tr("Dismiss message"), this);
  close_->setObjectName("dismissMessage");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 1, 4, 1);
  row->addWidget(text_, 1);
  row->addWidget(more_);
  row->addWidget(close_);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(more_, &QToolButton::clicked, this, &MessageBar::showDetails);
  connect(close_, &QToolButton::clicked, this, &MessageBar::clear);
}

QString MessageBar::text() const { return text_->text(); }

void MessageBar::say(const QString& sentence, const QString& details) { show(sentence, details, "#0072b2"); }

void MessageBar::warn(const QString& sentence, const QString& details) { show(sentence, details, "#b03a2e"); }

void MessageBar::clear() {
  text_->clear();
  details_.clear();
  setStyleSheet({});
  setAccessibleName({});
  showButtons();
}

void MessageBar::show(const QString& sentence, const QString& details, const QString& colour) {
  text_->setText(sentence);
  details_ = details == sentence ? QString() : details;
  setStyleSheet(QStringLiteral("squat--studio--MessageBar { background: %1; } "
                               "squat--studio--MessageBar QLabel, squat--studio--MessageBar QToolButton "
                               "{ color: white; }")
                    .arg(colour));
  showButtons();
  setAccessibleName(sentence);
  QAccessibleEvent alert(this, QAccessible::Alert);  // read aloud: the message takes no focus
  QAccessible::updateAccessibility(&alert);
}

void MessageBar::showButtons() {
  const bool isWhole = text_->fontMetrics().horizontalAdvance(text()) <= text_->width();
  more_->setVisible(!details_.isEmpty() || !isWhole);
  close_->setVisible(!isEmpty());
}

void MessageBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  showButtons();
}

// Above the line, as wide; a click elsewhere or Escape closes it.
void MessageBar::showDetails() {
  auto* popup = new QFrame(this, Qt::Popup);
  popup->setObjectName("messagePopup");
  popup->setAttribute(Qt::WA_DeleteOnClose);
  popup->setFrameShape(QFrame::StyledPanel);
  popup->setStyleSheet("QLabel { color: palette(window-text); }");
  auto* all = new QLabel(details_.isEmpty() ? text() : text() + "\n\n" + details_, popup);
  all->setWordWrap(true);
  all->setTextFormat(Qt::PlainText);
  all->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(popup);
  layout->addWidget(all);
  popup->setFixedWidth(width());
  popup->adjustSize();
  popup->move(mapToGlobal(QPoint(0, 0)) - QPoint(0, popup->height()));
  popup->show();
}

}  // namespace squat::studio
