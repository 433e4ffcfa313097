// solver/model/ContactPenalty.h - penalties of the contact as the case asks for them.
#pragma once

#include "scenario/Scenario.h"

namespace squat::model {

// Normal penalty [Pa/m]: normal_penalty * E / element size in the contact band.
inline double normalPenalty(const scenario::Scenario& d) {
  return d.contact.normalPenalty * d.rail.material.young / d.mesh.contactSize;
}

inline double tangentialPenalty(const scenario::Scenario& d) { return d.contact.tangentialPenalty * normalPenalty(d); }

}  // namespace squat::model
