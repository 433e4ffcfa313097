#include "studio/common/MessageBar.h"

#include <QAccessible>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

namespace squat::studio {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  text_ = new QLabel(this);
  text_->setWordWrap(true);
  text_->setObjectName("message");
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_ = new QLabel(this);
  details_->setWordWrap(true);
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_->hide();
  more_ = new QToolButton(this);
  more_->setText(tr("Details"));
  more_->setCheckable(true);
  auto* close = new QToolButton(this);
  close->setText(QChar(0x2715));
  close->setAccessibleName(tr("Dismiss message"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 4, 8, 4);
  grid->addWidget(text_, 0, 0);
  grid->addWidget(more_, 0, 1, Qt::AlignTop);
  grid->addWidget(close, 0, 2, Qt::AlignTop);
  grid->addWidget(details_, 1, 0, 1, 3);
  grid->setColumnStretch(0, 1);
  connect(more_, &QToolButton::toggled, details_, &QWidget::setVisible);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  hide();
}

QString MessageBar::text() const { return isHidden() ? QString() : text_->text(); }

void MessageBar::say(const QString& sentence, const QString& details) { show(sentence, details, "#0072b2"); }

void MessageBar::warn(const QString& sentence, const QString& details) { show(sentence, details, "#b03a2e"); }

void MessageBar::show(const QString& sentence, const QString& details, const QString& colour) {
  text_->setText(sentence);
  details_->setText(details);
  more_->setChecked(false);
  more_->setVisible(!details.isEmpty() && details != sentence);
  setStyleSheet(QStringLiteral("squat--studio--MessageBar { background: %1; } QLabel { color: white; }").arg(colour));
  QFrame::show();
  setAccessibleName(sentence);
  QAccessibleEvent alert(this, QAccessible::Alert);  // read aloud: the message takes no focus
  QAccessible::updateAccessibility(&alert);
}

}  // namespace squat::studio
