// solver/growth/LayerChange.h - what many passages and the grinding train do to the layer that yields.
#pragma once

#include <vector>

#include "elasticity/SweptBlock.h"
#include "plasticity/SurfaceLayer.h"

namespace squat::growth {

// Mean equivalent plastic strain of each element: [group][lane].
std::vector<double> elementStrain(const plasticity::SurfaceLayer& layer, const plasticity::LayerState& state);

// [m] of the middle of each element below the running surface, in the same order.
std::vector<double> elementDepth(const plasticity::SurfaceLayer& layer, const elasticity::SweptBlock& rail,
                                 scenario::RailSection section);

// Hardening after `more` times the traffic that led from `before` to `state`: equivalent strain and growth of the yield
// stress go on as they went. Plastic strain does not: once the residual stress has settled, what still flows fits
// together without stress and only moves the surface. Back-stresses do not either: carried on by themselves they push
// back in the next passage, and the steel flows back and forth (tried, explicitly and implicitly).
void hardenOn(const plasticity::SurfaceLayer& layer, const plasticity::LayerState& before, double more,
              plasticity::LayerState& state);

// The steel that is left `depth` [m] deeper comes up by it; below the layer it is as new.
void grindLayer(const plasticity::SurfaceLayer& layer, const elasticity::SweptBlock& rail, double depth,
                plasticity::LayerState& state);

}  // namespace squat::growth
