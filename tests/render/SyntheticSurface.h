// tests/render/SyntheticSurface.h - surfaces of revolution and extrusion for the made-up run.
#pragma once

#include "results/RunResult.h"

namespace squat::tests {

// Rail, sleepers, wheel rim, wheel body and axle; wheel centre at (wheelAt, 0, 0.46); springs under rail and sleepers.
results::SurfaceMesh syntheticSurface(double wheelAt);

// Stress of a bell around the contact after the wheel has rolled on by `travel` metres.
results::SurfaceSnapshot syntheticSnapshot(const results::SurfaceMesh& surface, double wheelAt, double travel);

}  // namespace squat::tests
