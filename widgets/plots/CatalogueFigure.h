// widgets/plots/CatalogueFigure.h - figures of the signals of the catalogue (signals/SignalCatalogue.h), against the
// wheel's position.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "plots/FigureRegistry.h"

namespace squat::plots {

// The curves of all signals that name the figure and that the result holds. `decorate` adds what else belongs in it,
// before the range of y is chosen.
std::unique_ptr<Figure> catalogueFigure(const std::string& figure, const results::RunResult& result, const Style& style,
                                        const std::function<void(Figure&)>& decorate = {});

// The row of the registry for a figure of the catalogue.
FigureRow catalogueRow(const std::string& figure);

// Names of the figures of the catalogue, each once.
std::vector<std::string> catalogueFigures();

}  // namespace squat::plots
