// solver/scenario/ModelExtent.h - how much of the track and the wheelset is modelled.
#pragma once

namespace squat::scenario {

// One rail, half of each sleeper and half the wheelset, with a mirror at the track centre; or all of it.
enum class ModelExtent { half, whole };

}  // namespace squat::scenario
