// widgets/studio/common/PaneKeys.h - F6 goes to the next pane of a window, Shift+F6 to the one before.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

namespace squat::studio {

// As the keys find them; hidden ones are passed over.
using Panes = std::function<std::vector<QWidget*>()>;

// In the window alone, not in others that it owns. The focus comes to where it was last in a pane, else to its first
// field.
void addPaneKeys(QWidget& window, const Panes& panes);

}  // namespace squat::studio
