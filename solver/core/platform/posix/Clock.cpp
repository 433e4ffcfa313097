#include "core/platform/Clock.h"

#include <time.h>

namespace squat::platform {

std::tm utcDate(std::time_t time) {
  std::tm date{};
  ::gmtime_r(&time, &date);
  return date;
}

}  // namespace squat::platform
