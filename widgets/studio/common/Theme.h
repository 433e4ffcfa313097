// widgets/studio/common/Theme.h - light and dark.
#pragma once

#include "plots/Style.h"

namespace squat::studio {

// Palette of the whole program, the same on every desktop.
void applyTheme(bool dark);
plots::Style figureStyle(bool dark);
// What the user chose last; before that, what the desktop has.
bool requestedDark();

// Of words that say what is wrong, and of what is as it should be: readable on light and on dark ground (4:1).
inline constexpr const char* wrongColour = "#dd4b39";
inline constexpr const char* rightColour = "#2e9e5b";

}  // namespace squat::studio
