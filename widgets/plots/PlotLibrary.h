// widgets/plots/PlotLibrary.h - QCustomPlot, whose header needs Qt's keywords; they end with it, because "signals" is
// a word of this program (compiled with QT_NO_KEYWORDS).
#pragma once

#include <QtCore>

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define emit Q_EMIT
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef emit
#undef foreach
