// widgets/studio/document/OtherUnits.h - a value as railways also state it.
#pragma once

#include <QString>

#include "case/CaseDescription.h"

namespace squat::studio {

// Of a speed in m/s "= 108 km/h", of a mass that the wheel carries "axle load 17.9 t (176 kN)": of both wheels, with
// the wheelset. Empty for other keys.
QString inOtherUnits(const cases::CaseDescription& description, const std::string& key);

}  // namespace squat::studio
