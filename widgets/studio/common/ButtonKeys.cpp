#include "studio/common/ButtonKeys.h"

#include <QAbstractButton>

namespace squat::studio {

void giveKeys(const QWidget& parent, std::initializer_list<std::pair<QString, QString>> namesAndKeys) {
  for (const auto& [name, keys] : namesAndKeys) {
    auto* button = parent.findChild<QAbstractButton*>(name);
    if (!button) continue;
    button->setShortcut(QKeySequence(keys));
    const QString tip = button->toolTip().isEmpty() ? button->text() : button->toolTip();
    button->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys));
  }
}

}  // namespace squat::studio
