#include "core/platform/Clock.h"

#include <time.h>

namespace squat::platform {

std::tm utcDate(std::time_t time) {
  std::tm date{};
  ::gmtime_s(&date, &time);
  return date;
}

}  // namespace squat::platform
