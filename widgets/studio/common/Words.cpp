#include "studio/common/Words.h"

#include <QRegularExpression>

#include "case/CaseNames.h"
#include "case/InputPresets.h"

namespace squat::studio {

QString parameterLabel(const std::string& key) {
  // "Preset" below "Wheelset" or "Mesh" says little to who has not read the manual.
  if (key == "mesh.preset") return QObject::tr("Fineness");
  if (cases::isInputPreset(key)) return QObject::tr("Set of values");
  QString label = QString::fromStdString(cases::printedWords(key.substr(key.find('.') + 1)));
  if (!label.isEmpty()) label[0] = label[0].toUpper();
  return label;
}

QString printedUnits(QString text) {
  static const QRegularExpression microseconds("\\bus\\b"), micrometres("\\bum\\b");
  text.replace("m/s2", "m/s²").replace("kg/m3", "kg/m³").replace("kg m2", "kg m²");
  return text.replace(microseconds, "µs").replace(micrometres, "µm");
}

QString machineName(const QString& legend) {
  static const QRegularExpression remark("\\s*\\([^)]*\\)\\s*$"), other("[^a-z0-9]+"), edge("^_+|_+$");
  return QString(legend).remove(remark).toLower().replace(other, "_").remove(edge);
}

QString columnName(const QString& axisLabel) {
  const QString quantity = axisLabel.section('[', 0, 0).trimmed();
  QString unit = axisLabel.section('[', 1).section(']', 0, 0);
  unit.replace("²", "2").replace("³", "3").replace("µ", "u").replace("·", " ");
  QString name = machineName(quantity);
  for (const char* word :
       {"position", "time", "frequency", "acceleration", "force", "pressure", "height", "power", "psd"})
    if (quantity.contains(word, Qt::CaseInsensitive)) {
      name = word;
      break;
    }
  return unit.isEmpty() ? name : name + " [" + unit + "]";
}

}  // namespace squat::studio
