// widgets/scene/Field.h - what the surface can be coloured by.
#pragma once

#include <string>

namespace squat::scene {

enum class Field { none, vonMises, plasticStrain, displacement };

std::string fieldName(Field field);  // with unit, as on the colour bar: "von Mises stress [MPa]"

}  // namespace squat::scene
