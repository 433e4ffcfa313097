// solver/core/platform/Clock.h - dates.
#pragma once

#include <ctime>

namespace squat::platform {

std::tm utcDate(std::time_t time);  // safe in any thread, unlike std::gmtime

}  // namespace squat::platform
