// widgets/studio/common/EarlierSettings.h - settings that an earlier version kept elsewhere.
#pragma once

#include <QString>

namespace squat::studio {

// Copies what the program kept in another folder of the user's settings, where it has none of its own yet.
void takeSettingsFrom(const QString& folder);

}  // namespace squat::studio
