// widgets/studio/signals/SignalFigures.h - the figures of the signals panel: a run seen through the settings, others
// over it.
#pragma once

#include <memory>
#include <vector>

#include "plots/FigureRegistry.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// A row of plots::figureRegistry() with its marks. `shown` has been through
// analysis::resultThrough(); the overlaid runs are seen through the settings too and laid on its axis. Throws CaseError
// for an unknown name and for one that is no plot.
std::unique_ptr<plots::Figure> signalFigure(const std::string& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays,
                                            const analysis::FigureSettings& settings, const plots::Style& style);

// For a figure that was built without a run: where it has nothing of the overlaid signals either, what to do next
// stands in place of its axes. `isComing`: the run is being read.
void showNextStep(plots::Figure& figure, bool hasOverlays, bool isComing);

}  // namespace squat::studio
