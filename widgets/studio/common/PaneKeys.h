// widgets/studio/common/PaneKeys.h - F6 goes to the next pane of a window, Shift+F6 to the one before.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

namespace squat::studio {

// In the order of the keys; asked for with every key. Hidden ones are skipped.
using Panes = std::function<std::vector<QWidget*>()>;

// They work in this window, not in others that it owns. The focus returns to where it was last in a pane, else to its
// first field.
void addPaneKeys(QWidget& window, const Panes& panes);

}  // namespace squat::studio
