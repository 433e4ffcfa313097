#include "measured/ColumnRoles.h"

#include <algorithm>
#include <array>

#include "measured/TextNumber.h"

namespace squat::measured {
namespace {

struct Unit {
  std::string_view name;
  double factor;
  std::string_view si;
};

constexpr std::array<Unit, 35> units{{{"s", 1, "s"},
                                      {"sec", 1, "s"},
                                      {"ms", 1e-3, "s"},
                                      {"us", 1e-6, "s"},
                                      {"\xC2\xB5s", 1e-6, "s"},
                                      {"\xCE\xBCs", 1e-6, "s"},
                                      {"m", 1, "m"},
                                      {"km", 1e3, "m"},
                                      {"mm", 1e-3, "m"},
                                      {"cm", 1e-2, "m"},
                                      {"km+m", 1, "m"},
                                      {"m/s", 1, "m/s"},
                                      {"km/h", 1 / 3.6, "m/s"},
                                      {"kmh", 1 / 3.6, "m/s"},
                                      {"kph", 1 / 3.6, "m/s"},
                                      {"m/s2", 1, "m/s2"},
                                      {"m/s^2", 1, "m/s2"},
                                      {"m/s**2", 1, "m/s2"},
                                      {"m/s\xC2\xB2", 1, "m/s2"},
                                      {"m s-2", 1, "m/s2"},
                                      {"ms-2", 1, "m/s2"},
                                      {"mm/s2", 1e-3, "m/s2"},
                                      {"mm/s^2", 1e-3, "m/s2"},
                                      {"g", 9.80665, "m/s2"},
                                      {"mg", 9.80665e-3, "m/s2"},
                                      {"n", 1, "N"},
                                      {"kn", 1e3, "N"},
                                      {"v", 1, "V"},
                                      {"mv", 1e-3, "V"},
                                      {"hz", 1, "Hz"},
                                      {"khz", 1e3, "Hz"},
                                      {"deg", 1, "deg"},
                                      {"\xC2\xB0", 1, "deg"},
                                      {"%", 1, "%"},
                                      {"-", 1, "-"}}};

const Unit* findUnit(std::string_view text) {
  const std::string lower = lowerCase(text);
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == lower; });
  return found == units.end() ? nullptr : &*found;
}

bool oneOf(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), name) != words.end();
}

bool begins(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return name.compare(0, word.size(), word) == 0 &&
           (name.size() == word.size() || !((name[word.size()] >= 'a' && name[word.size()] <= 'z')));
  });
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string bareUnit(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '[' || text.front() == '(') && (text.back() == ']' || text.back() == ')'))
    text = trimmed(text.substr(1, text.size() - 2));
  return std::string(text);
}

bool isUnit(std::string_view text) {
  const std::string_view bare = trimmed(text);
  if (bare.size() >= 2 && bare.front() == '[' && bare.back() == ']') return true;
  return findUnit(bareUnit(text)) != nullptr;
}

Role roleOf(std::string_view columnName, std::string_view unit) {
  const std::string name = lowerCase(trimmed(columnName));
  if (oneOf(name, {"t", "sec", "seconds"}) || begins(name, {"time", "timestamp", "zeit", "tijd"})) return Role::time;
  if (oneOf(name, {"km", "pos"}) || begins(name, {"position", "chainage", "distance", "mileage", "kilometre",
                                                  "kilometer", "station", "weg", "afstand", "kmpost"}))
    return Role::position;
  if (oneOf(name, {"v"}) || begins(name, {"speed", "velocity", "geschwindigkeit", "snelheid"})) return Role::speed;
  // A number that tells runs apart; "run 1" with a unit of its own is a signal.
  const std::string bare = bareUnit(unit);
  if ((bare.empty() || bare == "-") &&
      oneOf(name,
            {"run", "run no", "run no.", "run nr", "run number", "run id", "run_no", "run_nr", "run_number", "run_id",
             "passage", "passage no", "passage no.", "passage nr", "passage number", "passage id", "passage_id"}))
    return Role::run;
  const Unit* known = findUnit(unit);
  if (!name.empty() || !known) return Role::signal;
  if (known->si == "s") return Role::time;
  if (known->si == "m/s") return Role::speed;
  return Role::signal;
}

bool isUnitOf(std::string_view unit, Role role) {
  const std::string bare = bareUnit(unit);
  if (bare.empty() || bare == "-") return true;
  const Unit* known = findUnit(bare);
  return known && known->si == (role == Role::time ? "s" : role == Role::position ? "m" : "m/s");
}

UnitScale scaleOf(std::string_view unit, std::string_view name, Role role) {
  const std::string bare = bareUnit(unit);
  const Unit* known = findUnit(bare);
  if (known) return {known->factor, std::string(known->si)};
  if (role == Role::position && bare.empty() && lowerCase(trimmed(name)) == "km") return {1e3, "m"};
  if (role == Role::time) return {1, "s"};
  if (role == Role::position) return {1, "m"};
  if (role == Role::speed) return {1, "m/s"};
  return {1, bare};
}

}  // namespace squat::measured
