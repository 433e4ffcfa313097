#include "studio/tools/ButtonedList.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace squat::studio {

QToolButton* textButton(const QString& text, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setObjectName(name);
  button->setAccessibleName(QString(text).remove('&'));
  return button;
}

ButtonedList::ButtonedList(const QString& name, const QString& addText, const QString& listName, int lines,
                           QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget(this)),
      add_(textButton(addText, "add" + name, this)),
      remove_(textButton(tr("Re&move"), "remove" + name, this)) {
  list_->setAccessibleName(listName);
  list_->setMaximumHeight(lines * (list_->fontMetrics().height() + 4));
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(add_);
  buttons->addWidget(remove_);
  buttons->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_, 1);
  layout->addLayout(buttons);
}

}  // namespace squat::studio
