#include "studio/profile/EditedDefect.h"

#include <utility>

#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "studio/document/CaseDocument.h"

namespace squat::studio {

EditedDefect::EditedDefect(CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {
  hadBothSides_ = hasBothSides();
  connect(&document_, &CaseDocument::changed, this, &EditedDefect::take);
  connect(&document_, &CaseDocument::replaced, this, [this] {  // another case is first seen as a half model would be
    if (std::exchange(side_, Side::left) == Side::right) Q_EMIT changed();
    Q_EMIT replaced();
  });
}

bool EditedDefect::hasBothSides() const { return document_.description().extent == scenario::ModelExtent::whole; }

// A case may become half while its right side is shown.
void EditedDefect::take() {
  const bool isOtherSide = !hasBothSides() && std::exchange(side_, Side::left) == Side::right;
  if (std::exchange(hadBothSides_, hasBothSides()) != hasBothSides()) Q_EMIT sidesChanged();
  Q_EMIT changed();
  if (isOtherSide) Q_EMIT replaced();
}

void EditedDefect::show(Side side) {
  if (side == side_ || !hasBothSides()) return;
  side_ = side;
  Q_EMIT changed();
  Q_EMIT replaced();
}

const cases::CaseDescription& EditedDefect::description() const {
  return side_ == Side::right ? document_.right() : document_.description();
}

void EditedDefect::edit(const QString& what, const cases::CaseDescription& after, int gesture) {
  if (side_ == Side::left) return document_.edit(what, after, gesture);
  cases::CaseDescription both = document_.description();
  for (const auto& parameter : cases::parameterTable()) {
    if (parameter.group != "defect" || !cases::mayDiffer(parameter.key)) continue;
    const std::string text = cases::valueText(after, parameter);
    if (text == cases::valueText(document_.right(), parameter)) continue;
    if (const auto problem = cases::trySetRight(both, parameter.key, text)) return refuse(*problem);
  }
  document_.edit(tr("%1, right side").arg(what), both, gesture);
}

void EditedDefect::setParameter(const std::string& key, const std::string& text) {
  const std::string ofSide = side_ == Side::right ? std::string(cases::rightGroup) + "." + key : key;
  if (const auto problem = document_.setParameter(ofSide, text)) refuse(*problem);
}

// Sliders, numbers and curves that are ahead of the case go back to what it says.
void EditedDefect::refuse(const CaseProblem& problem) {
  Q_EMIT changed();
  Q_EMIT refused(tr("The case stays as it is: %1").arg(QString::fromStdString(toText(problem))));
}

int EditedDefect::newGesture() { return document_.newGesture(); }

}  // namespace squat::studio
