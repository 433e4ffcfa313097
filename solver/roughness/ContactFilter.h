// solver/roughness/ContactFilter.h - what a contact patch passes on of waves that are not long against it.
//
// uniform: heights that are the same all across the patch, as those of a computed rail. Linearised elastic contact
// weighs
//   heights with the pressure of a flat punch (reciprocity); across, that sums up to an even weight along the patch:
//   |C| = |sin(k a) / (k a)|, zero where a wave fits the patch.
// remington: heights that vary across as they do along, of real rails: |C|^2 = 1 / (1 + pi/4 (k a)^3), after Remington
//   (1976) as D. J. Thompson gives it (Railway Noise and Vibration, 2009, chapter 5).
// k = 2 pi / wavelength, a half the length of the patch.
#pragma once

#include <string>

namespace squat::roughness {

enum class ContactFilter { none, uniform, remington };

// |C|, 0 to 1. `halfLength` [m] of the patch along the rail.
double contactFilter(ContactFilter filter, double wavelength, double halfLength);

std::string toText(ContactFilter filter);
// "none", "uniform" or "remington"; throws CaseError, which names the option `option`, for another word.
ContactFilter contactFilterFromText(const std::string& text, const std::string& option);

}  // namespace squat::roughness
