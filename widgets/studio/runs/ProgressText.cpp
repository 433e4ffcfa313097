#include "studio/runs/ProgressText.h"

#include <QObject>
#include <cmath>

namespace squat::studio {

QString durationText(double seconds) {
  if (!(seconds >= 0) || seconds > 1e7) return QObject::tr("unknown");
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return QObject::tr("%1 s").arg(whole);
  if (whole < 3600) return QObject::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  return QObject::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

QString progressText(const Progress& progress) {
  QString phase = QString::fromStdString(progress.phase);
  if (!phase.contains('=')) phase.replace('_', ' ');  // a run of a study is called by its keys
  QString text = QObject::tr("%1 %2 %").arg(phase).arg(100 * progress.fraction, 0, 'f', 0);
  if (progress.remainingSeconds >= 0) text += QObject::tr(", %1 left").arg(durationText(progress.remainingSeconds));
  return text;
}

}  // namespace squat::studio
