// widgets/studio/common/LocationToSave.h - asks where a file is to be written.
#pragma once

#include <QString>

class QWidget;

namespace squat::studio {

// Empty where the user thinks better of it. A name without an ending gets that of the chosen kind before the dialog
// asks whether an earlier file may be replaced. `kinds`: "PNG (*.png);;SVG (*.svg)"; `proposed` has the ending of the
// first.
QString locationToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& kinds);

}  // namespace squat::studio
