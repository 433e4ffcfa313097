#include "studio/document/OtherUnits.h"

#include <QObject>

#include "case/RightSide.h"
#include "scenario/WheelsetMass.h"

namespace squat::studio {
namespace {

// [kg] on both rails: a case describes one wheel and what it carries, and that of the right side where it differs.
double axleLoad(const cases::CaseDescription& description) {
  const double left = description.suspension.sprungMass;
  const bool isWhole = description.extent == cases::ModelExtent::whole;
  const double right = isWhole ? cases::rightOf(description).suspension.sprungMass : left;
  return left + right + 2 * scenario::wheelsetMass(description.wheelset);
}

}  // namespace

QString inOtherUnits(const cases::CaseDescription& description, const std::string& key) {
  constexpr double kilometresPerHour = 3.6;  // of 1 m/s
  if (key == "motion.speed")
    return QObject::tr("= %1 km/h").arg(kilometresPerHour * description.motion.speed, 0, 'g', 4);
  if (key != "suspension.sprung_mass" && key != "wheelset.total_mass") return {};
  const double mass = axleLoad(description);
  return QObject::tr("axle load %1 t (%2 kN)")
      .arg(mass * 1e-3, 0, 'f', 1)
      .arg(mass * description.motion.gravity * 1e-3, 0, 'f', 0);
}

}  // namespace squat::studio
