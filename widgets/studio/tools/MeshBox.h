// widgets/studio/tools/MeshBox.h - a choice among the mesh presets.
#pragma once

#include <QComboBox>

#include "case/ParameterTable.h"

namespace squat::studio {

inline QComboBox* meshBox(const QString& label, const QString& name, const QString& chosen, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setAccessibleName(label);
  for (const auto& choice : cases::findParameter("mesh.preset")->choices) box->addItem(QString::fromStdString(choice));
  box->setCurrentText(chosen);
  return box;
}

}  // namespace squat::studio
