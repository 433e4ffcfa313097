// widgets/studio/Theme.h - light and dark.
#pragma once

#include "plots/Style.h"

namespace squat::studio {

// Palette of the whole program, the same on every desktop.
void applyTheme(bool dark);
plots::Style figureStyle(bool dark);

}  // namespace squat::studio
