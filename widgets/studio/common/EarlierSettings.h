// widgets/studio/common/EarlierSettings.h - settings that an earlier version has kept elsewhere.
#pragma once

#include <QString>

namespace squat::studio {

// Copies what the application has kept under another name of its organization, where it has no settings of its own yet.
void takeSettingsFrom(const QString& organization);

}  // namespace squat::studio
