#include "studio/document/ShownCase.h"

#include <QObject>
#include <QStringList>

#include "case/CaseNames.h"
#include "case/Resolve.h"

namespace squat::studio {

QString differenceOfCases(const results::RunResult* result, const cases::CaseDescription& open) {
  if (!result || result->caseToml.empty()) return {};
  if (!result->resolvedCase) return QObject::tr("its case cannot be read by this version");
  const auto shown = cases::comparedCase(result->resolvedCase->description), edited = cases::comparedCase(open);
  QStringList keys;
  for (const std::size_t row : cases::differingRows({&shown, &edited}))
    keys << QString::fromStdString(cases::comparedKey(row));
  if (keys.isEmpty()) return {};
  constexpr int named = 3;
  const auto more = keys.size() - named;
  QString text = keys.mid(0, named).join(", ");
  if (more > 0) text += QObject::tr(" and %1 more").arg(more);
  return keys.size() == 1 ? QObject::tr("%1 differs").arg(text) : QObject::tr("%1 differ").arg(text);
}

}  // namespace squat::studio
