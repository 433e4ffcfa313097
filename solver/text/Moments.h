// solver/text/Moments.h - dates and times of day, as loggers and offices write them.
#pragma once

#include <optional>
#include <string_view>

namespace squat::text {

enum class MomentKind { date, clock, dateTime };

struct Moment {
  MomentKind kind = MomentKind::date;
  double seconds = 0;  // of a clock since midnight, else since 1970-01-01 00:00; a double holds 0.24 us of a date
};

// "2026-11-27T09:30:00.123456Z", "2026/11/27 09:30:00", "27.11.2026 09:30:00,123", "27/11/2026 9:30:00 AM",
// "2026-11-27", "09:30:00.5", "30:00.5" (minutes and seconds with a fraction, as spreadsheets write them). A zone is
// applied; without one the time counts as it stands. Of "03/04/2026" the first number is the day, unless only the
// second can be one. Nothing for any other text.
std::optional<Moment> momentIn(std::string_view field);

}  // namespace squat::text
