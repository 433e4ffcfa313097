#include "studio/common/ErrorText.h"

#include <QObject>
#include <QStringList>
#include <new>

namespace squat::studio {

ErrorText errorText(const std::exception_ptr& error, const QString& what) {
  const QString failed = QObject::tr("%1 failed: %2").arg(what);
  try {
    std::rethrow_exception(error);
  } catch (const CaseError& wrong) {
    QStringList lines;
    for (const auto& problem : wrong.problems()) lines << QString::fromStdString(toText(problem));
    return {QObject::tr("Invalid case: %1").arg(lines.value(0)), lines.join('\n'), wrong.problems()};
  } catch (const RunError& failure) {
    return {failed.arg(QString::fromStdString(failure.what())),
            QObject::tr("step %1, %2 ms, %3")
                .arg(failure.step())
                .arg(failure.time() * 1e3, 0, 'g', 6)
                .arg(QString::fromStdString(failure.location())),
            {}};
  } catch (const std::bad_alloc&) {
    return {failed.arg(QObject::tr("not enough memory. Choose a coarser mesh or a shorter track.")), {}, {}};
  } catch (const std::exception& other) {
    return {failed.arg(QString::fromStdString(other.what())), {}, {}};
  }
}

}  // namespace squat::studio
