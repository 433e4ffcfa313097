// solver/studies/CostEstimate.h - what a run will cost, known before it starts.
#pragma once

#include <cstddef>

#include "case/CaseFile.h"
#include "studies/StudyGrid.h"

namespace squat::studies {

struct CostEstimate {
  std::size_t elements = 0;
  double steps = 0;
  double coreSeconds = 0;  // of a whole run
  double bytes = 0;        // of memory
};

// From the mesh and the stable time step of the case, which are made for it (a second on the mesh `draft`), and the
// speed and memory of the manual's page about speed: 90 million element updates a second and core, a quarter more for
// equilibrium and start; 110 MiB and 310 bytes an element. Another processor may take twice as long. Throws CaseError
// where the case cannot be run.
CostEstimate costOf(const cases::CaseDescription& description);

// Of the first point that can be run.
CostEstimate costOfARun(const StudyDefinition& definition, const cases::CaseOverrides& overrides);

}  // namespace squat::studies
