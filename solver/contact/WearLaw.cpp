#include "contact/WearLaw.h"

#include "scenario/Scenario.h"

namespace squat::contact {

namespace {

// Twin discs of wheel steel R8T on rail steel UIC60 900A (R. Lewis, U. Olofsson, Wear 257, 2004; F. Braghin et al.,
// Wear 261, 2006): micrograms per metre rolled and mm2 of contact over T gamma / A in N/mm2,
//   5.3 T gamma / A up to 10.4, 55 up to 77.2, 55 + 61.9 (T gamma / A - 77.2) beyond.
constexpr double perMicrogram = 1e-9 / 1e-6 / 1e6;  // kg / (m m2) over Pa
constexpr double mild = 5.3, catastrophic = 61.9, mildLimit = 10.4e6, severeLimit = 77.2e6;

}  // namespace

WearLaw wearLawOf(const scenario::Scenario& scenario) {
  const auto& growth = scenario.growth;
  WearLaw law;
  switch (growth.wear) {
    case scenario::WearModel::none:
      break;
    case scenario::WearModel::archard:
      if (scenario.contact.friction > 0)
        law.slope = growth.wearCoefficient / (scenario.contact.friction * growth.hardness);
      break;
    case scenario::WearModel::tGamma: {
      const double perDensity = perMicrogram / scenario.rail.material.density;
      law = {mild * perDensity, mildLimit, severeLimit, catastrophic * perDensity};
      break;
    }
  }
  return law;
}

}  // namespace squat::contact
