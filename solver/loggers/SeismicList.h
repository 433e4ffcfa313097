// solver/loggers/SeismicList.h - text in which every line holds several samples of one channel, one after the other
// ("SLIST", as seismic networks and their recorders write it).
#pragma once

#include <string>
#include <string_view>

#include "loggers/LoggerTable.h"

namespace squat::loggers {

// Begins with a heading such as "TIMESERIES XX_ABA1__HNZ_R, 15360 samples, 25600.0 sps, 2024-05-03T10:15:00.000000,
// SLIST, INTEGER, Counts".
bool isSeismicList(std::string_view head);

// The channel of the first heading; stretches of the same channel follow on each other, other channels of the same
// length and rate stand beside it. What is left out is noted. Throws FileError.
LoggerTable readSeismicList(const std::string& path);
LoggerTable parseSeismicList(std::string_view bytes, const std::string& path);

}  // namespace squat::loggers
