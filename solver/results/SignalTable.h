// solver/results/SignalTable.h - the signals of a run as CSV: one header line `time [s],position [m],aba [m/s2],...`,
// comma between columns, point as decimal sign in every locale, shortest digits that give the same double back.
#pragma once

#include <string>

#include "results/RunResult.h"

namespace squat::results {

std::string signalTable(const RunResult& result);
void writeSignalTable(const std::string& path, const RunResult& result);  // durable; FileError

}  // namespace squat::results
