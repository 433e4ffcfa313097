// python/Results.h - squat.Result: a result of the library, held by both sides.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "results/RunResult.h"

namespace squat::python {

using ResultClass = pybind11::class_<results::RunResult, std::shared_ptr<results::RunResult>>;

// Surface, snapshots and contact patches.
void addFields(ResultClass& type);

}  // namespace squat::python
