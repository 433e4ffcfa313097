#include "case/SeatsText.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/DecimalNumber.h"
#include "text/Text.h"

namespace squat::cases {

namespace {

constexpr std::size_t maximumSeats = 100;
constexpr double farthestSleeper = 1000;

struct Field {
  const char* key;
  const char* unit;
  int powerOfTen;
  double minimum, maximum;  // in `unit`
  std::optional<double> Seat::*value;
};
// Ranges are those of the keys of all seats.
constexpr Field fields[] = {{"pad_stiffness", "MN/m", 6, 1, 20000, &Seat::padStiffness},
                            {"pad_damping", "kN s/m", 3, 0, 2000, &Seat::padDamping},
                            {"ballast_stiffness", "MN/m", 6, 1, 10000, &Seat::ballastStiffness},
                            {"ballast_damping", "kN s/m", 3, 0, 2000, &Seat::ballastDamping},
                            {"gap", "mm", -3, 0, 20, &Seat::gap}};

using text::trimmed;

// What stands between two letters, which must be its first and last.
std::optional<std::string_view> inside(std::string_view text, char open, char close) {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != open || text.back() != close) return std::nullopt;
  return trimmed(text.substr(1, text.size() - 2));
}

std::vector<std::string_view> separated(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '{') - (text[i] == '}');
    if (text[i] != ',' || depth != 0) continue;
    parts.push_back(trimmed(text.substr(from, i - from)));
    from = i + 1;
  }
  if (const auto last = trimmed(text.substr(from)); !last.empty()) parts.push_back(last);
  return parts;
}

std::string rangeOf(const Field& field) {
  return formatDecimal(field.minimum) + " to " + formatDecimal(field.maximum) + " " + field.unit;
}

// Sets one "key = value" of a seat; returns what is wrong with it.
std::string setEntry(Seat& seat, bool& hasSleeper, std::string_view entry) {
  const auto equals = entry.find('=');
  const std::string key(trimmed(entry.substr(0, equals)));
  const auto value = equals == std::string_view::npos ? std::string_view() : trimmed(entry.substr(equals + 1));
  if (key == "sleeper") {
    const auto number = parseDecimal(value);
    if (!number || *number != std::floor(*number) || std::abs(*number) > farthestSleeper)
      return "sleeper is a whole number, 0 the sleeper nearest to the defect";
    if (hasSleeper) return "sleeper is given twice";
    seat.sleeper = static_cast<int>(*number), hasSleeper = true;
    return {};
  }
  const auto* field = std::find_if(std::begin(fields), std::end(fields), [&](const Field& f) { return key == f.key; });
  if (field == std::end(fields)) return "there is no key " + key.substr(0, 40);
  const auto number = parseDecimal(value), si = parseDecimal(value, field->powerOfTen);
  if (!number || !si || *number < field->minimum || *number > field->maximum)
    return key + " goes from " + rangeOf(*field);
  if (seat.*(field->value)) return key + " is given twice";
  seat.*(field->value) = *si;
  return {};
}

}  // namespace

ParsedSeats parseSeats(std::string_view text) {
  ParsedSeats notSeats{{}, "Write tables like [{ sleeper = 0, pad_stiffness = 300 }, { sleeper = 1 }]"};
  const auto list = inside(text, '[', ']');
  if (!list) return notSeats;
  ParsedSeats parsed;
  for (const auto part : separated(*list)) {
    if (parsed.seats.size() >= maximumSeats) return {{}, "Give at most " + std::to_string(maximumSeats) + " seats"};
    const auto own = inside(part, '{', '}');
    if (!own || own->find_first_of("{}") != std::string_view::npos) return notSeats;
    const std::string which = "Seat " + std::to_string(parsed.seats.size() + 1) + ": ";
    Seat seat;
    bool hasSleeper = false;
    for (const auto entry : separated(*own))
      if (const auto wrong = setEntry(seat, hasSleeper, entry); !wrong.empty()) return {{}, which + wrong};
    if (!hasSleeper) return {{}, which + "name its sleeper, 0 the one nearest to the defect"};
    for (const auto& other : parsed.seats)
      if (other.sleeper == seat.sleeper) return {{}, which + "an earlier one has the same sleeper; join them"};
    parsed.seats.push_back(seat);
  }
  return parsed;
}

std::vector<std::pair<std::string, std::string>> seatEntries(const Seat& seat) {
  std::vector<std::pair<std::string, std::string>> entries{{"sleeper", std::to_string(seat.sleeper)}};
  for (const auto& field : fields)
    if (const auto& value = seat.*(field.value))
      entries.emplace_back(field.key, formatDecimal(*value, field.powerOfTen));
  return entries;
}

std::string formatSeats(const std::vector<Seat>& seats) {
  std::string text = "[";
  for (const auto& seat : seats) {
    std::string own;
    for (const auto& [key, value] : seatEntries(seat)) own += (own.empty() ? "" : ", ") + key + " = " + value;
    text += (text.size() > 1 ? ", { " : "{ ") + own + " }";
  }
  return text + "]";
}

std::string seatKeys() {
  std::string text;
  for (const auto& field : fields)
    text += (text.empty() ? "" : ", ") + std::string(field.key) + " (" + rangeOf(field) + ")";
  return text;
}

}  // namespace squat::cases
