// solver/rcmdx/UnitWords.h - units that are written out, as RCM-DX does ("millimeter").
#pragma once

#include <string>
#include <string_view>

namespace squat::rcmdx {

// "m/s2" for "metre per second squared", "MetresPerSecondSquared", "metre/second^2" and the like, in American spelling
// too; what is not known as words comes back as it is.
std::string symbolOf(std::string_view unit);

}  // namespace squat::rcmdx
