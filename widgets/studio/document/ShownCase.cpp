#include "studio/document/ShownCase.h"

#include <QObject>
#include <QStringList>
#include <exception>

#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"

namespace squat::studio {
namespace {

// What a case is called, and the file that its points are from, change no result.
bool counts(const std::string& key) {
  return key != "title" && key != "note" && key != "defect.file" && !cases::isInputPreset(key);
}

}  // namespace

QString differenceOfCases(const results::RunResult* result, const cases::CaseDescription& open) {
  if (!result || result->caseToml.empty()) return {};
  if (!result->resolvedCase) return QObject::tr("its case cannot be read by this version");
  QStringList keys;
  for (const auto& parameter : cases::parameterTable())
    if (counts(parameter.key) &&
        cases::valueText(result->resolvedCase->description, parameter) != cases::valueText(open, parameter))
      keys << QString::fromStdString(parameter.key);
  if (keys.isEmpty()) return {};
  constexpr int named = 3;
  const auto more = keys.size() - named;
  QString text = keys.mid(0, named).join(", ");
  if (more > 0) text += QObject::tr(" and %1 more").arg(more);
  return keys.size() == 1 ? QObject::tr("%1 differs").arg(text) : QObject::tr("%1 differ").arg(text);
}

}  // namespace squat::studio
