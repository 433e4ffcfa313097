// widgets/studio/signals/SignalFigures.h - the figures of the signals panel: a run seen through the settings, others
// over it.
#pragma once

#include <memory>
#include <vector>

#include "plots/FigureRegistry.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/SignalSettings.h"

namespace squat::studio {

// What the panel's settings are for a figure, with the overlaid runs where the row draws them.
plots::FigureSettings figureSettings(const plots::FigureRow& row, const std::vector<StoredRun>& overlays,
                                     const SignalSettings& settings);

// A row of plots::figureRegistry() with its marks. `shown` has been through analysed(); so are the overlaid runs, which
// are laid on its axis. Throws CaseError for an unknown name and for one that is no plot.
std::unique_ptr<plots::Figure> signalFigure(const std::string& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays, const SignalSettings& settings,
                                            const plots::Style& style);

}  // namespace squat::studio
