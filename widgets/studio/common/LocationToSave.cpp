#include "studio/common/LocationToSave.h"

#include <QFileDialog>

namespace squat::studio {

QString locationToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& kinds) {
  QFileDialog dialog(parent, title, QString(), kinds);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  const auto takeEnding = [&dialog](const QString& kind) {
    dialog.setDefaultSuffix(kind.section("*.", 1, 1).section(')', 0, 0));
  };
  takeEnding(dialog.selectedNameFilter());
  QObject::connect(&dialog, &QFileDialog::filterSelected, takeEnding);
  dialog.selectFile(proposed);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace squat::studio
