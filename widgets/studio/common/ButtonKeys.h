// widgets/studio/common/ButtonKeys.h - keys for buttons that stand in no menu.
#pragma once

#include <QString>
#include <initializer_list>
#include <utility>

class QWidget;

namespace squat::studio {

// Gives the named buttons within `parent` their keys, and says so in their tool tips. After their texts: a text takes
// the key away.
void giveKeys(const QWidget& parent, std::initializer_list<std::pair<QString, QString>> namesAndKeys);

}  // namespace squat::studio
