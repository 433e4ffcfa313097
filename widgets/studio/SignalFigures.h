// widgets/studio/SignalFigures.h - the figures of the signals panel: a run seen through the settings, others over it.
#pragma once

#include <QByteArray>
#include <QString>
#include <memory>
#include <vector>

#include "plots/Figure.h"
#include "results/RunResult.h"
#include "studio/RunStore.h"
#include "studio/SignalSettings.h"

namespace squat::studio {

// `name` as the tabs have it: "aba", "psd", "stft", "scalogram", "contact_force", "contact_patch", "defect_profile".
// `shown` has been through analysed(). Overlaid runs are laid on its axis: positions count from the defect, times are
// shifted so that all wheels pass it at the same moment.
std::unique_ptr<plots::Figure> signalFigure(const QString& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays, const SignalSettings& settings,
                                            const plots::Style& style);

// Moment [s] at which the wheel is over the defect, by the constant speed that links time and position.
double passageTime(const signals::Record& result);

// Every point of contact with pressure, traction and slip, as CSV; empty without a patch.
QByteArray patchTable(const results::RunResult& result);

}  // namespace squat::studio
