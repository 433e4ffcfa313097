#include "studio/common/PaneKeys.h"

#include <QApplication>
#include <QShortcut>
#include <utility>

namespace squat::studio {
namespace {

bool takesFocus(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

// The first field in the order of the Tab key; null: there is none.
QWidget* firstField(QWidget& pane) {
  QWidget* each = &pane;
  do {
    if ((each == &pane || pane.isAncestorOf(each)) && takesFocus(*each)) return each;
    each = each->nextInFocusChain();
  } while (each != &pane);
  return nullptr;
}

QWidget* fieldOf(QWidget& pane) {
  QWidget* before = pane.focusWidget();
  return before && takesFocus(*before) ? before : firstField(pane);
}

void goOn(const std::vector<QWidget*>& panes, int step) {
  const QWidget* focus = QApplication::focusWidget();
  const int count = static_cast<int>(panes.size());
  int at = step > 0 ? -1 : count;
  for (int i = 0; i < count; ++i)
    if (focus &&
        (panes[static_cast<std::size_t>(i)] == focus || panes[static_cast<std::size_t>(i)]->isAncestorOf(focus)))
      at = i;
  for (int i = 0; i < count; ++i) {
    at = (at + step + count) % count;
    QWidget& pane = *panes[static_cast<std::size_t>(at)];
    QWidget* field = pane.isVisible() ? fieldOf(pane) : nullptr;
    if (!field) continue;
    field->setFocus(Qt::TabFocusReason);
    return;
  }
}

}  // namespace

void addPaneKeys(QWidget& window, const Panes& panes) {
  for (const int step : {1, -1}) {
    auto* keys = new QShortcut(QKeySequence(step > 0 ? "F6" : "Shift+F6"), &window);
    QObject::connect(keys, &QShortcut::activated, &window, [panes, step] { goOn(panes(), step); });
  }
}

}  // namespace squat::studio
