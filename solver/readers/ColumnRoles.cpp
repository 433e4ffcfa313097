#include "readers/ColumnRoles.h"

#include <algorithm>

#include "text/Heading.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::readers {
namespace {

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

Role roleOf(std::string_view columnName, std::string_view unit) {
  const std::string name = text::lowerCase(text::trimmed(columnName));
  const std::string_view quantity = text::siUnitOfName(name);
  if (quantity == "s") return Role::time;
  if (quantity == "m") return Role::position;
  if (quantity == "m/s") return Role::speed;
  // A number that tells runs apart; "run 1" with a unit of its own is a signal.
  const std::string bare = text::bareUnit(unit);
  if ((bare.empty() || bare == "-") &&
      oneOf(name,
            {"run", "run no", "run no.", "run nr", "run number", "run id", "run_no", "run_nr", "run_number", "run_id",
             "passage", "passage no", "passage no.", "passage nr", "passage number", "passage id", "passage_id"}))
    return Role::run;
  const auto* known = text::findUnit(bare);
  // "lat" may be a lateral acceleration, "long" a longitudinal one: their units tell.
  if (bare.empty() || bare == "-" || (known && known->si == "deg")) {
    if (oneOf(name, {"lat", "gps lat", "gps_lat", "breitengrad", "breedtegraad"}) || begins(name, {"latitude"}))
      return Role::latitude;
    if (oneOf(name,
              {"lon", "lng", "gps lon", "gps_lon", "gps lng", "gps_lng", "laengengrad", "längengrad", "lengtegraad"}) ||
        begins(name, {"longitude"}))
      return Role::longitude;
  }
  if (!name.empty() || !known) return Role::signal;
  if (known->si == "s") return Role::time;
  if (known->si == "m/s") return Role::speed;
  return Role::signal;
}

bool isUnitOf(std::string_view unit, Role role) {
  const std::string bare = text::bareUnit(unit);
  if (bare.empty() || bare == "-") return true;
  const auto* known = text::findUnit(bare);
  return known && known->si == (role == Role::time       ? "s"
                                : role == Role::position ? "m"
                                : role == Role::speed    ? "m/s"
                                                         : "deg");
}

UnitScale scaleOf(std::string_view unit, std::string_view name, Role role) {
  const std::string bare = text::bareUnit(unit);
  const auto* known = text::findUnit(bare);
  if (known) return {known->factor, std::string(known->si)};
  if (role == Role::position && bare.empty() && text::lowerCase(text::trimmed(name)) == "km") return {1e3, "m"};
  if (role == Role::time) return {1, "s"};
  if (role == Role::position) return {1, "m"};
  if (role == Role::speed) return {1, "m/s"};
  if (role == Role::latitude || role == Role::longitude) return {1, "deg"};
  return {1, bare};
}

}  // namespace squat::readers
