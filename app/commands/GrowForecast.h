// app/commands/GrowForecast.h - many growths with inputs between limits, and what they say together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/CaseOptions.h"
#include "growth/Forecast.h"
#include "studies/StudyGrid.h"

namespace squat::commands {

struct ForecastRequest {
  std::vector<std::string> uncertain;  // KEY=LOW:HIGH
  int growths = 8;
};

// Which growths: read before anything is computed. Throws CaseError for keys and limits that cannot be.
studies::StudyDefinition forecastStudy(const CaseOptions& options, const ForecastRequest& request,
                                       const growth::GrowthOptions& growth);

// In `folder` a table has the depths of each growth; those that stand there are not computed again. Nothing where it
// was cancelled.
std::optional<growth::Forecast> forecastGrowth(const CaseOptions& options, const studies::StudyDefinition& study,
                                               const growth::GrowthOptions& growth, const std::string& folder,
                                               Monitor& monitor);

}  // namespace squat::commands
