// solver/growth/ComputeForecast.h - many growths with inputs between limits, and what they say together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/CaseFile.h"
#include "core/Monitor.h"
#include "growth/Forecast.h"
#include "studies/StudyGrid.h"

namespace squat::growth {

struct ForecastRequest {
  std::vector<std::string> uncertain;  // KEY=LOW:HIGH
  int growths = 8;
};

// Everything that determines a forecast.
struct ForecastPlan {
  studies::StudyDefinition study;
  cases::CaseOverrides overrides;
  GrowthOptions growth;
  std::string folder;         // of the table of growths
  int jobs = 1, threads = 1;  // growths at once, and threads of each
};

// Looks at the request and at what stands in the folder before anything is computed. Throws CaseError for keys and
// limits that cannot be, and for a folder with the table of another forecast; FileError.
ForecastPlan forecastPlan(const std::string& caseName, const cases::CaseOverrides& overrides,
                          const ForecastRequest& request, const GrowthOptions& growth, const std::string& folder);

// Growths whose depths stand in the table are not computed again, failed ones are. Nothing where it was cancelled.
std::optional<Forecast> forecastGrowth(const ForecastPlan& plan, Monitor& monitor);

}  // namespace squat::growth
