#include "dynamics/StepTimings.h"

namespace squat::dynamics {

const char* nameOf(StepPhase phase) {
  constexpr std::array<const char*, stepPhases> names{"wheelset", "force elements", "tied nodes", "layer",
                                                      "ends",     "stations",       "masters",    "sleepers",
                                                      "motion",   "observers",      "waiting"};
  return names[static_cast<std::size_t>(phase)];
}

}  // namespace squat::dynamics
