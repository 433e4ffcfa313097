// widgets/scene/Field.h - what the surface can be coloured by.
#pragma once

#include <string>

namespace squat::scene {

// Pressure and stick/slip are drawn on the rail under a wheel that is hardly seen.
enum class Field { none, vonMises, plasticStrain, displacement, contactPressure, stickSlip };

inline bool isOfPatch(Field field) { return field == Field::contactPressure || field == Field::stickSlip; }

std::string fieldName(Field field);  // with unit, as on the colour bar: "von Mises stress [MPa]"

}  // namespace squat::scene
