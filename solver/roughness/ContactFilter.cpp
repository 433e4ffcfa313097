#include "roughness/ContactFilter.h"

#include <cmath>
#include <numbers>

#include "core/Errors.h"

namespace squat::roughness {

double contactFilter(ContactFilter filter, double wavelength, double halfLength) {
  const double ka = 2 * std::numbers::pi / wavelength * halfLength;
  switch (filter) {
    case ContactFilter::none:
      return 1;
    case ContactFilter::uniform:
      return ka < 1e-6 ? 1 : std::abs(std::sin(ka) / ka);
    case ContactFilter::remington:
      return 1 / std::sqrt(1 + 0.25 * std::numbers::pi * ka * ka * ka);
  }
  return 1;
}

std::string toText(ContactFilter filter) {
  return filter == ContactFilter::none ? "none" : filter == ContactFilter::uniform ? "uniform" : "remington";
}

ContactFilter contactFilterFromText(const std::string& text, const std::string& option) {
  for (const auto filter : {ContactFilter::none, ContactFilter::uniform, ContactFilter::remington})
    if (text == toText(filter)) return filter;
  throw CaseError({{option, text, "none, uniform or remington", "Choose one of the names"}});
}

}  // namespace squat::roughness
