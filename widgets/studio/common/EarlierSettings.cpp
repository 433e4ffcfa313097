#include "studio/common/EarlierSettings.h"

#include <QCoreApplication>
#include <QSettings>

namespace squat::studio {

void takeSettingsFrom(const QString& folder) {
  QSettings own;
  own.setFallbacksEnabled(false);
  if (!own.allKeys().isEmpty()) return;
  QSettings earlier(folder, QCoreApplication::applicationName());
  earlier.setFallbacksEnabled(false);
  for (const QString& key : earlier.allKeys()) own.setValue(key, earlier.value(key));
}

}  // namespace squat::studio
