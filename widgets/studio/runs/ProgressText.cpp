#include "studio/runs/ProgressText.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "analysis/WheelForces.h"
#include "signals/SignalCatalogue.h"

namespace squat::studio {

QString durationText(double seconds) {
  if (!(seconds >= 0) || seconds > 1e7) return QObject::tr("unknown");
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return QObject::tr("%1 s").arg(whole);
  if (whole < 3600) return QObject::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  return QObject::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

QString progressText(const Progress& progress) {
  const QString phase = QString::fromStdString(progress.phase).replace('_', ' ');
  QString text = QObject::tr("%1 %2 %").arg(phase).arg(100 * progress.fraction, 0, 'f', 0);
  if (progress.remainingSeconds >= 0) text += QObject::tr(", %1 left").arg(durationText(progress.remainingSeconds));
  return text;
}

QString completionText(const results::RunResult& result, bool resumed) {
  QStringList found;
  const auto* box = result.signal(signals::names::axleBoxFiltered);
  if (box && !box->empty()) {
    const auto [low, high] = std::minmax_element(box->begin(), box->end());
    found << QObject::tr("axle box acceleration %1 to %2 m/s²").arg(*low, 0, 'f', 1).arg(*high, 0, 'f', 1);
  }
  const auto* force = result.signal(signals::names::contactForce);
  if (force && !force->empty())
    found << QObject::tr("contact force up to %1 kN")
                 .arg(1e-3 * *std::max_element(force->begin(), force->end()), 0, 'f', 1);
  if (const auto wheels = analysis::wheelForces(result); wheels.size() > 1)
    for (const auto& one : wheels)
      if (one.liftOff)
        found << QObject::tr("the %1 lifts off at %2 ms")
                     .arg(QString::fromStdString(one.wheel))
                     .arg(1e3 * *one.liftOff, 0, 'f', 1);
  const auto seconds = std::find_if(result.performance.begin(), result.performance.end(),
                                    [](const results::Scalar& scalar) { return scalar.name == "seconds"; });
  const QString done = seconds == result.performance.end()
                           ? QObject::tr("Done")
                           : (resumed ? QObject::tr("Done, %1 after it was resumed") : QObject::tr("Done in %1"))
                                 .arg(durationText(seconds->value));
  return found.isEmpty() ? done + "." : done + ": " + found.join(", ") + ".";
}

}  // namespace squat::studio
