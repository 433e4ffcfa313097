#include "studies/CostEstimate.h"

#include "case/Resolve.h"
#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "dynamics/StableStep.h"
#include "elasticity/SweptKernel.h"
#include "model/Model.h"
#include "studies/CaseStudy.h"
#include "studies/Jobs.h"

namespace squat::studies {
namespace {

constexpr double kUpdatesPerSecond = 90e6, kBesideRolling = 1.25;
constexpr double kBytes = 110.0 * (1 << 20);

}  // namespace

CostEstimate costOf(const cases::CaseDescription& description) {
  const auto sides = cases::resolveSides(description);
  const auto& scenario = sides.left;
  const auto model = model::buildModel(scenario);  // both sides have the same mesh
  ThreadTeam team(1);
  Monitor silent;
  const double step = dynamics::stableStep(model, elasticity::kernelsFor(""), team, silent).step;
  CostEstimate cost;
  cost.elements = (sides.right ? 2 : 1) * model.elements();
  cost.steps = (scenario.motion.runUp + scenario.motion.beyond) / scenario.motion.speed / step;
  cost.coreSeconds = kBesideRolling * cost.steps * static_cast<double>(cost.elements) / kUpdatesPerSecond;
  cost.bytes = kBytes + kStateOfAnElement * static_cast<double>(cost.elements);
  return cost;
}

CostEstimate costOfARun(const StudyDefinition& definition, const cases::CaseOverrides& overrides) {
  for (const auto& point : gridOf(definition)) {
    try {
      return costOf(caseAt(definition, overrides, point));
    } catch (const CaseError&) {
      // a failed row of the table
    }
  }
  return {};
}

}  // namespace squat::studies
