#include "text/Moments.h"

#include <chrono>

#include "text/Text.h"

namespace squat::text {
namespace {

// What is left to read of a moment.
class MomentText {
 public:
  explicit MomentText(std::string_view text) : text_(text) {}

  bool atEnd() const { return text_.empty(); }
  char first() const { return text_.empty() ? '\0' : text_.front(); }
  void skipBlanks() { text_ = trimmed(text_); }

  bool take(char sign) {
    if (first() != sign) return false;
    text_.remove_prefix(1);
    return true;
  }

  bool takeWord(std::string_view word) {
    if (lowerCase(text_.substr(0, word.size())) != word) return false;
    text_.remove_prefix(word.size());
    return true;
  }

  // A whole number of so many digits.
  std::optional<int> digits(std::size_t least, std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < text_.size() && count < most && isDigit(text_[count])) value = 10 * value + (text_[count++] - '0');
    if (count < least || (count < text_.size() && isDigit(text_[count]))) return std::nullopt;
    text_.remove_prefix(count);
    return value;
  }

  // The digits behind a decimal sign, which has been taken.
  std::optional<double> fraction() {
    double value = 0, unit = 1;
    std::size_t count = 0;
    for (; count < text_.size() && isDigit(text_[count]); ++count) value += (text_[count] - '0') * (unit /= 10);
    if (count == 0 || count > 18) return std::nullopt;
    text_.remove_prefix(count);
    return value;
  }

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  std::string_view text_;
};

// Seconds of the day since 1970.
std::optional<double> secondsOfDay(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return 86400.0 * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

std::optional<double> takeDate(MomentText& text) {
  const auto first = text.digits(1, 4);
  if (!first) return std::nullopt;
  const char sign = text.first();
  if (sign != '-' && sign != '/' && sign != '.') return std::nullopt;
  text.take(sign);
  const auto second = text.digits(1, 2);
  if (!second || !text.take(sign)) return std::nullopt;
  const auto third = text.digits(2, 4);
  if (!third) return std::nullopt;
  if (*first > 99) return secondsOfDay(*first, *second, *third);
  const int year = *third < 100 ? 2000 + *third : *third;
  const bool isMonthFirst = *second > 12 && *first <= 12;
  return isMonthFirst ? secondsOfDay(year, *first, *second) : secondsOfDay(year, *second, *first);
}

// Seconds since midnight of "09:30:00.5", "9:30:00 PM", "09:30", and without hours "30:00.5".
std::optional<double> takeClock(MomentText& text, bool isAfterDate) {
  const auto first = text.digits(1, 2);
  if (!first || !text.take(':')) return std::nullopt;
  const auto second = text.digits(2, 2);
  if (!second) return std::nullopt;
  int hour = *first, minute = *second;
  double seconds = 0;
  bool hasSeconds = text.take(':');
  if (hasSeconds) {
    const auto third = text.digits(2, 2);
    if (!third) return std::nullopt;
    seconds = *third;
  }
  if (text.first() == '.' || text.first() == ',') {
    text.take(text.first());
    const auto fraction = text.fraction();
    if (!fraction) return std::nullopt;
    if (!hasSeconds) {  // 30:00.5
      if (isAfterDate) return std::nullopt;
      seconds = minute, minute = hour, hour = 0;
      hasSeconds = true;
    }
    seconds += *fraction;
  }
  if (!hasSeconds && !isAfterDate) return std::nullopt;  // 9:30 alone may be a ratio, or a score
  text.skipBlanks();
  if (text.takeWord("pm"))
    hour = hour % 12 + 12;
  else if (text.takeWord("am"))
    hour = hour % 12;
  if (hour > 24 || minute > 59 || seconds >= 61) return std::nullopt;
  return 3600.0 * hour + 60.0 * minute + seconds;
}

// Seconds that local time is ahead; nothing for text that is no zone.
std::optional<double> takeZone(MomentText& text) {
  text.skipBlanks();
  if (text.takeWord("z") || text.takeWord("utc") || text.takeWord("gmt"))
    return text.atEnd() ? std::optional(0.0) : std::nullopt;
  if (text.atEnd()) return 0.0;
  const bool isAhead = text.first() == '+';
  if (!text.take('+') && !text.take('-')) return std::nullopt;
  const auto hours = text.digits(2, 2);
  if (hours) {
    int minutes = 0;
    if (text.take(':')) {
      const auto stated = text.digits(2, 2);
      if (!stated) return std::nullopt;
      minutes = *stated;
    }
    if (!text.atEnd()) return std::nullopt;
    return (isAhead ? 60.0 : -60.0) * (60 * *hours + minutes);
  }
  const auto both = text.digits(4, 4);  // +0100
  if (!both || !text.atEnd()) return std::nullopt;
  return (isAhead ? 60.0 : -60.0) * (*both / 100 * 60 + *both % 100);
}

}  // namespace

std::optional<Moment> momentIn(std::string_view field) {
  field = trimmed(field);
  constexpr std::size_t shortest = 7, longest = 40;
  if (field.size() < shortest || field.size() > longest || field.front() < '0' || field.front() > '9') return {};
  MomentText text(field);
  auto dateText = text;
  const auto date = takeDate(dateText);
  if (!date) {
    const auto clock = takeClock(text, false);
    return clock && text.atEnd() ? std::optional(Moment{MomentKind::clock, *clock}) : std::nullopt;
  }
  text = dateText;
  if (text.atEnd()) return Moment{MomentKind::date, *date};
  const bool isParted = text.take('T') || text.take('t') || text.first() == ' ';
  if (!isParted) return {};
  text.skipBlanks();
  const auto clock = takeClock(text, true);
  if (!clock) return {};
  const auto zone = takeZone(text);
  return zone ? std::optional(Moment{MomentKind::dateTime, *date + *clock - *zone}) : std::nullopt;
}

}  // namespace squat::text
